#ifndef signorini_material_neo_hooke_h
#define signorini_material_neo_hooke_h

#include <signorini/material/elastic.h>
#include <signorini/material/material.h>

namespace Signorini
{
  /**
   * Compressible neo-Hooke, for finite strains, with the stored energy
   *
   *   mu/2 (tr C - 3 - 2 ln J) + lambda/2 (ln J)^2,   C = F^T F, J = det F.
   *
   * Kirchhoff stress and spatial tangent are
   *
   *   tau = mu (F F^T - 1) + lambda ln J 1,
   *   c   = lambda 1 x 1 + 2 (mu - lambda ln J) I.
   *
   * [BonetWood2008, sec. 6.4.3]
   */
  class NeoHooke : public Material
  {
  public:
    NeoHooke(const ElasticConstants &constants, const double density);

    MaterialResponse
    respond(const MaterialPoint            &point,
            const dealii::ArrayView<double> history) const override;

    unsigned int
    n_history_values() const override
    {
      return 0;
    }

    bool
    is_linear() const override
    {
      return false;
    }

  private:
    ElasticConstants constants_;
  };
} // namespace Signorini

#endif
