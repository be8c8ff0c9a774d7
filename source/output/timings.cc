#include <signorini/output/timings.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cstdio>

namespace Signorini
{
  namespace
  {
    std::string
    table_row(const std::string &name,
              const int          width,
              const double       seconds,
              const double       total)
    {
      char text[256];
      std::snprintf(text,
                    sizeof(text),
                    "%-*.100s %11.3f s %6.1f %%",
                    width,
                    name.c_str(),
                    seconds,
                    total > 0. ? 100. * seconds / total : 0.);
      return text;
    }
  } // namespace



  Timings::Scope::Scope(Timings &timings, const unsigned int section)
    : timings(timings)
    , outer(timings.running)
  {
    timings.switch_to(section);
    ++timings.sections[section].n_calls;
  }



  Timings::Scope::~Scope()
  {
    timings.switch_to(outer);
  }



  Timings::Timings()
    : sections(1)
    , start(Clock::now())
    , last_switch(start)
  {
    sections[0].name = "other";
  }



  unsigned int
  Timings::add(const std::string &name)
  {
    const Section *section = find(name);
    if (section != nullptr)
      return section - sections.data();
    sections.emplace_back();
    sections.back().name = name;
    return sections.size() - 1;
  }



  Timings::Scope
  Timings::measure(const unsigned int section)
  {
    AssertIndexRange(section, sections.size());
    return Scope(*this, section);
  }



  Timings::Scope
  Timings::measure(const std::string &name)
  {
    return Scope(*this, add(name));
  }



  double
  Timings::seconds(const std::string &name) const
  {
    const Section *section = find(name);
    if (section == nullptr)
      return 0.;
    Clock::duration time = section->time;
    if (section == &sections[running])
      time += Clock::now() - last_switch;
    return std::chrono::duration<double>(time).count();
  }



  unsigned long
  Timings::n_calls(const std::string &name) const
  {
    const Section *section = find(name);
    return section == nullptr ? 0 : section->n_calls;
  }



  double
  Timings::total_seconds() const
  {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }



  std::string
  Timings::table() const
  {
    std::size_t width = 12;
    for (const Section &section : sections)
      width = std::max(width, section.name.size());

    const double total = total_seconds();
    std::string  text;
    for (unsigned int i = 1; i < sections.size(); ++i)
      if (sections[i].n_calls > 0)
        text +=
          table_row(sections[i].name, width, seconds(sections[i].name), total) +
          " " + std::to_string(sections[i].n_calls) +
          (sections[i].n_calls == 1 ? " call\n" : " calls\n");
    text += table_row("other", width, seconds("other"), total) + "\n";
    text += table_row("total", width, total, total) + "\n";
    return text;
  }



  void
  Timings::switch_to(const unsigned int section)
  {
    const Clock::time_point now = Clock::now();
    sections[running].time += now - last_switch;
    last_switch = now;
    running     = section;
  }



  const Timings::Section *
  Timings::find(const std::string &name) const
  {
    const auto section = std::find_if(sections.begin(),
                                      sections.end(),
                                      [&](const Section &candidate) {
                                        return candidate.name == name;
                                      });
    return section == sections.end() ? nullptr : &*section;
  }
} // namespace Signorini
