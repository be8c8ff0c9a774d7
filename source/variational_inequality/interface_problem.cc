#include <signorini/variational_inequality/interface_problem.h>

namespace Signorini
{
  using namespace dealii;

  void
  InterfaceProblem::set_stiffness(InterfaceStiffness &&new_stiffness)
  {
    interface_stiffness = std::move(new_stiffness);
    responses.forget_all();
    force_known             = false;
    reduced_force_known     = false;
    free_displacement_known = false;
    free_gaps_known         = false;
  }



  void
  InterfaceProblem::set_force(const Vector<double> &r)
  {
    AssertDimension(r.size(), size());
    condensed_force         = r;
    force_known             = true;
    reduced_force_known     = false;
    free_displacement_known = false;
    free_gaps_known         = false;
  }



  void
  InterfaceProblem::set_reduced_force(const Vector<double> &y)
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
    responses.resize(new_contacts.size());
    for (unsigned int k = 0; k < new_contacts.size(); ++k)
      if (k >= contacts.size() || contacts[k].normal != new_contacts[k].normal)
        responses.forget(k);
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



  const Vector<double> &
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



  const Vector<double> &
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
        const Vector<double> &displacement = free_displacement();
        gaps_without_contact.resize(n_contacts());
        for (unsigned int k = 0; k < n_contacts(); ++k)
          gaps_without_contact[k] = gap_after(k, displacement);
        free_gaps_known = true;
      }
    return gaps_without_contact;
  }



  const Vector<double> &
  InterfaceProblem::response(const unsigned int k) const
  {
    AssertIndexRange(k, contacts.size());
    if (!responses.is_known(k))
      prepare_responses({k});
    return responses[k];
  }



  void
  InterfaceProblem::prepare_responses(
    const std::vector<unsigned int> &wanted) const
  {
    responses.compute(
      interface_stiffness,
      [this](const unsigned int k) -> const SparseRow & {
        return contacts[k].normal;
      },
      wanted);
  }
} // namespace Signorini
