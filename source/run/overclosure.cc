#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/run/overclosure.h>

#include <limits>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // What counts as rounding of a gap: a part of the size of the surface.
    template <int dim>
    double
    rounding_of(const ContactPair<dim> &pair)
    {
      double extent = 0.;
      for (const auto &node : pair.contactor.nodes)
        extent =
          std::max(extent, node.point.distance(pair.contactor.nodes[0].point));
      return 1e-10 * extent;
    }

    template <int dim>
    [[noreturn]] void
    refuse(const ContactPair<dim> &pair,
           const unsigned int      node,
           const double            depth)
    {
      // A deformable target is BODY.BOUNDARY; names have no dots.
      const bool is_rigid = pair.target->name().find('.') == std::string::npos;
      std::ostringstream message;
      message << "at t = 0 the node of body " << pair.body->name() << " at ("
              << pair.contactor.nodes[node].point << ") lies " << depth
              << " m inside of \"" << pair.target->name()
              << "\". Move them apart, "
              << (is_rigid ? "turn the normal (plane) or the Side (circle, "
                             "sphere, cylinder) round, " :
                             "")
              << "or set Contact / Overclosure = press fit or adjust.";
      throw InputError("Contact / Pairs", message.str());
    }
  } // namespace



  template <int dim>
  void
  treat_overclosure(const std::vector<PairParameters> &parameters,
                    const DofVector                   &displacement,
                    ContactModel<dim>                 &contact)
  {
    const auto points = contact.evaluate({displacement, 0.});
    for (unsigned int p = 0; p < contact.pairs().size(); ++p)
      {
        const auto         &pair    = contact.pairs()[p];
        double              deepest = 0.;
        unsigned int        place   = 0;
        std::vector<double> depths(pair.contactor.nodes.size());
        for (unsigned int n = 0; n < depths.size(); ++n)
          {
            depths[n] = std::max(0., -points[pair.first_contact + n].gap);
            if (depths[n] > deepest)
              {
                deepest = depths[n];
                place   = n;
              }
          }
        if (parameters[p].overclosure == Overclosure::press_fit)
          contact.set_offset(pair, {depths, parameters[p].press_fit_end});
        else if (parameters[p].overclosure == Overclosure::adjust)
          contact.set_offset(pair,
                             {depths, std::numeric_limits<double>::infinity()});
        else if (deepest > rounding_of(pair))
          refuse(pair, place, deepest);
      }
    const std::string held = contact.held_penetration({displacement, 0.});
    if (!held.empty())
      throw InputError("Contact / Pairs", held);
  }



  template <int dim>
  std::string
  describe_pairs(const ContactModel<dim> &contact,
                 const DofVector         &displacement)
  {
    std::ostringstream text;
    const auto         points = contact.evaluate({displacement, 0.});
    for (const auto &pair : contact.pairs())
      {
        const auto normals =
          node_normals(pair.surface,
                       node_positions(pair.surface.nodes, displacement));
        double       smallest = std::numeric_limits<double>::infinity();
        double       cosine   = 0.;
        unsigned int n_seen   = 0;
        for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
          {
            const auto &point = points[pair.first_contact + n];
            if (!point.is_in_reach())
              continue;
            ++n_seen;
            // Where they are nearest the surfaces should face each other.
            if (point.gap < smallest)
              {
                smallest = point.gap;
                cosine   = point.normal * normals[pair.node_of_candidate[n]];
              }
          }
        text << "contact " << pair.name << ": " << pair.contactor.nodes.size()
             << " candidate nodes, ";
        if (n_seen == 0)
          text << "none in reach of the target";
        else
          text << n_seen << " in reach, smallest gap " << smallest
               << " m, normals there "
               << (cosine < -0.5 ? "face each other" :
                   cosine < 0.   ? "are askew" :
                                   "point the same way: is a side turned round?");
        if (pair.constraint == ContactConstraint::mortar)
          text << "; mortar";
        text << '\n';
      }
    return text.str();
  }



#define INSTANTIATE(dim)                                                      \
  template void        treat_overclosure(const std::vector<PairParameters> &, \
                                         const DofVector &,                   \
                                         ContactModel<dim> &);                \
  template std::string describe_pairs(const ContactModel<dim> &,              \
                                      const DofVector &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
