#include <signorini/input/instantiate.h>
#include <signorini/output/field_writer.h>

#include <deal.II/numerics/data_out.h>

#include <sstream>

namespace Signorini
{
  namespace
  {
    using namespace dealii;

    template <int dim>
    void
    add_vector_field(DataOut<dim>          &data_out,
                     const DoFHandler<dim> &dof_handler,
                     const Vector<double>  &values,
                     const std::string     &name)
    {
      AssertDimension(values.size(), dof_handler.n_dofs());
      data_out.add_data_vector(
        dof_handler,
        values,
        std::vector<std::string>(dim, name),
        std::vector<DataComponentInterpretation::DataComponentInterpretation>(
          dim, DataComponentInterpretation::component_is_part_of_vector));
    }

    template <int dim>
    std::string
    vtu_text(const BodyFields<dim> &body,
             const double           time,
             const unsigned int     number)
    {
      Assert(body.dof_handler != nullptr && body.displacement != nullptr,
             ExcMessage("A body needs at least its displacement."));
      AssertDimension(body.dof_handler->get_fe().n_components(), dim);

      DataOut<dim> data_out;
      add_vector_field(data_out,
                       *body.dof_handler,
                       *body.displacement,
                       "displacement");
      if (body.velocity != nullptr)
        add_vector_field(data_out,
                         *body.dof_handler,
                         *body.velocity,
                         "velocity");
      for (const auto &[name, values] : body.nodal_fields)
        {
          Assert(body.scalar_dof_handler != nullptr,
                 ExcMessage("Nodal fields need a DoFHandler."));
          AssertDimension(values->size(), body.scalar_dof_handler->n_dofs());
          data_out.add_data_vector(*body.scalar_dof_handler, *values, name);
        }
      data_out.build_patches(body.dof_handler->get_fe().degree);

      // No date: the same run gives the same files.
      data_out.set_flags(DataOutBase::VtkFlags(
        time, number, false, DataOutBase::VtkFlags::best_speed));
      std::ostringstream text;
      data_out.write_vtu(text);
      return text.str();
    }
  } // namespace



  template <int dim>
  FieldWriter<dim>::FieldWriter(const std::string &folder)
    : collection_(folder + "/results.pvd")
  {}



  template <int dim>
  void
  FieldWriter<dim>::write(const std::vector<BodyFields<dim>> &bodies,
                          const double                        time)
  {
    std::vector<std::string> parts;
    for (const BodyFields<dim> &body : bodies)
      parts.push_back(body.name);
    collection_.write(parts,
                      time,
                      [&](const unsigned int i, const unsigned int number) {
                        return vtu_text(bodies[i], time, number);
                      });
  }



#define INSTANTIATE(dim) template class FieldWriter<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
