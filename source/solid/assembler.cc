#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/solid/assembler.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/work_stream.h>
#include <deal.II/fe/fe_values.h>

#include <exception>
#include <map>
#include <memory>
#include <sstream>

#include "cell_response.h"
#include "cell_scratch.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    unsigned int
    n_values_at_a_point(const Body<dim> &body)
    {
      unsigned int n = 0;
      for (const Material *const material : body.materials())
        n = std::max(n, n_history_values(body.formulation(), *material));
      return n;
    }

    template <int dim, int n_strains>
    struct ResponseScratch : public CellScratch<dim>
    {
      explicit ResponseScratch(const Body<dim> &body)
        : CellScratch<dim>(body,
                           update_values | update_gradients |
                             update_quadrature_points | update_JxW_values)
        , body(body)
        , cell(body, this->values.n_quadrature_points)
        , displacement(body.fe().n_dofs_per_cell())
        , displacement_n(body.fe().n_dofs_per_cell())
        , n_point_values(n_values_at_a_point(body))
        , n_cell_values(n_point_values * this->values.n_quadrature_points)
      {}

      /** Where the histories of the points of a cell begin. */
      unsigned int
      first_value(
        const typename DoFHandler<dim>::active_cell_iterator &visited) const
      {
        return visited->active_cell_index() * n_cell_values;
      }

      /** @param constant answer of a linear law, or null. */
      void
      evaluate(const typename DoFHandler<dim>::active_cell_iterator &visited,
               const SolidStep                                      &step,
               const PointResponse                                  *constant,
               const double                                         *history_n,
               double                                               *history,
               const bool with_stiffness)
      {
        this->visit(visited);
        set_temperatures(step);
        const typename CellResponse<dim, n_strains>::Point point = {
          &body.material(visited->material_id()),
          constant,
          {step.size, {}},
          temperatures,
          ArrayView<const double>(history_n, n_cell_values),
          ArrayView<double>(history, n_cell_values),
          n_point_values};
        get_values(step.displacement, displacement);
        if (!step.displacement_n)
          {
            cell.evaluate(this->values, displacement, point, with_stiffness);
            return;
          }
        get_values(*step.displacement_n, displacement_n);
        cell.evaluate_step(
          this->values, displacement_n, displacement, point, with_stiffness);
      }

      // At the points of the cell, if the step changes them.
      void
      set_temperatures(const SolidStep &step)
      {
        temperatures.clear();
        if (step.time && body.temperature())
          for (const auto &point : this->values.get_quadrature_points())
            temperatures.push_back(
              body.temperature()->value(point, *step.time));
      }

      void
      get_values(const DofVector &of_all, std::vector<double> &of_cell) const
      {
        for (unsigned int i = 0; i < of_cell.size(); ++i)
          of_cell[i] = of_all[this->dofs.all()[i]];
      }

      const Body<dim>             &body;
      CellResponse<dim, n_strains> cell;
      std::vector<double>          displacement;
      std::vector<double>          displacement_n;
      std::vector<double>          temperatures;
      const unsigned int           n_point_values;
      const unsigned int           n_cell_values;
    };

    struct ResponseCopy
    {
      explicit ResponseCopy(const unsigned int n_dofs)
        : stiffness(n_dofs, n_dofs)
        , force(n_dofs)
        , mean_force(n_dofs)
        , dofs(n_dofs)
      {}

      FullMatrix<double>                   stiffness;
      DofVector                            force;
      DofVector                            mean_force;
      std::vector<types::global_dof_index> dofs;
      double                               stored_energy = 0.;
      double                               plastic_work  = 0.;
      double                               heating       = 0.;
      std::exception_ptr                   failure;
    };

    template <int dim>
    std::string
    failure_in_words(const Body<dim>   &body,
                     const Point<dim>  &centre,
                     const std::string &reason)
    {
      std::ostringstream message;
      message << "body " << body.name() << ", cell with the centre (" << centre
              << "): " << reason;
      return message.str();
    }

    // Answers of the linear laws, which are the same at every point and
    // displacement.
    template <int dim>
    std::map<const Material *, PointResponse>
    constant_responses(const Body<dim> &body)
    {
      std::map<const Material *, PointResponse> responses;
      for (const Material *const material : body.materials())
        if (material->is_linear())
          responses[material] = respond(
            body.formulation(), *material, Tensor<2, dim>(), 0., {}, {}, {});
      return responses;
    }

    // Does a strain across the plane do work?
    bool
    has_strain_across(const Body<2> &body)
    {
      return body.formulation() == Formulation::axisymmetric ||
             body.has_mean_dilatation();
    }

    template <int dim, int n_strains>
    void
    add_response(const Body<dim>                 &body,
                 const AffineConstraints<double> &constraints,
                 const SolidStep                 &step,
                 const ArrayView<const double>    history_n,
                 const ArrayView<double>          history,
                 SolidResponse                   &response,
                 DofMatrix                       *stiffness,
                 const double                     factor)
    {
      using Scratch               = ResponseScratch<dim, n_strains>;
      const auto         constant = constant_responses(body);
      std::exception_ptr failure;

      const auto worker = [&](const auto   &cell,
                              Scratch      &scratch,
                              ResponseCopy &copy) {
        const auto known = constant.find(&body.material(cell->material_id()));
        const unsigned int first = scratch.first_value(cell);
        copy.failure             = nullptr;
        try
          {
            scratch.evaluate(cell,
                             step,
                             known == constant.end() ? nullptr : &known->second,
                             history_n.data() + first,
                             history.data() + first,
                             stiffness != nullptr);
          }
        catch (const MaterialFailure &error)
          {
            copy.failure = std::make_exception_ptr(MaterialFailure(
              failure_in_words(body, cell->center(), error.what())));
            return;
          }
        // No exception may leave a thread: of a formula without a value.
        catch (const InputError &)
          {
            copy.failure = std::current_exception();
            return;
          }
        copy.dofs      = scratch.dofs.all();
        copy.stiffness = scratch.cell.stiffness;
        copy.stiffness *= factor;
        copy.force         = scratch.cell.force;
        copy.mean_force    = scratch.cell.mean_force;
        copy.stored_energy = scratch.cell.stored_energy;
        copy.plastic_work  = scratch.cell.plastic_work;
        copy.heating       = scratch.cell.heating;
      };
      const auto copier = [&](const ResponseCopy &copy) {
        if (copy.failure)
          {
            failure = copy.failure;
            return;
          }
        response.stored_energy += copy.stored_energy;
        response.plastic_work += copy.plastic_work;
        response.heating += copy.heating;
        if (step.displacement_n)
          constraints.distribute_local_to_global(copy.mean_force,
                                                 copy.dofs,
                                                 response.mean_force);
        if (stiffness)
          constraints.distribute_local_to_global(copy.stiffness,
                                                 copy.force,
                                                 copy.dofs,
                                                 *stiffness,
                                                 response.internal_force);
        else
          constraints.distribute_local_to_global(copy.force,
                                                 copy.dofs,
                                                 response.internal_force);
      };
      WorkStream::run(body.dof_handler().begin_active(),
                      body.dof_handler().end(),
                      worker,
                      copier,
                      Scratch(body),
                      ResponseCopy(body.fe().n_dofs_per_cell()));
      if (failure)
        std::rethrow_exception(failure);
    }

    template <int dim, int n_strains>
    PointValues
    point_values(const Body<dim>              &body,
                 const DofVector              &displacement,
                 const ArrayView<const double> history)
    {
      ResponseScratch<dim, n_strains> scratch(body);
      const unsigned int              n = scratch.n_point_values;
      std::vector<double>             unused(scratch.n_cell_values);
      PointValues                     result;
      for (const auto &cell : body.dof_handler().active_cell_iterators())
        {
          const double *const first =
            history.data() + scratch.first_value(cell);
          scratch.evaluate(
            cell, {displacement}, nullptr, first, unused.data(), false);
          for (unsigned int q = 0; q < scratch.values.n_quadrature_points; ++q)
            {
              result.stresses.push_back(scratch.cell.stresses[q]);
              result.plastic_strains.push_back(
                body.material(cell->material_id())
                  .equivalent_plastic_strain(
                    ArrayView<const double>(first + q * n, n)));
            }
        }
      return result;
    }
  } // namespace



  template <int dim>
  unsigned int
  n_history_values(const Body<dim> &body)
  {
    const unsigned int n_points =
      QGauss<dim>(body.scalar_fe().degree + 1).size();
    return body.mesh().triangulation->n_active_cells() * n_points *
           n_values_at_a_point(body);
  }



  template <int dim>
  void
  add_response(const Body<dim>                 &body,
               const AffineConstraints<double> &constraints,
               const SolidStep                 &step,
               const ArrayView<const double>    history_n,
               const ArrayView<double>          history,
               SolidResponse                   &response,
               DofMatrix                       *stiffness,
               const double                     factor)
  {
    const auto add = [&](const auto function) {
      function(body,
               constraints,
               step,
               history_n,
               history,
               response,
               stiffness,
               factor);
    };
    if constexpr (dim == 3)
      add(add_response<3, 6>);
    else if (has_strain_across(body))
      add(add_response<2, 4>);
    else
      add(add_response<2, 3>);
  }



  template <int dim>
  PointValues
  point_values(const Body<dim>              &body,
               const DofVector              &displacement,
               const ArrayView<const double> history)
  {
    if constexpr (dim == 3)
      return point_values<3, 6>(body, displacement, history);
    else if (has_strain_across(body))
      return point_values<2, 4>(body, displacement, history);
    else
      return point_values<2, 3>(body, displacement, history);
  }



#define INSTANTIATE(dim)                                                     \
  template unsigned int n_history_values<dim>(const Body<dim> &);            \
  template void         add_response<dim>(const Body<dim> &,                 \
                                  const AffineConstraints<double> &, \
                                  const SolidStep &,                 \
                                  const ArrayView<const double>,     \
                                  const ArrayView<double>,           \
                                  SolidResponse &,                   \
                                  DofMatrix *,                       \
                                  const double);                     \
  template PointValues  point_values<dim>(const Body<dim> &,                 \
                                         const DofVector &,                 \
                                         const ArrayView<const double>);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
