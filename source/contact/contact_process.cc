#include <signorini/contact/archard_wear.h>
#include <signorini/contact/contact_process.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    struct ProcessKind
    {
      void (*declare_parameters)(const bool, ParameterHandler &);
      EntryConditions (*conditions)();
      std::unique_ptr<const ContactProcess> (*parse)(const PairEntries &);
    };

    template <typename Process>
    ProcessKind
    process_kind()
    {
      return {&Process::declare_parameters,
              &Process::conditions,
              &Process::parse};
    }

    // The one list of processes.
    const std::vector<ProcessKind> &
    process_kinds()
    {
      static const std::vector<ProcessKind> list = {
        process_kind<ArchardWear>()};
      return list;
    }
  } // namespace



  void
  declare_contact_processes(const bool in_pair, ParameterHandler &prm)
  {
    for (const ProcessKind &kind : process_kinds())
      kind.declare_parameters(in_pair, prm);
  }



  EntryConditions
  contact_process_conditions()
  {
    EntryConditions list;
    for (const ProcessKind &kind : process_kinds())
      for (const EntryCondition &condition : kind.conditions())
        list.push_back(condition);
    return list;
  }



  ContactProcesses
  parse_contact_processes(const PairEntries &entries)
  {
    ContactProcesses list;
    for (const ProcessKind &kind : process_kinds())
      if (std::shared_ptr<const ContactProcess> process = kind.parse(entries))
        list.push_back(process);
    return list;
  }
} // namespace Signorini
