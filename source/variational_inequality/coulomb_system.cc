#include <signorini/variational_inequality/coulomb_system.h>

#include <algorithm>
#include <cmath>

#include "blas.h"

namespace Signorini
{
  using namespace dealii;

  double
  DualContact::bound(const double lambda) const
  {
    return n_tangents > 0 && lambda > 0. ?
             std::min(friction_coefficient * lambda, largest_friction) :
             0.;
  }



  CoulombSystem::CoulombSystem(const InterfaceMatrix   &W,
                               std::vector<DualContact> contacts,
                               std::vector<double>      compliance,
                               std::vector<double>      d,
                               const double             length_scale)
    : W(W)
    , contacts(std::move(contacts))
    , compliance(std::move(compliance))
    , diagonal(d.size())
    , d(std::move(d))
    , length_scale(length_scale)
  {
    AssertDimension(W.m(), this->d.size());
    AssertDimension(this->compliance.size(), this->d.size());
    for (unsigned int i = 0; i < size(); ++i)
      diagonal[i] = W(i, i) + this->compliance[i];
  }



  void
  CoulombSystem::copy_row(const unsigned int i, double *entries) const
  {
    std::copy_n(&W(i, 0), size(), entries);
    entries[i] = diagonal[i];
  }



  std::vector<double>
  CoulombSystem::residual(const std::vector<double> &x) const
  {
    AssertDimension(x.size(), size());
    std::vector<double> y = d;
    const Blas::Integer n = size(), one = 1;
    const double        minus_one = -1., plus_one = 1.;
    // W is symmetric: its rows are its columns.
    if (n > 0)
      Blas::dgemv_("N",
                   &n,
                   &n,
                   &minus_one,
                   &W(0, 0),
                   &n,
                   x.data(),
                   &one,
                   &plus_one,
                   y.data(),
                   &one);
    for (unsigned int j = 0; j < size(); ++j)
      y[j] -= compliance[j] * x[j];
    return y;
  }



  double
  CoulombSystem::normal_weight(const unsigned int k) const
  {
    const double weight = diagonal[contacts[k].row];
    return weight > 0. ? weight : 1.;
  }



  double
  CoulombSystem::tangential_weight(const unsigned int k) const
  {
    const DualContact &contact = contacts[k];
    double             sum     = 0.;
    for (unsigned int a = 1; a <= contact.n_tangents; ++a)
      sum += diagonal[contact.row + a];
    return sum > 0. ? sum / contact.n_tangents : 1.;
  }



  double
  CoulombSystem::error(const unsigned int         k,
                       const std::vector<double> &x,
                       const std::vector<double> &y) const
  {
    // 1. The normal.
    const DualContact &contact = contacts[k];
    const double       reach   = normal_weight(k) * x[contact.row];
    const double       normal =
      std::abs(reach - std::max(reach + y[contact.row], 0.));
    if (contact.n_tangents == 0)
      return normal;

    // 2. The distance from the projection on the disc.
    const double weight = tangential_weight(k);
    const double radius = weight * contact.bound(x[contact.row]);
    double       length = 0.;
    for (unsigned int a = 1; a <= contact.n_tangents; ++a)
      length =
        std::hypot(length, weight * x[contact.row + a] + y[contact.row + a]);
    const double factor     = length > radius ? radius / length : 1.;
    double       tangential = 0.;
    for (unsigned int a = 1; a <= contact.n_tangents; ++a)
      {
        const double force = weight * x[contact.row + a];
        tangential =
          std::hypot(tangential, force - factor * (force + y[contact.row + a]));
      }
    return std::isnan(tangential) ? tangential : std::max(normal, tangential);
  }



  double
  CoulombSystem::error(const std::vector<double> &x,
                       const std::vector<double> &y) const
  {
    double largest = 0.;
    for (unsigned int k = 0; k < n_contacts(); ++k)
      {
        const double value = error(k, x, y);
        if (std::isnan(value))
          return std::numeric_limits<double>::infinity();
        largest = std::max(largest, value);
      }
    return largest;
  }



  double
  CoulombSystem::rounding(const std::vector<double> &x) const
  {
    double size_of_terms = length_scale;
    for (unsigned int i = 0; i < size(); ++i)
      size_of_terms =
        std::max({size_of_terms, std::abs(d[i]), diagonal[i] * std::abs(x[i])});
    return (16. + 2. * size()) * std::numeric_limits<double>::epsilon() *
           size_of_terms;
  }



  std::vector<unsigned int>
  CoulombSystem::wrong_contacts(const std::vector<double> &x,
                                const double               tolerance) const
  {
    const std::vector<double> y = residual(x);
    std::vector<unsigned int> list;
    for (unsigned int k = 0; k < n_contacts(); ++k)
      if (!(error(k, x, y) <= tolerance))
        list.push_back(k);
    return list;
  }
} // namespace Signorini
