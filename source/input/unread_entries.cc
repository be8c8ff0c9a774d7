#include <signorini/input/declared_parameters.h>
#include <signorini/input/input_error.h>
#include <signorini/input/named_list.h>
#include <signorini/input/unread_entries.h>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Path = std::vector<std::string>;

    Path
    operator+(Path section, const Path &rest)
    {
      section.insert(section.end(), rest.begin(), rest.end());
      return section;
    }

    std::string
    joined(const Path &path)
    {
      std::string text;
      for (const std::string &name : path)
        text += (text.empty() ? "" : "/") + name;
      return text;
    }

    // "0" and "0." are the same.
    bool
    are_equal(const std::string &a, const std::string &b)
    {
      if (a == b)
        return true;
      char        *end_a = nullptr, *end_b = nullptr;
      const double value_a = std::strtod(a.c_str(), &end_a);
      const double value_b = std::strtod(b.c_str(), &end_b);
      return end_a == a.c_str() + a.size() && end_b == b.c_str() + b.size() &&
             !a.empty() && !b.empty() && value_a == value_b;
    }

    // The file of "prm/beam.prm:12".
    std::string
    file_of(const std::string &origin)
    {
      return origin.substr(0, origin.rfind(':'));
    }

    class Search
    {
    public:
      Search(const ParameterFile    &file,
             const ParameterHandler &prm,
             const ParameterHandler &defaults)
        : file(file)
        , prm(prm)
        , defaults(defaults)
        , top(declared_parameters(prm))
        , assignments(file.assignments())
      {}

      void
      apply(const ConditionList::Item &item);

      std::vector<std::string> errors;
      std::vector<std::string> warnings;

    private:
      // An entry as it stands, the innermost section last.
      struct Found
      {
        Path                   path;
        EntryCondition::Choice choice;
      };

      const DeclaredSection *
      section_at(const Path &path) const;

      Found
      value_at(const Path &path) const;

      // What a choice may be for a section: as it stands there or around it,
      // and as sections inside of that have it for themselves.
      std::vector<Found>
      choices(const Path &section, const std::string &choice) const;

      void
      add_inner_choices(const Path         &section,
                        const Path         &choice,
                        std::vector<Found> &found) const;

      // Whether all of it is set, to its defaults: a list of all entries, as
      // the program prints it, and no mistake.
      bool
      is_list_of_defaults(const Path &section) const;

      // The first place where a name is set to something else than its
      // default; a subsection: where anything is set in it.
      std::string
      origin(const Path &section, const std::string &name) const;

      const ParameterFile                  &file;
      const ParameterHandler               &prm;
      const ParameterHandler               &defaults;
      const DeclaredSection                 top;
      const std::vector<ParameterStatement> assignments;
      std::set<std::string>                 reported;
    };



    const DeclaredSection *
    Search::section_at(const Path &path) const
    {
      const DeclaredSection *section = &top;
      for (const std::string &name : path)
        if (section)
          section = section->find_section(name);
      return section;
    }



    Search::Found
    Search::value_at(const Path &path) const
    {
      const Path        section(path.begin(), path.end() - 1);
      const std::string value = prm.get(section, path.back());
      return {path,
              {value, are_equal(value, defaults.get(section, path.back()))}};
    }



    void
    Search::add_inner_choices(const Path         &section,
                              const Path         &choice,
                              std::vector<Found> &found) const
    {
      for (const auto &[name, inner] : section_at(section)->sections)
        {
          const Path path = section + Path{name};
          if (choice.size() == 1 && inner.find_entry(choice[0]) != nullptr)
            {
              const Found value = value_at(path + choice);
              if (!value.choice.is_default)
                found.push_back(value);
            }
          add_inner_choices(path, choice, found);
        }
    }



    std::vector<Search::Found>
    Search::choices(const Path &section, const std::string &choice) const
    {
      const Path names = split_list(choice, '/');
      const Path inside(names.begin(), names.end() - 1);
      for (Path around = section;; around.pop_back())
        {
          const DeclaredSection *const place = section_at(around + inside);
          if (place != nullptr && place->find_entry(names.back()) != nullptr)
            {
              const Found found = value_at(around + names);
              // An empty entry of a pair means that of all pairs.
              if (found.choice.is_default && !around.empty() &&
                  around.back().rfind("Pair ", 0) == 0)
                continue;
              std::vector<Found> list = {found};
              if (around == section)
                add_inner_choices(around, names, list);
              return list;
            }
          if (around.empty())
            {
              std::vector<Found> list;
              add_inner_choices(around, names, list);
              return list;
            }
        }
    }



    bool
    Search::is_list_of_defaults(const Path &section) const
    {
      const DeclaredSection &declared = *section_at(section);
      return std::all_of(declared.entries.begin(),
                         declared.entries.end(),
                         [&](const DeclaredSection::Entry &entry) {
                           const Path path = section + Path{entry.name};
                           return file.where(joined(path)) != "default" &&
                                  value_at(path).choice.is_default;
                         }) &&
             std::all_of(declared.sections.begin(),
                         declared.sections.end(),
                         [&](const auto &inner) {
                           return is_list_of_defaults(section +
                                                      Path{inner.first});
                         });
    }



    std::string
    Search::origin(const Path &section, const std::string &name) const
    {
      const Path path = section + Path{name};
      if (section_at(path) != nullptr && is_list_of_defaults(path))
        return "";
      for (const ParameterStatement &statement : assignments)
        {
          const Path whole = statement.section + Path{statement.entry};
          if (whole.size() < path.size() ||
              !std::equal(path.begin(), path.end(), whole.begin()))
            continue;
          if (whole.size() > path.size())
            return file.where(joined(path)) == "default" ?
                     statement.origin :
                     file.where(joined(path));
          if (!value_at(path).choice.is_default)
            return statement.origin;
        }
      return "";
    }



    void
    Search::apply(const ConditionList::Item &item)
    {
      const EntryCondition &condition = item.condition;
      const auto            found     = choices(item.section, condition.choice);
      if (std::any_of(found.begin(), found.end(), [&](const Found &place) {
            return condition.is_read(place.choice);
          }))
        return;
      const std::string value =
        found.empty() || found[0].choice.value.empty() ?
          " is not set" :
          " = " + found[0].choice.value +
            (file.where(joined(found[0].path)) == "default" ? " by default" :
                                                              "");
      for (const std::string &name : condition.names)
        {
          const std::string place = origin(item.section, name);
          const Path        path  = item.section + Path{name};
          if (place.empty() || !reported.insert(joined(path)).second)
            continue;
          const std::string decided =
            found.empty() ? "default" : file.where(joined(found[0].path));
          const bool is_error =
            condition.contradicts &&
            (decided == "default" || file_of(decided) == file_of(place));
          (is_error ? errors : warnings)
            .push_back(
              place + ": " + section_in_words(path) +
              ": has no effect, since " +
              condition.choice.substr(condition.choice.rfind('/') + 1) + value +
              ". " + condition.remedy + ", or remove it.");
        }
    }
  } // namespace



  void
  ConditionList::add(const std::vector<std::string> &section,
                     const EntryConditions          &conditions)
  {
    for (const EntryCondition &condition : conditions)
      items.push_back({section, condition});
  }



  std::vector<std::string>
  warnings_of_unread_entries(const ParameterFile    &file,
                             const ConditionList    &conditions,
                             const ParameterHandler &prm,
                             const ParameterHandler &defaults)
  {
    Search search(file, prm, defaults);
    for (const auto &item : conditions.items)
      search.apply(item);
    std::string message;
    for (const std::string &error : search.errors)
      message += (message.empty() ? "" : "\n") + error;
    if (!message.empty())
      throw InputError(message);
    return search.warnings;
  }
} // namespace Signorini
