#ifndef signorini_geometry_files_group_ids_h
#define signorini_geometry_files_group_ids_h

#include <map>
#include <string>
#include <vector>

namespace Signorini
{
  /** A name for some cells, or for some faces. */
  struct NamedMembers
  {
    std::string               name;
    bool                      is_automatic; // not given by the user
    std::vector<unsigned int> members;      // sorted, each once
  };

  /** Each member has one id; 0 is for those without a name. */
  struct GroupIds
  {
    std::vector<unsigned int>           id_of_member;
    std::map<std::string, unsigned int> id_of_name;
  };

  /** What happens to a group with members that have another id already. */
  enum class Overlap
  {
    refuse,
    leave_out
  };

  /**
   * Numbers the groups from 1 on. Groups with equal members share an id,
   * empty groups get none. Those given by the user come before automatic ones,
   * small ones before large ones; automatic ones that overlap are always left
   * out.
   * @throws InputError for an overlap that is to be refused, beginning with
   * @p file_name.
   */
  GroupIds
  assign_ids(const std::vector<NamedMembers> &groups,
             const unsigned int               n_members,
             const Overlap                    overlap,
             const std::string               &file_name);
} // namespace Signorini

#endif
