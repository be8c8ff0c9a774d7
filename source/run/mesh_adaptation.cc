#include <signorini/contact/contact_zone.h>
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/named_errors.h>
#include <signorini/run/mesh_adaptation.h>
#include <signorini/run/result_columns.h>
#include <signorini/run/result_fields.h>
#include <signorini/solid/error_estimate.h>

#include <deal.II/base/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <limits>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Without a wish of the user.
    template <int dim>
    std::vector<std::string>
    default_quantities(const Problem<dim> &problem)
    {
      std::vector<std::string> names;
      for (const auto &pair : problem.contact->pairs())
        names.push_back("final(" + pair.name + ".pressure_max)");
      if (names.empty())
        for (const auto &part : problem.solid->parts())
          names.push_back("field_max(" + part.body->name() + ".von_mises)");
      return names;
    }

    const std::string quantities_entry = "Adaptivity / Quantities";

    // Of the longest edge, m.
    template <typename Cell>
    double
    width(const Cell &cell)
    {
      double longest = 0.;
      for (unsigned int l = 0; l < cell->n_lines(); ++l)
        longest = std::max(longest, cell->line(l)->diameter());
      return longest;
    }

    template <int dim, typename Cell>
    BoundingBox<dim>
    deformed_box(const Body<dim> &body,
                 const Cell      &cell,
                 const DofVector &displacement)
    {
      std::vector<Point<dim>> vertices;
      for (const unsigned int v : cell->vertex_indices())
        {
          Point<dim> vertex = cell->vertex(v);
          for (unsigned int c = 0; c < dim; ++c)
            vertex[c] +=
              displacement[body.first_dof() + cell->vertex_dof_index(v, c)];
          vertices.push_back(vertex);
        }
      return BoundingBox<dim>(vertices);
    }

    // How far the middle of a boundary face lies beside the curve or surface
    // that it stands for; the largest one of the cell, m.
    template <typename Cell>
    double
    sagitta(const Cell &cell)
    {
      double largest = 0.;
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          largest =
            std::max(largest, face->center(true).distance(face->center()));
      return largest;
    }

    template <int dim>
    bool
    reaches(BoundingBox<dim>               box,
            const double                   distance,
            const std::vector<Point<dim>> &points)
    {
      box.extend(distance);
      return std::any_of(points.begin(), points.end(), [&](const auto &point) {
        return box.point_inside(point);
      });
    }

    // Refining cells that do not matter settles nothing: the error has to fall,
    // too. It does not where only contact is refined and the rest is as it was.
    bool
    is_clearly_coarser(const MeshRecord &before, const MeshRecord &now)
    {
      return 2 * before.n_unknowns <= now.n_unknowns &&
             before.error >= 1.2 * now.error;
    }

    // The part of the larger one by which they differ.
    double
    relative_change(const double before, const double now)
    {
      const double scale = std::max(std::abs(before), std::abs(now));
      return scale > 0. ? std::abs(now - before) / scale : 0.;
    }
  } // namespace



  template <int dim>
  MeshAdaptation<dim>::MeshAdaptation(const Problem<dim> &problem)
    : parameters_(problem.adaptivity)
    , names_(parameters_.quantities.empty() ? default_quantities(problem) :
                                              parameters_.quantities)
    , passes_(problem.solid->parts().size())
  {
    History history;
    add_columns(result_columns(problem), history);
    const ResultFields<dim> fields(problem);
    with_entry(quantities_entry, [&] {
      for (const std::string &name : names_)
        {
          expressions_.emplace_back(name, problem.constants);
          expressions_.back().check_names(history, fields);
        }
    });
  }



  template <int dim>
  MeshRecord
  MeshAdaptation<dim>::measure(
    const Problem<dim>                     &problem,
    const State                            &state,
    const std::vector<std::vector<double>> &errors) const
  {
    MeshRecord record;
    double     error = 0.;
    for (unsigned int b = 0; b < errors.size(); ++b)
      {
        record.n_cells += errors[b].size();
        for (const double share : errors[b])
          error += share;
      }
    record.n_unknowns   = problem.solid->n_dofs();
    const double energy = state.energy.stored + state.energy.plastic;
    record.error        = energy > 0. ? std::sqrt(error / (2. * energy)) : 0.;

    History    history;
    const auto columns = result_columns(problem);
    add_columns(columns, history);
    append_row(columns, problem, state, history);
    ResultFields<dim> fields(problem);
    fields.show(state);
    for (const CheckExpression &expression : expressions_)
      record.quantities.push_back(with_entry(quantities_entry, [&] {
        return expression.evaluate(history, fields);
      }));
    record.change = change_since_coarser(record);
    return record;
  }



  template <int dim>
  double
  MeshAdaptation<dim>::change_since_coarser(const MeshRecord &now) const
  {
    double change = 0.;
    for (auto before = records_.rbegin(); before != records_.rend(); ++before)
      {
        for (unsigned int q = 0; q < names_.size(); ++q)
          change =
            std::max(change,
                     relative_change(before->quantities[q], now.quantities[q]));
        if (is_clearly_coarser(*before, now))
          return change;
      }
    return std::numeric_limits<double>::infinity();
  }



  template <int dim>
  bool
  MeshAdaptation<dim>::improve(const Problem<dim> &problem, const State &state)
  {
    std::vector<std::vector<double>> errors;
    Flags                            flags;
    for (const auto &part : problem.solid->parts())
      {
        errors.push_back(estimated_errors(*part.body, state.displacement));
        flags.emplace_back(errors.back().size(), false);
      }
    records_.push_back(measure(problem, state, errors));
    const bool contact_is_coarse = flag_contact(problem, state, flags);
    flag_errors(problem, errors, flags);
    const bool nothing_to_refine =
      std::all_of(flags.begin(), flags.end(), [](const auto &of_body) {
        return std::count(of_body.begin(), of_body.end(), true) == 0;
      });

    const MeshRecord &record = records_.back();
    if (record.change <= parameters_.settled_at && !contact_is_coarse)
      verdict_ = "the quantities have settled";
    else if (nothing_to_refine)
      verdict_ = "all cells to be refined have the Smallest cell already";
    else if (records_.size() >= parameters_.maximal_meshes)
      verdict_ = "not settled, but there are the Maximal meshes";
    else if (record.n_unknowns > parameters_.maximal_unknowns)
      verdict_ = "not settled, but there are more than the Maximal unknowns";
    if (!verdict_.empty())
      return false;
    for (unsigned int b = 0; b < flags.size(); ++b)
      passes_[b].push_back(flags[b]);
    return true;
  }



  template <int dim>
  bool
  MeshAdaptation<dim>::flag_contact(const Problem<dim> &problem,
                                    const State        &state,
                                    Flags              &flags) const
  {
    if (parameters_.cells_across_contact == 0)
      return false;
    bool is_coarse = false;
    for (const auto &pair : problem.contact->pairs())
      {
        const auto zone =
          contact_zone(pair, state.contact.forces.normal, state.displacement);
        const double largest =
          std::max(zone.width / parameters_.cells_across_contact,
                   2. * parameters_.smallest_cell);
        const auto near = near_misses(pair,
                                      state.contact.forces.normal,
                                      state.contact.gaps,
                                      state.displacement);
        for (unsigned int b = 0; b < flags.size(); ++b)
          {
            const Body<dim> &body = *problem.solid->parts()[b].body;
            for (const auto &cell : body.dof_handler().active_cell_iterators())
              {
                if (width(cell) <= largest)
                  continue;
                const auto   box = deformed_box(body, cell, state.displacement);
                const double sag = sagitta(cell);
                const auto   is_missed = [&](const auto &miss) {
                  const double distance =
                    miss.may_touch_beside ? 2. * miss.gap : 2. * sag;
                  return (miss.may_touch_beside || miss.gap < 2. * sag) &&
                         reaches(box, distance, {miss.point});
                };
                if (reaches(box, 0.5 * zone.width, zone.points) ||
                    std::any_of(near.begin(), near.end(), is_missed))
                  flags[b][cell->active_cell_index()] = is_coarse = true;
              }
          }
      }
    return is_coarse;
  }



  template <int dim>
  void
  MeshAdaptation<dim>::flag_errors(
    const Problem<dim>                     &problem,
    const std::vector<std::vector<double>> &errors,
    Flags                                  &flags) const
  {
    struct Share
    {
      double       error; // J
      unsigned int body, cell;
    };
    std::vector<Share> shares;
    double             total = 0.;
    for (unsigned int b = 0; b < errors.size(); ++b)
      for (const auto &cell : problem.solid->parts()[b]
                                .body->dof_handler()
                                .active_cell_iterators())
        if (width(cell) > 2. * parameters_.smallest_cell)
          {
            const unsigned int c = cell->active_cell_index();
            shares.push_back({errors[b][c], b, c});
            total += errors[b][c];
          }
    std::sort(shares.begin(), shares.end(), [](const auto &a, const auto &b) {
      return a.error > b.error;
    });
    double sum = 0.;
    for (const Share &share : shares)
      {
        if (sum >= parameters_.error_share * total)
          break;
        sum += share.error;
        flags[share.body][share.cell] = true;
      }
  }



  template <int dim>
  std::string
  MeshAdaptation<dim>::last_in_words() const
  {
    const MeshRecord  &record = records_.back();
    std::ostringstream text;
    text << "mesh " << records_.size() << ": " << record.n_cells << " cells, "
         << record.n_unknowns << " unknowns, estimated error "
         << std::setprecision(3) << 100. * record.error << " %";
    for (unsigned int q = 0; q < names_.size(); ++q)
      text << ", " << names_[q] << ' ' << std::setprecision(5)
           << record.quantities[q];
    if (std::isfinite(record.change))
      text << ", change " << std::setprecision(3) << 100. * record.change
           << " %";
    return text.str();
  }



  template <int dim>
  void
  MeshAdaptation<dim>::write(const std::string &path) const
  {
    std::ofstream file(path);
    file.precision(10);
    file << "mesh,cells,unknowns,estimated error";
    for (const std::string &name : names_)
      file << ",\"" << name << '"';
    file << '\n';
    for (unsigned int m = 0; m < records_.size(); ++m)
      {
        file << m + 1 << ',' << records_[m].n_cells << ','
             << records_[m].n_unknowns << ',' << records_[m].error;
        for (const double quantity : records_[m].quantities)
          file << ',' << quantity;
        file << '\n';
      }
    file.flush();
    if (!file)
      throw ComputationError("Cannot write \"" + path +
                             "\": is the disk full?");
  }



#define INSTANTIATE(dim) template class MeshAdaptation<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
