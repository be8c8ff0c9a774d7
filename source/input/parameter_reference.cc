#include <signorini/input/parameter_reference.h>

#include <algorithm>
#include <regex>
#include <tuple>

namespace Signorini
{
  namespace
  {
    using Names = std::vector<std::string>;

    // Names of both lists, those of the second one last if they are new.
    Names
    united(Names first, const Names &second)
    {
      for (const std::string &name : second)
        if (std::find(first.begin(), first.end(), name) == first.end())
          first.push_back(name);
      return first;
    }

    Names
    remedies_in(const ConditionList &conditions,
                const Names         &section,
                const std::string   &name)
    {
      Names remedies;
      for (const auto &[place, condition] : conditions.items)
        if (place == section &&
            std::find(condition.names.begin(), condition.names.end(), name) !=
              condition.names.end())
          remedies = united(remedies, {condition.remedy});
      return remedies;
    }

    // The sections at one path, where they are declared.
    struct BothSections
    {
      const DeclaredSection *plane;
      const DeclaredSection *spatial;
    };

    /** Goes through the sections and gathers them. */
    class Walk
    {
    public:
      Walk(const ConditionList &plane, const ConditionList &spatial)
        : plane(plane)
        , spatial(spatial)
      {}

      void
      add(const Names &path, const BothSections &both);

      std::vector<ReferenceSection> sections;

    private:
      Remedies
      remedies(const Names &section, const std::string &name) const
      {
        return {remedies_in(plane, section, name),
                remedies_in(spatial, section, name)};
      }

      ReferenceSection
      section_at(const Names &path, const BothSections &both) const;

      const ConditionList &plane, &spatial;
    };



    std::optional<DeclaredSection::Entry>
    entry_in(const DeclaredSection *section, const std::string &name)
    {
      const DeclaredSection::Entry *const entry =
        section == nullptr ? nullptr : section->find_entry(name);
      return entry == nullptr ? std::nullopt : std::make_optional(*entry);
    }

    Names
    entry_names(const DeclaredSection *section)
    {
      return section == nullptr ? Names() : section->entry_names();
    }

    Names
    section_names(const DeclaredSection *section)
    {
      return section == nullptr ? Names() : section->section_names();
    }

    ReferenceSection
    Walk::section_at(const Names &path, const BothSections &both) const
    {
      ReferenceSection section;
      section.path     = path;
      section.is_in_2d = both.plane != nullptr;
      section.is_in_3d = both.spatial != nullptr;
      if (!path.empty())
        section.remedies =
          remedies(Names(path.begin(), path.end() - 1), path.back());
      for (const std::string &name :
           united(entry_names(both.plane), entry_names(both.spatial)))
        section.entries.push_back({name,
                                   entry_in(both.plane, name),
                                   entry_in(both.spatial, name),
                                   remedies(path, name)});
      return section;
    }

    void
    Walk::add(const Names &path, const BothSections &both)
    {
      sections.push_back(section_at(path, both));
      for (const std::string &name :
           united(section_names(both.plane), section_names(both.spatial)))
        {
          Names inner = path;
          inner.push_back(name);
          add(inner,
              {both.plane == nullptr ? nullptr : both.plane->find_section(name),
               both.spatial == nullptr ? nullptr :
                                         both.spatial->find_section(name)});
        }
    }

    bool
    are_same(const std::optional<DeclaredSection::Entry> &first,
             const std::optional<DeclaredSection::Entry> &second)
    {
      const auto key = [](const DeclaredSection::Entry &entry) {
        return std::tie(entry.name,
                        entry.pattern,
                        entry.default_value,
                        entry.documentation);
      };
      return first.has_value() == second.has_value() &&
             (!first || key(*first) == key(*second));
    }
  } // namespace



  std::vector<ReferenceSection>
  parameter_reference(const DeclaredProblem &plane,
                      const DeclaredProblem &spatial)
  {
    Walk walk(plane.conditions, spatial.conditions);
    walk.add({}, {&plane.parameters, &spatial.parameters});
    return walk.sections;
  }



  bool
  have_same_entries(const ReferenceSection &first,
                    const ReferenceSection &second)
  {
    return std::equal(first.entries.begin(),
                      first.entries.end(),
                      second.entries.begin(),
                      second.entries.end(),
                      [](const ReferenceEntry &a, const ReferenceEntry &b) {
                        return are_same(a.in_2d, b.in_2d) &&
                               are_same(a.in_3d, b.in_3d);
                      });
  }



  TextWithUnit
  split_unit(const std::string &documentation)
  {
    // "Unit: m.", "Unit of the radius: m.", "Units: 1 and Pa."
    static const std::regex unit(
      R"(^([\s\S]*?)\s*Units?(?: of ([^:.]+))?: ([^.]+)\.$)");
    std::smatch found;
    if (!std::regex_match(documentation, found, unit))
      return {documentation, ""};
    return {found[1],
            found[3].str() +
              (found[2].matched ? " (" + found[2].str() + ")" : "")};
  }
} // namespace Signorini
