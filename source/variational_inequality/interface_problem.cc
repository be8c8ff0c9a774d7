#include <signorini/variational_inequality/interface_problem.h>

namespace Signorini
{
  using namespace dealii;

  void
  InterfaceProblem::set_stiffness(InterfaceStiffness &&new_stiffness)
  {
    interface_stiffness = std::move(new_stiffness);
    responses.forget_all();
    kept_compliance.clear();
    force_known             = false;
    reduced_force_known     = false;
    free_displacement_known = false;
    free_gaps_known         = false;
  }



  void
  InterfaceProblem::set_force(const InterfaceVector &r)
  {
    AssertDimension(r.size(), size());
    condensed_force         = r;
    force_known             = true;
    reduced_force_known     = false;
    free_displacement_known = false;
    free_gaps_known         = false;
  }



  void
  InterfaceProblem::set_reduced_force(const InterfaceVector &y)
  {
    AssertDimension(y.size(), size());
    reduced_force           = y;
    reduced_force_known     = true;
    force_known             = false;
    free_displacement_known = false;
    free_gaps_known         = false;
  }



  void
  InterfaceProblem::set_contacts(std::vector<InterfaceContact> new_contacts)
  {
    const auto row_of = [](const std::vector<InterfaceContact> &list,
                           const unsigned int                   number) {
      const InterfaceContact &contact   = list[number / 3];
      const unsigned int      direction = number % 3;
      return direction == 0 ? &contact.normal :
             direction <= contact.tangents.size() ?
                              &contact.tangents[direction - 1] :
                              nullptr;
    };
    responses.resize(3 * new_contacts.size());
    bool changed = new_contacts.size() < contacts.size();
    for (unsigned int number = 0; number < 3 * new_contacts.size(); ++number)
      {
        const SparseRow *const new_row = row_of(new_contacts, number);
        const SparseRow *const old_row =
          number < 3 * contacts.size() ? row_of(contacts, number) : nullptr;
        const bool same = old_row == nullptr || new_row == nullptr ?
                            old_row == new_row :
                            *old_row == *new_row;
        if (same)
          continue;
        responses.forget(number);
        changed = true;
      }
    for (unsigned int k = 0; k < new_contacts.size() && !changed; ++k)
      changed = k < contacts.size() &&
                contacts[k].has_friction() != new_contacts[k].has_friction();
    if (changed)
      kept_compliance.clear();
    contacts        = std::move(new_contacts);
    free_gaps_known = false;
  }



  void
  InterfaceProblem::set_gap(const unsigned int k, const double gap)
  {
    AssertIndexRange(k, contacts.size());
    contacts[k].gap = gap;
    free_gaps_known = false;
  }



  void
  InterfaceProblem::set_slip(const unsigned int           k,
                             const std::array<double, 2> &slip)
  {
    AssertIndexRange(k, contacts.size());
    contacts[k].slip = slip;
  }



  const InterfaceVector &
  InterfaceProblem::force() const
  {
    Assert(force_known || reduced_force_known, ExcNotInitialized());
    if (!force_known)
      {
        condensed_force = reduced_force;
        interface_stiffness.multiply_factor(condensed_force);
        force_known = true;
      }
    return condensed_force;
  }



  const InterfaceVector &
  InterfaceProblem::free_displacement() const
  {
    Assert(force_known || reduced_force_known, ExcNotInitialized());
    if (!free_displacement_known)
      {
        if (!reduced_force_known)
          {
            reduced_force = condensed_force;
            interface_stiffness.solve_factor(reduced_force);
            reduced_force_known = true;
          }
        displacement_without_contact = reduced_force;
        interface_stiffness.solve_transposed_factor(
          displacement_without_contact);
        free_displacement_known = true;
      }
    return displacement_without_contact;
  }



  const std::vector<double> &
  InterfaceProblem::free_gaps() const
  {
    if (!free_gaps_known)
      {
        const InterfaceVector &displacement = free_displacement();
        gaps_without_contact.resize(n_contacts());
        for (unsigned int k = 0; k < n_contacts(); ++k)
          gaps_without_contact[k] = gap_after(k, displacement);
        free_gaps_known = true;
      }
    return gaps_without_contact;
  }



  const InterfaceVector &
  InterfaceProblem::row_response(const unsigned int number) const
  {
    AssertIndexRange(number, 3 * contacts.size());
    AssertIndexRange(number % 3, contacts[number / 3].tangents.size() + 1);
    if (!responses.is_known(number))
      responses.compute(interface_stiffness,
                        [this](const unsigned int i) -> const SparseRow & {
                          return row(i);
                        },
                        {number});
    return responses[number];
  }



  void
  InterfaceProblem::prepare_responses(const std::vector<unsigned int> &wanted,
                                      const bool with_friction) const
  {
    responses.compute(
      interface_stiffness,
      [this](const unsigned int i) -> const SparseRow & { return row(i); },
      rows_of(wanted, with_friction));
  }



  std::vector<unsigned int>
  InterfaceProblem::rows_of(const std::vector<unsigned int> &list,
                            const bool with_friction) const
  {
    std::vector<unsigned int> numbers;
    numbers.reserve(3 * list.size());
    for (const unsigned int k : list)
      {
        numbers.push_back(row_number(k, 0));
        if (with_friction && contacts[k].has_friction())
          for (unsigned int j = 0; j < contacts[k].tangents.size(); ++j)
            numbers.push_back(row_number(k, j + 1));
      }
    return numbers;
  }



  ComplianceMatrix &
  InterfaceProblem::compliance_matrix(const std::vector<unsigned int> &list,
                                      const bool with_friction) const
  {
    const std::vector<unsigned int> numbers = rows_of(list, with_friction);
    if (!kept_compliance.holds(numbers))
      {
        prepare_responses(list, with_friction);
        kept_compliance.set_rows(numbers,
                                 [this](const unsigned int i,
                                        const unsigned int j) {
                                   return row(i).dot(responses[j]);
                                 });
      }
    return kept_compliance;
  }
} // namespace Signorini
