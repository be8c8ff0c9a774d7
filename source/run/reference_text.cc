#include <signorini/input/nearest_name.h>
#include <signorini/input/parameter_statements.h>
#include <signorini/input/pattern_in_words.h>
#include <signorini/run/reference_text.h>

#include <algorithm>

namespace Signorini
{
  namespace
  {
    const std::string introduction =
      "Every entry of a `.prm' with default, unit, allowed values and meaning. "
      "2-D is plane strain, plane stress and axisymmetric, 3-D `Formulation = "
      "three dimensional'. NAME and PAIR stand for what a problem calls its bodies, regions and pairs.";

    const std::string origin =
      "This page is written by `signorini --write-reference FOLDER', and so are "
      "its sketches and, for editors, the entries as XML and JSON: `parameters_"
      "2d.xml', `parameters_3d.xml', `parameters_2d.json', `parameters_3d.json'.";

    // The chapter of the manual that tells of a section and those inside it.
    std::string
    chapter(const std::vector<std::string> &path)
    {
      static const std::map<std::string, std::string> chapters = {
        {"", "getting_started.md#a-problem-is-a-prm-file"},
        {"Adaptivity", "adaptivity_and_submodels.md"},
        {"Body NAME", "meshes.md"},
        {"Body NAME / Loads", "materials.md#loads"},
        {"Body NAME / Material", "materials.md"},
        {"Body NAME / Material NAME", "materials.md"},
        {"Body NAME / Supports", "getting_started.md#a-problem-is-a-prm-file"},
        {"Contact", "contact.md"},
        {"Expected results", "output.md#expected-results"},
        {"Output", "output.md"},
        {"Rigid body NAME", "contact.md#rigid-bodies"},
        {"Time", "time.md"}};
      auto around = path;
      while (chapters.count(section_in_words(around)) == 0)
        around.pop_back();
      return "../manual/" + chapters.at(section_in_words(around));
    }

    std::string
    title_of(const std::vector<std::string> &path)
    {
      return path.empty() ? "Top of the file" : section_in_words(path);
    }

    std::string
    dimensions(const bool is_in_2d, const bool is_in_3d)
    {
      return is_in_2d && is_in_3d ? "2-D, 3-D" : is_in_2d ? "2-D" : "3-D";
    }



    /** Says a thing once, or for both dimensions if they differ. */
    std::string
    for_both(const std::string &in_2d, const std::string &in_3d)
    {
      const bool is_sentence = !in_2d.empty() && in_2d.back() == '.';
      return in_2d == in_3d ?
               in_2d :
               "2-D: " + in_2d + (is_sentence ? "" : ";") + " 3-D: " + in_3d;
    }

    template <typename Text>
    std::string
    for_both(const ReferenceEntry &entry, const Text &text)
    {
      if (!entry.in_2d)
        return text(*entry.in_3d);
      if (!entry.in_3d)
        return text(*entry.in_2d);
      return for_both(text(*entry.in_2d), text(*entry.in_3d));
    }

    // "Set Law = elastic" becomes "Only if you set Law = elastic."
    std::string
    condition(const std::vector<std::string> &remedies)
    {
      std::string text;
      for (std::string remedy : remedies)
        {
          remedy[0] = std::tolower(static_cast<unsigned char>(remedy[0]));
          text += (text.empty() ? "Only if you " : " and ") + remedy;
        }
      return text.empty() ? "" : text + ".";
    }

    std::string
    condition(const Remedies &remedies,
              const bool      is_in_2d,
              const bool      is_in_3d)
    {
      if (!is_in_2d)
        return condition(remedies.in_3d);
      if (!is_in_3d)
        return condition(remedies.in_2d);
      return for_both(condition(remedies.in_2d), condition(remedies.in_3d));
    }

    // "../manual/a_b.md#c" becomes "a b".
    std::string
    page_of(const std::string &target)
    {
      const auto  begin = target.rfind('/') + 1;
      std::string page  = target.substr(begin, target.find(".md") - begin);
      std::replace(page.begin(), page.end(), '_', ' ');
      return page;
    }



    /** Writes the document piece by piece. */
    class Writer
    {
    public:
      Writer(const std::vector<ReferenceSection> &sections,
             const BoundarySketches              &sketches,
             const TextFormat                    &format)
        : sections(sections)
        , sketches(sketches)
        , format(format)
      {}

