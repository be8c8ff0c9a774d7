#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/named_errors.h>
#include <signorini/input/named_list.h>
#include <signorini/solid/supports.h>
#include <signorini/time/motion_rates.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/manifold.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Unit normals at the nodes of a boundary: those of the curve or surface
    // that the mesh stands for. By the first unknown of the node.
    // @throws InputError at a corner
    template <int dim>
    std::map<unsigned int, Tensor<1, dim>>
    boundary_normals(const Body<dim> &body, const std::string &boundary)
    {
      constexpr double corner = 0.95; // cos of 18 degrees
      std::map<unsigned int, const Node<dim> *> nodes;
      for (const auto &node : body.nodes())
        nodes[node.dofs[0] - body.first_dof()] = &node;

      const types::boundary_id id = body.mesh().boundary(boundary);
      std::map<unsigned int, Tensor<1, dim>> sums;
      std::vector<types::global_dof_index>   dofs(body.fe().n_dofs_per_face());
      for (const auto &cell : body.dof_handler().active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          {
            if (!face->at_boundary() || face->boundary_id() != id)
              continue;
            face->get_dof_indices(dofs);
            const typename Triangulation<dim>::face_iterator geometry(face);
            for (const unsigned int dof : dofs)
              {
                const auto found = nodes.find(dof);
                if (found == nodes.end())
                  continue;
                const Node<dim> &node = *found->second;
                Tensor<1, dim>   normal =
                  face->get_manifold().normal_vector(geometry, node.point);
                Tensor<1, dim> &sum = sums[node.dofs[0]];
                if (normal * sum < 0.)
                  normal *= -1.;
                if (sum.norm() > 0. && normal * sum < corner * sum.norm())
                  {
                    std::ostringstream message;
                    message << "the boundary \"" << boundary
                            << "\" has a corner at (" << node.point
                            << "). Name its sides apart.";
                    throw InputError(message.str());
                  }
                sum += normal;
              }
          }
      for (auto &[dof, sum] : sums)
        sum /= sum.norm();
      return sums;
    }

    template <int dim>
    bool
    are_equal(const std::map<unsigned int, Tensor<1, dim>> &normals)
    {
      return std::all_of(
        normals.begin(), normals.end(), [&](const auto &other) {
          return std::abs(other.second * normals.begin()->second) > 1. - 1e-12;
        });
    }

    // The nodes a place of the .prm stands for: a boundary or `point x, y`.
    template <int dim>
    std::vector<Node<dim>>
    nodes_at(const Body<dim>   &body,
             const std::string &place,
             const Constants   &constants,
             const std::string &entry)
    {
      const std::string keyword = "point ";
      if (place.compare(0, keyword.size(), keyword) == 0)
        return {body.node_near(
          parse_point<dim>(place.substr(keyword.size()), entry, constants),
          entry)};
      try
        {
          return body.boundary_nodes(place);
        }
      catch (const InputError &error)
        {
          throw InputError(entry,
                           error.text() +
                             " A single node is written \"point x, y\".");
        }
    }
  } // namespace



  template <int dim>
  void
  Supports<dim>::declare_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Supports");
    prm.declare_entry("Fixed",
                      "",
                      Patterns::Anything(),
                      "Components that cannot move: `left: x, y | bottom: y'. "
                      "A place is the name of a boundary, or `point x, y' for "
                      "the node there.");
    prm.declare_entry("Prescribed motion",
                      "",
                      Patterns::Anything(),
                      "Displacements as functions of x, y (, z) and t: "
                      "`top: y = -1e-3*t ; x = 0 | right: x = 0.1*sin(t)'. "
                      "Unit: m.");
    prm.declare_entry("Sliding",
                      "",
                      Patterns::Anything(),
                      "Boundaries whose nodes move along their tangents only, "
                      "`side | bore': planes of symmetry that are not parallel "
                      "to an axis, or a shaft in a smooth bearing. With finite "
                      "strain they have to be plane.");
    prm.declare_entry("From global run",
                      "",
                      Patterns::Anything(),
                      "Boundaries of a submodel whose displacement is that of "
                      "the run in `Submodel of', `cut | back'.");
    prm.declare_entry("Absorbing",
                      "",
                      Patterns::Anything(),
                      "Boundaries behind which the body goes on without end, "
                      "`right | bottom': viscous dashpots take up the waves "
                      "that arrive. In dynamic runs; they do not hold the body "
                      "in place.");
    prm.leave_subsection();
  }



  template <int dim>
  Supports<dim>::Supports(const Body<dim>  &body,
                          const Constants  &constants,
                          const GlobalRun  &global_run,
                          ParameterHandler &prm)
  {
    prm.enter_subsection("Supports");
    const std::string section = "Body " + body.name() + " / Supports / ";
    const std::string fixed   = section + "Fixed";
    for (const auto &[place, components] :
         parse_named_list(prm.get("Fixed"), fixed))
      for (const std::string &component : split_list(components, ','))
        add(nodes_at(body, place, constants, fixed),
            parse_component<dim>(component, fixed),
            nullptr);

    const std::string prescribed = section + "Prescribed motion";
    for (const auto &[place, motions] :
         parse_named_list(prm.get("Prescribed motion"), prescribed))
      for (const std::string &motion : split_list(motions, ';'))
        {
          const std::size_t equal = motion.find('=');
          if (equal == std::string::npos)
            throw InputError(prescribed,
                             "found \"" + motion +
                               "\". Write \"component = expression\".");
          motions_.push_back(std::make_unique<SpaceTimeFunction<dim>>(
            motion.substr(equal + 1),
            1,
            constants,
            prescribed,
            Dependence::space_and_time));
          add(nodes_at(body, place, constants, prescribed),
              parse_component<dim>(Utilities::trim(motion.substr(0, equal)),
                                   prescribed),
              motions_.back().get());
        }

    with_entry(section + "From global run", [&] {
      follow_global_run(body, prm.get("From global run"), global_run);
    });
    with_entry(section + "Sliding", [&] {
      for (const std::string &boundary : split_list(prm.get("Sliding"), '|'))
        add_sliding_nodes(body, boundary);
    });
    with_entry(section + "Absorbing", [&] {
      for (const std::string &boundary : split_list(prm.get("Absorbing"), '|'))
        absorbing_boundaries_.insert(body.mesh().boundary(boundary));
    });
    prm.leave_subsection();
  }



  template <int dim>
  void
  Supports<dim>::add(const std::vector<Node<dim>> &nodes,
                     const unsigned int            component,
                     const SpaceTimeFunction<dim> *motion)
  {
    // A node of two boundaries takes what was said last: motions come after
    // fixed places and win at common corners.
    for (const auto &node : nodes)
      prescribed_.push_back({node.dofs[component], node.point, motion});
  }



  template <int dim>
  void
  Supports<dim>::follow_global_run(const Body<dim>   &body,
                                   const std::string &boundaries,
                                   const GlobalRun   &global_run)
  {
    std::map<unsigned int, Node<dim>> nodes; // corners are of two boundaries
    for (const std::string &boundary : split_list(boundaries, '|'))
      for (const auto &node : body.boundary_nodes(boundary))
        nodes[node.dofs[0]] = node;
    if (nodes.empty())
      return;
    if (global_run.folder.empty())
      throw InputError("there is no global run. Set Submodel of = FOLDER, the "
                       "folder of its results.");
    std::vector<Point<dim>> points;
    for (const auto &[dof, node] : nodes)
      {
        global_nodes_.push_back(node);
        points.push_back(node.point);
      }
    global_run_ = std::make_unique<DisplacementHistory<dim>>(
      global_run.folder, body.name(), points, global_run.interpolation);
    global_run_->values(0.);
    global_run_->values(global_run.end_time);
  }



  template <int dim>
  void
  Supports<dim>::add_sliding_nodes(const Body<dim>   &body,
                                   const std::string &boundary)
  {
    const auto normals = boundary_normals(body, boundary);
    if (body.kinematics() == Kinematics::finite_strain && !are_equal(normals))
      throw InputError("the boundary \"" + boundary +
                       "\" is not plane. With finite strain the nodes would "
                       "leave it along its tangents. Name a plane one, or set "
                       "Kinematics = small strain.");
    for (const auto &node : body.boundary_nodes(boundary))
      sliding_nodes_.push_back({node, normals.at(node.dofs[0])});
  }



  template <int dim>
  void
  Supports<dim>::mark(DofMap &dof_map) const
  {
    for (const auto &prescribed : prescribed_)
      dof_map.prescribe(prescribed.dof);
    for (const auto &node : global_nodes_)
      for (const unsigned int dof : node.dofs)
        dof_map.prescribe(dof);
  }



  template <int dim>
  void
  Supports<dim>::set_global(const double       time,
                            const unsigned int derivative,
                            DofVector         &vector) const
  {
    if (global_nodes_.empty())
      return;
    const auto values = global_run_->values(time, derivative);
    for (unsigned int n = 0; n < values.size(); ++n)
      for (unsigned int c = 0; c < dim; ++c)
        vector[global_nodes_[n].dofs[c]] = values[n][c];
  }



  template <int dim>
  void
  Supports<dim>::set_displacements(const double time,
                                   DofVector   &displacement) const
  {
    set_global(time, 0, displacement);
    for (const auto &[dof, point, motion] : prescribed_)
      displacement[dof] = motion ? motion->value(point, time) : 0.;
  }



  template <int dim>
  void
  Supports<dim>::set_rates(const double time,
                           const double step_size,
                           DofVector   &velocity,
                           DofVector   &acceleration) const
  {
    set_global(time, 1, velocity);
    set_global(time, 2, acceleration);
    const double difference = 0.01 * step_size;
    for (const auto &[dof, point, motion] : prescribed_)
      {
        velocity[dof] = acceleration[dof] = 0.;
        if (!motion || !motion->depends_on_time())
          continue;
        const MotionRates rates =
          motion_rates([&point = point, motion = motion](
                         const double t) { return motion->value(point, t); },
                       time,
                       difference);
        velocity[dof]     = rates.velocity;
        acceleration[dof] = rates.acceleration;
      }
  }



  template <int dim>
  bool
  Supports<dim>::are_fixed() const
  {
    return global_nodes_.empty() &&
           std::none_of(prescribed_.begin(),
                        prescribed_.end(),
                        [](const auto &prescribed) {
                          return prescribed.motion &&
                                 prescribed.motion->depends_on_time();
                        });
  }



#define INSTANTIATE(dim) template class Supports<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
