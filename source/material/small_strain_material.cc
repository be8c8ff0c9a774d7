#include <signorini/material/small_strain_material.h>

#include "plastic_history.h"
#include "thickness_search.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Entries by deal.II's order xx, yy, zz, xy, xz, yz of both pairs.
    SymmetricTensor<4, 3>
    tangent(const StrainResponse &response)
    {
      double entries[36] = {};
      for (unsigned int a = 0; a < 3; ++a)
        {
          for (unsigned int b = 0; b < 3; ++b)
            entries[6 * a + b] = response.bulk - 2. / 3. * response.shear;
          entries[7 * a] += 2. * response.shear;
          entries[7 * (a + 3)] = response.shear;
        }
      if (response.flows)
        for (unsigned int a = 0; a < 6; ++a)
          for (unsigned int b = 0; b < 6; ++b)
            entries[6 * a + b] += response.direction.access_raw_entry(a) *
                                    response.factor.access_raw_entry(b) +
                                  response.factor.access_raw_entry(a) *
                                    response.direction.access_raw_entry(b);
      return SymmetricTensor<4, 3>(entries);
    }
  } // namespace



  SmallStrainMaterial::SmallStrainMaterial(std::unique_ptr<const StrainLaw> law,
                                           const double density)
    : StrainLawMaterial(std::move(law), Kinematics::small_strain, density, 6)
  {}



  MaterialResponse
  SmallStrainMaterial::respond(const MaterialPoint    &point,
                               const ArrayView<double> history) const
  {
    const SymmetricTensor<2, 3> plastic = plastic_strain(point.history_n);
    return finish(plastic,
                  law().respond(symmetrize(point.gradient) - plastic,
                                point.step.size,
                                PlasticHistory::read_state(law(),
                                                           point.history_n)),
                  history);
  }



  MaterialResponse
  SmallStrainMaterial::respond_in_plane_stress(
    MaterialPoint          &point,
    const ArrayView<double> history) const
  {
    const SymmetricTensor<2, 3> plastic  = plastic_strain(point.history_n);
    SymmetricTensor<2, 3>       strain   = symmetrize(point.gradient) - plastic;
    const StrainResponse        response = Signorini::respond_in_plane_stress(
      law(),
      strain,
      point.step.size,
      PlasticHistory::read_state(law(), point.history_n));
    point.gradient[2][2] = strain[2][2] + plastic[2][2];
    return finish(plastic, response, history);
  }



  SymmetricTensor<2, 3>
  SmallStrainMaterial::plastic_strain(
    const ArrayView<const double> history) const
  {
    return law().is_plastic() ?
             PlasticHistory::read_symmetric(history, n_state_values()) :
             SymmetricTensor<2, 3>();
  }



  MaterialResponse
  SmallStrainMaterial::finish(const SymmetricTensor<2, 3> &plastic_strain_n,
                              const StrainResponse        &response,
                              const ArrayView<double>      history) const
  {
    PlasticHistory::write_state(law(), response.state, history);
    if (law().is_plastic())
      PlasticHistory::write_symmetric(plastic_strain_n +
                                        response.plastic_increment,
                                      history,
                                      n_state_values());
    return {response.stress,
            tangent(response),
            response.energy_density,
            response.state.plastic_work_density};
  }
} // namespace Signorini
