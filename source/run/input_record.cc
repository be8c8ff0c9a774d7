#include <signorini/input/declared_parameters.h>
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/parameter_statements.h>
#include <signorini/run/input_record.h>

#include <boost/crc.hpp>

#include <algorithm>
#include <array>
#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    void
    add_section(const ParameterHandler         &prm,
                const DeclaredSection          &section,
                const std::vector<std::string> &path,
                std::vector<InputEntry>        &entries)
    {
      const std::string prefix =
        path.empty() ? "" : section_in_words(path) + " / ";
      for (const auto &entry : section.entries)
        entries.push_back({prefix + entry.name, prm.get(path, entry.name)});
      for (const auto &[name, subsection] : section.sections)
        {
          std::vector<std::string> inner = path;
          inner.push_back(name);
          add_section(prm, subsection, inner, entries);
        }
    }

    std::string
    in_words(const std::string &value)
    {
      return value.empty() ? "nothing" : "\"" + value + "\"";
    }

    template <int dim>
    void
    add_point(const Point<dim> &point, boost::crc_32_type &crc)
    {
      for (unsigned int c = 0; c < dim; ++c)
        {
          const double coordinate = point[c];
          crc.process_bytes(&coordinate, sizeof(coordinate));
        }
    }
  } // namespace



  std::vector<InputEntry>
  input_entries(const ParameterHandler &prm)
  {
    std::vector<InputEntry> entries;
    add_section(prm, declared_parameters(prm), {}, entries);
    return entries;
  }



  bool
  may_change_on_resume(const std::string &path)
  {
    // Monitors are columns of the history.
    static const std::array<std::string, 8> list = {
      {"Title",
       "Time / End time",
       "Time / Minimal step size",
       "Time / Maximal step size",
       "Time / Maximal iterations",
       "Time / Iterations of an easy step",
       "Time / Times to meet",
       "Expected results / Checks"}};
    return std::find(list.begin(), list.end(), path) != list.end() ||
           (path.rfind("Output / ", 0) == 0 && path != "Output / Monitor");
  }



  void
  refuse_changed_input(const std::vector<InputEntry> &old_entries,
                       const std::vector<InputEntry> &entries)
  {
    // Entries that only one of them has are of a section that came or went,
    // which the list that names the section tells.
    std::map<std::string, std::string> old_values;
    for (const InputEntry &entry : old_entries)
      old_values[entry.path] = entry.value;
    std::string differences;
    for (const InputEntry &entry : entries)
      {
        const auto old = old_values.find(entry.path);
        if (old == old_values.end() || old->second == entry.value ||
            may_change_on_resume(entry.path))
          continue;
        differences += "\n  " + entry.path + ": " + in_words(entry.value) +
                       ", in the checkpoint " + in_words(old->second);
      }
    if (!differences.empty())
      throw InputError(
        "--resume: the input is not that of the checkpoint:" + differences +
        "\nOnly the End time, limits of the steps, the section Output but for "
        "Monitor, and the Expected results may change. Mend the entries, or "
        "start the run anew without --resume.");
  }



  template <int dim>
  unsigned int
  geometry_checksum(const Problem<dim> &problem)
  {
    boost::crc_32_type crc;
    for (const auto &part : problem.solid->parts())
      for (const auto &node : part.body->nodes())
        add_point(node.point, crc);
    for (const auto &body : problem.rigid_bodies)
      for (const auto &point : body->surface().outline())
        add_point(point, crc);
    return crc.checksum();
  }



#define INSTANTIATE(dim) \
  template unsigned int geometry_checksum(const Problem<dim> &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
