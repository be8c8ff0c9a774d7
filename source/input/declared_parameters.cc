#include <signorini/input/declared_parameters.h>

// Boost 1.74 would print a notice about its own placeholders otherwise.
#define BOOST_BIND_GLOBAL_PLACEHOLDERS
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <algorithm>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // A handler keeps names with _XX, the hexadecimal code, in place of what
    // is no letter or digit.
    std::string
    original_name(const std::string &kept)
    {
      std::string name;
      for (std::size_t i = 0; i < kept.size(); ++i)
        if (kept[i] != '_')
          name += kept[i];
        else
          {
            name += static_cast<char>(
              std::stoi(kept.substr(i + 1, 2), nullptr, /*base=*/16));
            i += 2;
          }
      return name;
    }



    DeclaredSection
    section_of(const boost::property_tree::ptree &tree)
    {
      DeclaredSection section;
      for (const auto &[kept, child] : tree)
        {
          const std::string name    = original_name(kept);
          const auto        pattern = child.find("pattern_description");
          const auto        alias   = child.find("alias");
          if (pattern != child.not_found() && pattern->second.empty())
            section.entries.push_back(
              {name,
               pattern->second.data(),
               child.get<std::string>("value"),
               child.get<std::string>("default_value"),
               child.get<std::string>("documentation")});
          else if (alias != child.not_found() && alias->second.empty())
            {
              // An alias follows the entry it stands for.
              const DeclaredSection::Entry *original =
                section.find_entry(alias->second.data());
              section.entries.push_back(
                original == nullptr ? DeclaredSection::Entry() : *original);
              section.entries.back().name = name;
            }
          else
            section.sections.emplace_back(name, section_of(child));
        }
      return section;
    }
  } // namespace



  const DeclaredSection::Entry *
  DeclaredSection::find_entry(const std::string &name) const
  {
    const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const Entry &entry) {
        return entry.name == name;
      });
    return found == entries.end() ? nullptr : &*found;
  }



  const DeclaredSection *
  DeclaredSection::find_section(const std::string &name) const
  {
    const auto found =
      std::find_if(sections.begin(), sections.end(), [&](const auto &section) {
        return section.first == name;
      });
    return found == sections.end() ? nullptr : &found->second;
  }



  std::vector<std::string>
  DeclaredSection::entry_names() const
  {
    std::vector<std::string> names;
    for (const Entry &entry : entries)
      names.push_back(entry.name);
    return names;
  }



  std::vector<std::string>
  DeclaredSection::section_names() const
  {
    std::vector<std::string> names;
    for (const auto &section : sections)
      names.push_back(section.first);
    return names;
  }



  DeclaredSection
  declared_parameters(const ParameterHandler &prm)
  {
    // The XML output is the only complete view of its tree that a handler
    // offers in 9.4; JSON breaks names at their dots.
    std::stringstream xml;
    prm.print_parameters(xml,
                         ParameterHandler::XML |
                           ParameterHandler::KeepDeclarationOrder);
    boost::property_tree::ptree tree;
    boost::property_tree::read_xml(xml, tree);
    return section_of(tree.get_child("ParameterHandler"));
  }
} // namespace Signorini
