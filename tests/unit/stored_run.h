#ifndef signorini_tests_stored_run_h
#define signorini_tests_stored_run_h

#include <signorini/output/displacement_writer.h>
#include <signorini/solid/displacement_history.h>

#include "temporary_folder.h"
#include "test_body.h"

namespace Signorini
{
  /** The displacements of a body at its nodes, from a function of point and
   * component. */
  template <int dim, typename Field>
  dealii::Vector<double>
  at_nodes(const Body<dim> &body, const Field &field)
  {
    dealii::Vector<double> v(body.n_dofs());
    for (const auto &node : body.nodes())
      for (unsigned int c = 0; c < dim; ++c)
        v[node.dofs[c] - body.first_dof()] = field(node.point, c);
    return v;
  }

  /** The output folder of a run with one body "b". */
  template <int dim>
  struct StoredRun
  {
    StoredRun()
      : writer(folder.path.string())
    {}

    void
    store(const Body<dim>              &body,
          const double                  time,
          const dealii::Vector<double> &displacement)
    {
      writer.write({{"b", &body.dof_handler(), &body.mapping(), &displacement}},
                   time);
    }

    DisplacementHistory<dim>
    history(const std::vector<dealii::Point<dim>> &points,
            const TimeInterpolation interpolation = TimeInterpolation::linear,
            const std::string      &body          = "b") const
    {
      return DisplacementHistory<dim>(folder.path.string(),
                                      body,
                                      points,
                                      interpolation);
    }

    TemporaryFolder         folder;
    DisplacementWriter<dim> writer;
  };

  /** A body "b" from the text of its section. */
  template <int dim>
  std::unique_ptr<Body<dim>>
  test_body(const std::string &section)
  {
    return std::move(test_part<dim>("b",
                                    section,
                                    dim == 2 ? Formulation::plane_strain :
                                               Formulation::three_dimensional,
                                    0)
                       .body);
  }
} // namespace Signorini

#endif
