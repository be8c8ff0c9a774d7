#include <signorini/geometry/files/group_ids.h>
#include <signorini/input/input_error.h>

#include <algorithm>
#include <tuple>

namespace Signorini
{
  namespace
  {
    // Groups in the order in which they may choose.
    std::vector<const NamedMembers *>
    by_rank(const std::vector<NamedMembers> &groups)
    {
      std::vector<const NamedMembers *> order;
      for (const NamedMembers &group : groups)
        if (!group.members.empty())
          order.push_back(&group);
      std::stable_sort(order.begin(),
                       order.end(),
                       [](const NamedMembers *a, const NamedMembers *b) {
                         return std::make_tuple(a->is_automatic,
                                                a->members.size()) <
                                std::make_tuple(b->is_automatic,
                                                b->members.size());
                       });
      return order;
    }

    [[noreturn]] void
    refuse_overlap(const std::string &file_name,
                   const std::string &name,
                   const std::string &other_name)
    {
      throw InputError(file_name + ": the boundaries \"" + other_name +
                       "\" and \"" + name +
                       "\" have a face in common. A face can belong to one "
                       "named boundary only; make the groups disjoint.");
    }
  } // namespace



  GroupIds
  assign_ids(const std::vector<NamedMembers> &groups,
             const unsigned int               n_members,
             const Overlap                    overlap,
             const std::string               &file_name)
  {
    GroupIds ids;
    ids.id_of_member.assign(n_members, 0);
    std::vector<const NamedMembers *> group_of_id(1, nullptr);

    for (const NamedMembers *const group : by_rank(groups))
      {
        unsigned int other = 0;
        for (const unsigned int member : group->members)
          other = std::max(other, ids.id_of_member[member]);

        if (other > 0 && group_of_id[other]->members == group->members)
          ids.id_of_name.insert({group->name, other});
        else if (other == 0)
          {
            const unsigned int id = group_of_id.size();
            group_of_id.push_back(group);
            ids.id_of_name.insert({group->name, id});
            for (const unsigned int member : group->members)
              ids.id_of_member[member] = id;
          }
        else if (overlap == Overlap::refuse && !group->is_automatic)
          refuse_overlap(file_name, group->name, group_of_id[other]->name);
      }
    return ids;
  }
} // namespace Signorini
