#include <signorini/contact/deforming_curve.h>
#include <signorini/contact/facet_target.h>
#include <signorini/contact/rigid_target.h>
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/named_list.h>
#include <signorini/input/nearest_name.h>
#include <signorini/run/contact_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    const std::string entry = "Contact / Pairs";

    // The two sides of a pair, and the word between them.
    struct PairText
    {
      std::string text, contactor, word, target;
    };

    PairText
    split_pair(const std::string &text)
    {
      for (const std::string word : {" on ", " with "})
        {
          const std::size_t at = text.find(word);
          if (at == std::string::npos)
            continue;
          const PairText pair = {text,
                                 Utilities::trim(text.substr(0, at)),
                                 Utilities::trim(word),
                                 Utilities::trim(
                                   text.substr(at + word.size()))};
          if (pair.contactor.find('.') != std::string::npos &&
              !pair.target.empty())
            return pair;
        }
      throw InputError(
        entry,
        "found \"" + text +
          "\". Write \"BODY.BOUNDARY on RIGID BODY\", for "
          "instance \"beam.bottom on floor\", or \"BODY.BOUNDARY "
          "on BODY.BOUNDARY\".");
    }

    // One deformable side of a pair.
    template <int dim>
    struct Side
    {
      const Body<dim> *body;
      std::string      boundary;
    };

    template <int dim>
    Side<dim>
    parse_side(const std::string &text, const SolidModel<dim> &solid)
    {
      const std::size_t dot = text.find('.');
      const Body<dim>  &body =
        solid.body(Utilities::trim(text.substr(0, dot)), entry);
      const std::string boundary = Utilities::trim(text.substr(dot + 1));
      try
        {
          body.mesh().boundary(boundary);
        }
      catch (const InputError &error)
        {
          std::string text = error.text();
          text[0]          = std::tolower(text[0]);
          throw InputError(entry, "body " + body.name() + ": " + text);
        }
      return {&body, boundary};
    }

    template <int dim>
    std::unique_ptr<const ContactTarget<dim>>
    deforming_target(const Side<dim>        &side,
                     const SolidModel<dim>  &solid,
                     const ContactConstraint constraint,
                     SurfaceInterpolation    surface)
    {
      if (constraint == ContactConstraint::mortar)
        surface.kind = SurfaceInterpolation::Kind::trace;
      if constexpr (dim == 2)
        return std::make_unique<DeformingCurve>(*side.body,
                                                side.boundary,
                                                solid.dof_map(),
                                                surface);
      else
        return std::make_unique<FacetTarget>(*side.body,
                                             side.boundary,
                                             surface);
    }

    // Of the share of a surface that belongs to a node, m^2.
    template <int dim>
    double
    mean_area(const Side<dim> &side)
    {
      const auto surface = contactor_surface(*side.body, side.boundary);
      double     sum     = 0.;
      for (const double area : surface.areas)
        sum += area;
      return sum / surface.areas.size();
    }

    // Automatic choice: the finer side carries the constraints; of two as
    // fine, the first.
    template <int dim>
    bool
    is_finer(const Side<dim> &a, const Side<dim> &b)
    {
      return mean_area(a) < mean_area(b) * (1. - 1e-6);
    }

    // Mortar takes the surface as the elements have it, and a spline makes a
    // curved one smooth.
    template <int dim>
    bool
    is_flat(const Side<dim> &side)
    {
      constexpr double one_degree = 0.01745;
      const auto       surface = contactor_surface(*side.body, side.boundary);
      std::vector<Point<dim>> positions;
      for (const auto &node : surface.nodes)
        positions.push_back(node.point);
      const auto normals = node_normals(surface, positions);
      return std::all_of(normals.begin(),
                         normals.end(),
                         [&](const Tensor<1, dim> &normal) {
                           return normal * normals[0] > std::cos(one_degree);
                         });
    }

    // A target that is so much finer has nodes that no node of the contactor
    // holds back. Where surfaces strain one leaves the other over its edge, and
    // a node that does so at once takes its whole force along; a mean gap lets
    // go little by little.
    template <int dim>
    ContactConstraint
    constraint_for(const Side<dim>      &contactor,
                   const Side<dim>      &target,
                   const PairParameters &parameters)
    {
      constexpr double coarse = 1.2;
      if (parameters.constraint)
        return *parameters.constraint;
      const bool is_possible =
        dim == 2 && contactor.body->scalar_fe().degree <= 2 &&
        target.body->scalar_fe().degree <= 2 && is_flat(target);
      const bool strains =
        target.body->kinematics() == Kinematics::finite_strain;
      return is_possible && (strains || mean_area(contactor) >
                                          coarse * mean_area(target)) ?
               ContactConstraint::mortar :
               ContactConstraint::node_to_surface;
    }

    template <int dim>
    const RigidBody<dim> *
    find_rigid_body(
      const std::string                                  &name,
      const std::vector<std::unique_ptr<RigidBody<dim>>> &rigid_bodies)
    {
      for (const auto &rigid_body : rigid_bodies)
        if (rigid_body->name() == name)
          return rigid_body.get();
      return nullptr;
    }

    template <int dim>
    [[noreturn]] void
    throw_unknown_target(
      const std::string                                  &target,
      const std::vector<std::unique_ptr<RigidBody<dim>>> &rigid_bodies)
    {
      std::vector<std::string> names;
      for (const auto &rigid_body : rigid_bodies)
        names.push_back(rigid_body->name());
      throw InputError(entry,
                       "there is no rigid body \"" + target + "\"." +
                         did_you_mean(target, names) +
                         " The rigid bodies are: " + comma_separated(names) +
                         ". A deformable target is written BODY.BOUNDARY.");
    }

    // In the order of their bodies and boundaries, whatever the word between.
    template <int dim>
    void
    refuse_doubled_pairs(
      const std::vector<typename ContactModel<dim>::PairDescription> &pairs,
      const std::vector<std::string>                                 &texts)
    {
      std::map<std::string, std::string> known;
      for (unsigned int p = 0; p < pairs.size(); ++p)
        {
          const std::string sides = pairs[p].body->name() + "." +
                                    pairs[p].boundary + " on " +
                                    pairs[p].target->name();
          const auto [other, is_new] = known.emplace(sides, texts[p]);
          if (!is_new)
            throw InputError(entry,
                             "\"" + other->second + "\" and \"" + texts[p] +
                               "\" are the same pair. Remove one of them.");
        }
    }

    void
    refuse_friction_of_three_dimensions(const std::string &algorithm,
                                        const FrictionLaw &friction)
    {
      if (!friction.is_frictionless() &&
          (algorithm == "ando" || algorithm == "two step"))
        throw InputError(
          "Contact / Algorithm",
          algorithm + " needs a slip with a sign, as in two dimensions, but "
                      "there is friction in three. Set Algorithm = "
                      "semismooth Newton.");
    }

    template <int dim>
    typename ContactModel<dim>::PairDescription
    parse_pair(const PairText                                     &pair,
               const SolidModel<dim>                              &solid,
               const std::vector<std::unique_ptr<RigidBody<dim>>> &rigid_bodies,
               const PairParameters                               &parameters)
    {
      const std::string name =
        pair.contactor.substr(0, pair.contactor.find('.'));
      if (find_rigid_body(name, rigid_bodies))
        throw InputError(entry,
                         "found \"" + pair.text + "\", but \"" + name +
                           "\" is a rigid body. It stands after \"on\": write "
                           "\"BODY.BOUNDARY on " +
                           name + "\".");
      Side<dim> contactor = parse_side(pair.contactor, solid);
      std::unique_ptr<const ContactTarget<dim>> target;
      const Body<dim>                          *target_body = nullptr;
      ContactConstraint                         constraint =
        parameters.constraint.value_or(ContactConstraint::node_to_surface);
      if (pair.target.find('.') != std::string::npos)
        {
          Side<dim> other = parse_side(pair.target, solid);
          if (pair.word == "with" && is_finer(other, contactor))
            std::swap(contactor, other);
          constraint = constraint_for(contactor, other, parameters);
          target =
            deforming_target(other, solid, constraint, parameters.surface);
          target_body = other.body;
        }
      else
        {
          const auto *rigid_body = find_rigid_body(pair.target, rigid_bodies);
          if (rigid_body == nullptr)
            throw_unknown_target(pair.target, rigid_bodies);
          target = std::make_unique<RigidTarget<dim>>(*rigid_body);
        }
      if (dim == 3 && constraint == ContactConstraint::mortar)
        throw InputError("Contact / Constraint",
                         "mortar is for 2-D; in 3-D use node to surface.");
      for (const Body<dim> *const body : {contactor.body, target_body})
        if (body && body->scalar_fe().degree > 2 &&
            constraint == ContactConstraint::mortar)
          throw InputError(
            "Contact / Constraint",
            "mortar is for elements of degree 1 and 2, but body " +
              body->name() + " has degree " +
              std::to_string(body->scalar_fe().degree) + ".");
      return {contactor.body,
              contactor.boundary,
              std::move(target),
              parameters.law,
              constraint};
    }
  } // namespace



  void
  ContactParameters::declare_parameters(const std::vector<std::string> &pairs,
                                        ParameterHandler               &prm)
  {
    prm.enter_subsection("Contact");
    prm.declare_entry("Pairs",
                      "",
                      Patterns::Anything(),
                      "What may touch, separated by commas: `BODY.BOUNDARY on "
                      "RIGID BODY', `BODY.BOUNDARY on BODY.BOUNDARY' (the "
                      "first is the contactor, whose nodes do not penetrate "
                      "the second, the target), or `... with ...': the finer "
                      "one is the contactor. A boundary may touch itself. Each "
                      "pair may have a section `Pair' with its text as here.");
    PairParameters::declare_parameters(pairs, prm);
    AlgorithmParameters::declare_parameters(prm);
    prm.declare_entry("Relative penalty stiffness",
                      "0",
                      Patterns::Double(0.),
                      "Penalty stiffness as a multiple of the static "
                      "stiffness of the bodies where they are loaded; 0: "
                      "Penalty stiffness counts. Unit: 1.");
    prm.declare_entry("Force tolerance",
                      "1e-4",
                      Patterns::Double(1e-12, 0.1),
                      "A step over a curved target has converged when "
                      "contact forces change by less than this part of the "
                      "largest [MC, sec. 5.2: 0.01 %]. Unit: 1.");
    prm.leave_subsection();
  }



  EntryConditions
  ContactParameters::conditions()
  {
    EntryConditions list = AlgorithmParameters::conditions();
    list.push_back(
      contradiction(read_with({"Relative penalty stiffness"},
                              "Algorithm",
                              {"penalty", "augmented Lagrangian"})));
    list.push_back(contradiction({{"Penalty stiffness"},
                                  "Relative penalty stiffness",
                                  [](const EntryCondition::Choice &relative) {
                                    return relative.is_default;
                                  },
                                  "Remove the Relative penalty stiffness",
                                  true}));
    for (const EntryCondition &condition : PairParameters::conditions())
      list.push_back(condition);
    list.push_back(read_if_set(
      {"Algorithm", "Force tolerance", "Friction coefficient", "Overclosure"},
      "Pairs"));
    return list;
  }



  ContactParameters
  ContactParameters::parse(const Constants &constants, ParameterHandler &prm)
  {
    ContactParameters parameters;
    prm.enter_subsection("Contact");
    parameters.pairs     = split_list(prm.get("Pairs"), ',');
    parameters.algorithm = AlgorithmParameters::parse(prm);
    parameters.relative_penalty_stiffness =
      prm.get_double("Relative penalty stiffness");
    parameters.force_tolerance = prm.get_double("Force tolerance");
    for (const auto &pair : parameters.pairs)
      parameters.of_pairs.push_back(
        PairParameters::parse(pair, constants, prm));
    prm.leave_subsection();
    return parameters;
  }



  template <int dim>
  std::unique_ptr<ContactModel<dim>>
  create_contact_model(
    const ContactParameters                            &parameters,
    const SolidModel<dim>                              &solid,
    const std::vector<std::unique_ptr<RigidBody<dim>>> &rigid_bodies)
  {
    std::vector<typename ContactModel<dim>::PairDescription> pairs;
    for (unsigned int p = 0; p < parameters.pairs.size(); ++p)
      pairs.push_back(parse_pair(split_pair(parameters.pairs[p]),
                                 solid,
                                 rigid_bodies,
                                 parameters.of_pairs[p]));
    refuse_doubled_pairs<dim>(pairs, parameters.pairs);
    if (dim == 3)
      for (const PairParameters &pair : parameters.of_pairs)
        refuse_friction_of_three_dimensions(parameters.algorithm.algorithm,
                                            pair.law.friction());
    return std::make_unique<ContactModel<dim>>(std::move(pairs),
                                               solid.dof_map());
  }



#define INSTANTIATE(dim)                                            \
  template std::unique_ptr<ContactModel<dim>> create_contact_model( \
    const ContactParameters &,                                      \
    const SolidModel<dim> &,                                        \
    const std::vector<std::unique_ptr<RigidBody<dim>>> &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
