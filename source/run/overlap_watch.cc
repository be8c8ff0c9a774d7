#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/run/overlap_watch.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <map>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    unsigned int
    number_of(const Body<dim> &body, const SolidModel<dim> &solid)
    {
      unsigned int b = 0;
      while (solid.parts()[b].body.get() != &body)
        ++b;
      return b;
    }

    // More than its elements, its penetrations and what is wanted explain, m;
    // negative: less.
    template <int dim>
    double
    excess(const Overlap<dim> &overlap, const double allowed)
    {
      const double limit =
        overlap.is_pressed ?
          std::min(2. * overlap.length, 0.5 * overlap.radius) :
          2. * overlap.sagitta + 1e-3 * overlap.length;
      return overlap.depth - limit - allowed;
    }

    // The part of an overlap between nodes that carry forces which curved
    // pieces do not explain, in lengths of the elements.
    template <int dim>
    double
    unexplained(const Overlap<dim> &overlap, const double allowed)
    {
      return (overlap.depth - 2. * overlap.sagitta - allowed) / overlap.length;
    }

    // Beyond it forces are those of other shapes, in lengths of the elements.
    constexpr double doubtful = 0.05;

    template <int dim>
    double
    shortest_piece(const ContactModel<dim> &contact)
    {
      double shortest = std::numeric_limits<double>::infinity();
      for (const auto &pair : contact.pairs())
        for (const auto &face : pair.surface.faces)
          for (unsigned int a = 1; a < face.size(); ++a)
            shortest = std::min(shortest,
                                pair.surface.nodes[face[0]].point.distance(
                                  pair.surface.nodes[face[a]].point));
      return shortest;
    }
  } // namespace



  template <int dim>
  OverlapWatch<dim>::OverlapWatch(const Problem<dim> &problem)
    : problem_(problem)
    , allowed_(problem.contact->pairs().size())
    , shortest_piece_(shortest_piece(*problem.contact))
  {
    const auto &pairs = problem.contact->pairs();
    for (const auto &pair : pairs)
      {
        // A deformable target is BODY.BOUNDARY; names have no dots.
        const std::string name = pair.target->name();
        const std::size_t dot  = name.find('.');
        targets_.emplace_back();
        if (dot == std::string::npos)
          continue;
        const Body<dim> &body =
          problem.solid->body(name.substr(0, dot), "Contact / Pairs");
        targets_.back() = {number_of(body, *problem.solid),
                           contactor_surface(body, name.substr(dot + 1))};
      }
    // With the supports in their place.
    DofVector start(problem.initial_displacement);
    problem.solid->apply_supports(0., start);
    const Configuration configuration = {start, 0.};
    const auto          found         = find(configuration, {}, allowed_);
    for (unsigned int p = 0; p < found.size(); ++p)
      if (found[p] && problem.contact_parameters.of_pairs[p].overclosure ==
                        Overclosure::refuse)
        throw InputError("Contact / Pairs", in_words(pairs[p], *found[p], 0.));
      else if (found[p])
        allowed_[p] = found[p]->depth;
    remember(configuration);
  }



  template <int dim>
  void
  OverlapWatch<dim>::remember(const Configuration &configuration)
  {
    displacement_ = configuration.displacement;
    placements_.clear();
    for (const auto &body : problem_.rigid_bodies)
      placements_.push_back(body->placement(configuration));
  }



  template <int dim>
  bool
  OverlapWatch<dim>::is_due(const Configuration &configuration) const
  {
    double motion = 0.;
    for (unsigned int b = 0; b < placements_.size(); ++b)
      {
        const auto now = problem_.rigid_bodies[b]->placement(configuration);
        motion =
          std::max(motion,
                   (now.translation - placements_[b].translation).norm() +
                     (now.rotation - placements_[b].rotation).norm() *
                       problem_.contact->extent());
      }
    double of_nodes = 0.;
    for (unsigned int i = 0; i < problem_.solid->dof_map().n_body_dofs(); ++i)
      of_nodes =
        std::max(of_nodes,
                 std::abs(configuration.displacement[i] - displacement_[i]));
    return motion + of_nodes > 0.25 * shortest_piece_;
  }



  template <int dim>
  void
  OverlapWatch<dim>::refuse(const Configuration &configuration)
  {
    remember(configuration);
    const ContactState &contact = *configuration.contact;
    std::vector<double> allowed(allowed_);
    for (unsigned int p = 0; p < allowed.size(); ++p)
      {
        const auto &pair        = problem_.contact->pairs()[p];
        double      penetration = 0., recession = 0.;
        for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
          {
            const unsigned int k = pair.first_contact + n;
            penetration          = std::max(penetration, -contact.gaps[k]);
            recession            = std::max(recession, contact.recessions[k]);
          }
        allowed[p] += penetration + recession;
      }
    const auto found = find(configuration, contact.forces.normal, allowed);
    for (unsigned int p = 0; p < found.size(); ++p)
      if (found[p])
        throw ComputationError(in_words(problem_.contact->pairs()[p],
                                        *found[p],
                                        configuration.time));
  }



  template <int dim>
  std::vector<std::optional<Overlap<dim>>>
  OverlapWatch<dim>::find(const Configuration       &configuration,
                          const std::vector<double> &normal_forces,
                          const std::vector<double> &allowed)
  {
    std::map<unsigned int, OccupiedRegion<dim>> regions;
    const auto region = [&](const unsigned int b) -> const auto &
    {
      return regions
        .try_emplace(b,
                     *problem_.solid->parts()[b].body,
                     configuration.displacement)
        .first->second;
    };
    std::vector<std::optional<Overlap<dim>>> worst(targets_.size());
    for (unsigned int p = 0; p < targets_.size(); ++p)
      {
        const auto &pair = problem_.contact->pairs()[p];
        // A surface is always in touch with itself.
        const unsigned int own = number_of(*pair.body, *problem_.solid);
        if (targets_[p] && targets_[p]->body == own)
          continue;
        const auto overlaps = find_overlaps<dim>(
          {pair,
           region(own),
           targets_[p] ? &region(targets_[p]->body) : nullptr,
           targets_[p] ? &targets_[p]->surface : nullptr,
           configuration,
           normal_forces});
        for (const auto &overlap : overlaps)
          {
            note_pressed(p, overlap, allowed[p], configuration.time);
            const double too_much = excess(overlap, allowed[p]);
            if (too_much > 0. &&
                (!worst[p] || too_much > excess(*worst[p], allowed[p])))
              worst[p] = overlap;
          }
      }
    return worst;
  }



  template <int dim>
  void
  OverlapWatch<dim>::note_pressed(const unsigned int  pair,
                                  const Overlap<dim> &overlap,
                                  const double        allowed,
                                  const double        time)
  {
    const double share = unexplained(overlap, allowed);
    if (overlap.is_pressed && (!deepest_ || share > deepest_->share))
      deepest_ = {pair, share, overlap.place, time};
  }



  template <int dim>
  std::string
  OverlapWatch<dim>::summary() const
  {
    if (!deepest_ || deepest_->share < doubtful)
      return "";
    const auto        &pair = problem_.contact->pairs()[deepest_->pair];
    std::ostringstream message;
    message << "warning: at t = " << deepest_->time << " s body "
            << pair.body->name() << " and \"" << pair.target->name()
            << "\" lie in each other at (" << deepest_->place << "), by "
            << std::setprecision(2) << 100. * deepest_->share
            << " % of an element of the contactor between its nodes. Forces "
               "there are those of other shapes: a finer mesh of body "
            << pair.body->name() << " there helps"
            << (dim == 2 && pair.constraint != ContactConstraint::mortar ?
                  ", or Contact / Constraint = mortar." :
                  ".");
    return message.str();
  }



  template <int dim>
  std::string
  OverlapWatch<dim>::in_words(const ContactPair<dim> &pair,
                              const Overlap<dim>     &overlap,
                              const double            time) const
  {
    std::ostringstream message;
    message << "at t = " << time << " s body " << pair.body->name() << " and \""
            << pair.target->name() << "\" lie in each other at ("
            << overlap.place << "), by " << overlap.depth << " m, and "
            << (overlap.is_pressed ?
                  "the contact forces nearby do not keep them apart" :
                  "no contact keeps them apart")
            << ": the nodes of the contactor, " << overlap.length
            << " m apart there, do not see it. Make the mesh of body "
            << pair.body->name() << " finer there";
    const bool is_rigid = pair.target->name().find('.') == std::string::npos;
    if (!is_rigid)
      message << ", or swap contactor and target";
    if (dim == 2 && pair.constraint != ContactConstraint::mortar)
      message << ", or set Contact / Constraint = mortar";
    message << (time > 0. ? "; take shorter steps where one passes through the "
                            "other." :
                            "; move them apart where they begin like this.");
    return message.str();
  }



#define INSTANTIATE(dim) template class OverlapWatch<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