      std::string
      document() const
      {
        std::string text = format.begin("Reference of all entries") +
                           format.paragraph(format.text(introduction)) +
                           format.paragraph(format.text(origin)) + contents();
        for (const ReferenceSection &section : sections)
          text += chapter_of(section);
        return text + format.end();
      }

    private:
      std::string
      link_to(const ReferenceSection &section) const
      {
        const std::string title = title_of(section.path);
        return format.link(format.text(title), "#" + TextFormat::anchor(title));
      }

      std::string
      contents() const
      {
        std::vector<std::string> items;
        for (const ReferenceSection &section : sections)
          items.push_back(link_to(section));
        return format.list(items);
      }

      // The first section with these entries, or the section itself.
      const ReferenceSection &
      first_like(const ReferenceSection &section) const
      {
        return *std::find_if(sections.begin(),
                             sections.end(),
                             [&](const ReferenceSection &other) {
                               return have_same_entries(other, section);
                             });
      }

      std::string
      summary(const ReferenceSection &section) const;

      std::string
      chapter_of(const ReferenceSection &section) const;

      std::vector<std::string>
      row(const ReferenceSection &section, const ReferenceEntry &entry) const;

      std::string
      drawn(const BoundarySketch &sketch) const;

      const std::vector<ReferenceSection> &sections;
      const BoundarySketches              &sketches;
      const TextFormat                    &format;
    };



    std::vector<std::string>
    Writer::row(const ReferenceSection &section,
                const ReferenceEntry   &entry) const
    {
      const auto value = [&](const DeclaredSection::Entry &e) {
        return format.code(e.default_value);
      };
      const auto unit = [&](const DeclaredSection::Entry &e) {
        return format.text(split_unit(e.documentation).unit);
      };
      const auto allowed = [&](const DeclaredSection::Entry &e) {
        return format.text(pattern_in_words(e.pattern));
      };
      const auto meaning = [&](const DeclaredSection::Entry &e) {
        return format.text(split_unit(e.documentation).text);
      };
      const bool        is_in_2d = entry.in_2d.has_value();
      const bool        is_in_3d = entry.in_3d.has_value();
      const std::string only = condition(entry.remedies, is_in_2d, is_in_3d);
      const std::string id =
        TextFormat::anchor(title_of(section.path) + " / " + entry.name);
      return {format.target(id, format.text(entry.name)),
              for_both(entry, value),
              for_both(entry, unit),
              for_both(entry, allowed),
              dimensions(is_in_2d, is_in_3d),
              for_both(entry, meaning) +
                (only.empty() ? "" : " " + format.text(only))};
    }



    std::string
    Writer::drawn(const BoundarySketch &sketch) const
    {
      return format.paragraph(
               format.text("Boundaries, " + sketch.caption + ": " +
                           comma_separated(sketch.boundaries) + ".")) +
             format.image(sketch.file, sketch.caption);
    }



    std::string
    Writer::summary(const ReferenceSection &section) const
    {
      const std::string target = chapter(section.path);
      const std::string only =
        condition(section.remedies, section.is_in_2d, section.is_in_3d);
      return format.paragraph(
        dimensions(section.is_in_2d, section.is_in_3d) + ". " +
        (only.empty() ? "" : format.text(only) + " ") +
        "In the manual: " + format.link(page_of(target), target) + ".");
    }



    std::string
    Writer::chapter_of(const ReferenceSection &section) const
    {
      std::string text =
        format.heading(2, title_of(section.path)) + summary(section);
      const ReferenceSection &like = first_like(section);
      if (section.entries.empty())
        return text;
      if (&like != &section)
        return text + format.paragraph("The entries are those of " +
                                       link_to(like) + ".");
      std::vector<std::vector<std::string>> rows = {
        {"entry", "default", "unit", "allowed", "in", "meaning"}};
      for (const ReferenceEntry &entry : section.entries)
        rows.push_back(row(section, entry));
      text += format.table(rows);
      const auto found =
        sketches.find(section.path.empty() ? "" : section.path.back());
      if (found != sketches.end())
        for (const BoundarySketch &sketch : found->second)
          text += drawn(sketch);
      return text;
    }
  } // namespace



  std::string
  reference_text(const std::vector<ReferenceSection> &sections,
                 const BoundarySketches              &sketches,
                 const TextFormat                    &format)
  {
    return Writer(sections, sketches, format).document();
  }
} // namespace Signorini
