#include <signorini/contact/rigid_target.h>
#include <signorini/input/instantiate.h>

#include <algorithm>
#include <cmath>

#include "tangents.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    class PlacedRigidTarget : public PlacedTarget<dim>
    {
    public:
      PlacedRigidTarget(const RigidBody<dim>      &body,
                        const RigidPlacement<dim> &now,
                        const RigidPlacement<dim> &before)
        : body_(body)
        , now_(now)
        , before_(before)
      {}

      std::optional<TargetPoint<dim>>
      closest(const ContactorPoint<dim> &point) const override;

      std::optional<Tensor<1, dim>>
      passed_side(const Point<dim>  &start,
                  const Point<dim>  &end,
                  const double       start_gap,
                  const unsigned int unknown) const override;

    private:
      void
      add_supporting_dofs(const Point<dim> &y, TargetPoint<dim> &target) const;

      // grad grad g over x, u and, in 2-D, the arc of rotation.
      FullMatrix<double>
      curvature(const Point<dim>              &x,
                const Tensor<1, dim>          &normal,
                const SymmetricTensor<2, dim> &of_shape) const;

      const RigidBody<dim>     &body_;
      const RigidPlacement<dim> now_;
      const RigidPlacement<dim> before_;
    };



    template <int dim>
    std::optional<TargetPoint<dim>>
    PlacedRigidTarget<dim>::closest(const ContactorPoint<dim> &point) const
    {
      const Point<dim>        X       = now_.to_body(point.position);
      const SurfacePoint<dim> surface = body_.surface().closest(X);
      const Point<dim>        Y       = X - surface.gap * surface.normal;
      const Point<dim>        y       = now_.to_space(Y);

      TargetPoint<dim> target;
      target.gap      = surface.gap;
      target.normal   = now_.rotation * surface.normal;
      target.tangents = tangents_of(target.normal);
      // Along its arc, since it rubs all the way
      target.motion = now_.translation - before_.translation +
                      (now_.angle - before_.angle) *
                        quarter_turn<dim>(y - now_.centre - now_.translation);
      if (body_.is_free())
        add_supporting_dofs(y, target);
      if (!body_.is_flat())
        target.curvature =
          curvature(point.position, target.normal, surface.curvature);
      return target;
    }



    // The gap is a distance: from a point the path is free for at least so far.
    // The body turns on the way, since a straight path in the body would cut
    // off arcs of a circle that turns in its place.
    template <int dim>
    std::optional<Tensor<1, dim>>
    PlacedRigidTarget<dim>::passed_side(const Point<dim> &start,
                                        const Point<dim> &end,
                                        const double /*start_gap*/,
                                        const unsigned int /*unknown*/) const
    {
      const Tensor<1, dim> motion =
        (end - start) - (now_.translation - before_.translation);
      const double angle = now_.angle - before_.angle;
      const double lever =
        std::max(start.distance(now_.centre + before_.translation),
                 end.distance(now_.centre + now_.translation));
      // Not less than the length of the path in the body
      const double           length = motion.norm() + std::abs(angle) * lever;
      const double           depth  = tunnelling_depth(start, length);
      constexpr unsigned int most   = 100; // a path that grazes comes no nearer
      double                 passed = 0.;  // along the path
      Tensor<1, dim>         side; // of the body, that the point saw last
      for (unsigned int i = 0; i < most && passed < length; ++i)
        {
          const double        share      = passed / length;
          RigidPlacement<dim> on_the_way = before_;
          on_the_way.translation +=
            share * (now_.translation - before_.translation);
          on_the_way.rotation =
            rotation_by<dim>(share * angle) * before_.rotation;
          const Point<dim> X =
            on_the_way.to_body(start + share * (end - start));
          const auto found = body_.surface().closest(X);
          if (found.gap < -depth && passed > 0.)
            return now_.rotation * side;
          side = found.normal;
          passed += std::max(found.gap, 1e-3 * length);
        }
      return {};
    }



    template <int dim>
    void
    PlacedRigidTarget<dim>::add_supporting_dofs(const Point<dim> &y,
                                                TargetPoint<dim> &target) const
    {
      for (unsigned int c = 0; c < dim; ++c)
        {
          Tensor<1, dim> direction;
          direction[c] = 1.;
          target.supporting_dofs.emplace_back(body_.first_unknown() + c,
                                              direction);
        }
      if (dim == 2)
        target.supporting_dofs.emplace_back(
          body_.first_unknown() + 2,
          quarter_turn<dim>(y - now_.centre - now_.translation) /
            body_.lever());
    }



    template <int dim>
    FullMatrix<double>
    PlacedRigidTarget<dim>::curvature(
      const Point<dim>              &x,
      const Tensor<1, dim>          &normal,
      const SymmetricTensor<2, dim> &of_shape) const
    {
      const Tensor<2, dim> H =
        now_.rotation * Tensor<2, dim>(of_shape) * transpose(now_.rotation);
      const unsigned int n_supporting_dofs =
        body_.is_free() ? RigidBody<dim>::n_components : 0;
      const Tensor<1, dim> arm = x - now_.centre - now_.translation;

      // 1. w.H w with w = sum_i columns[i] dq_i
      std::vector<Tensor<1, dim>> columns(dim + n_supporting_dofs);
      for (unsigned int c = 0; c < dim; ++c)
        {
          columns[c][c] = 1.;
          if (n_supporting_dofs > 0)
            columns[dim + c][c] = -1.;
        }
      const bool turns = dim == 2 && n_supporting_dofs > 0;
      if (turns)
        columns[2 * dim] = -quarter_turn<dim>(arm) / body_.lever();
      FullMatrix<double> matrix(columns.size());
      for (unsigned int i = 0; i < columns.size(); ++i)
        for (unsigned int j = 0; j < columns.size(); ++j)
          matrix(i, j) = columns[i] * (H * columns[j]);

      // 2. The normal turns with the body
      if (turns)
        {
          const unsigned int t = 2 * dim;
          for (unsigned int i = 0; i < t; ++i)
            {
              const double entry =
                -(normal * quarter_turn<dim>(columns[i])) / body_.lever();
              matrix(i, t) += entry;
              matrix(t, i) += entry;
            }
          matrix(t, t) -= normal * arm / (body_.lever() * body_.lever());
        }
      return matrix;
    }
  } // namespace



  template <int dim>
  RigidTarget<dim>::RigidTarget(const RigidBody<dim> &body)
    : body_(body)
  {}



  template <int dim>
  std::string
  RigidTarget<dim>::name() const
  {
    return body_.name();
  }



  template <int dim>
  bool
  RigidTarget<dim>::is_flat() const
  {
    return body_.is_flat();
  }



  template <int dim>
  std::vector<unsigned int>
  RigidTarget<dim>::unknowns() const
  {
    std::vector<unsigned int> list;
    if (body_.is_free())
      for (unsigned int c = 0; c < RigidBody<dim>::n_components; ++c)
        list.push_back(body_.first_unknown() + c);
    return list;
  }



  template <int dim>
  std::unique_ptr<PlacedTarget<dim>>
  RigidTarget<dim>::place(const Configuration &now,
                          const Configuration &before) const
  {
    return std::make_unique<PlacedRigidTarget<dim>>(body_,
                                                    body_.placement(now),
                                                    body_.placement(before));
  }



#define INSTANTIATE(dim) template class RigidTarget<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
