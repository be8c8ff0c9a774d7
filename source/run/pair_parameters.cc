#include <signorini/input/input_error.h>
#include <signorini/input/name_table.h>
#include <signorini/input/named_list.h>
#include <signorini/input/number_text.h>
#include <signorini/run/pair_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <functional>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Without a value the meshes decide.
    const NameTable<std::optional<ContactConstraint>> &
    constraints()
    {
      static const NameTable<std::optional<ContactConstraint>> table = {
        {"automatic", std::nullopt},
        {"node to surface", ContactConstraint::node_to_surface},
        {"mortar", ContactConstraint::mortar}};
      return table;
    }

    const NameTable<SurfaceInterpolation::Kind> &
    surfaces()
    {
      static const NameTable<SurfaceInterpolation::Kind> table = {
        {"spline", SurfaceInterpolation::Kind::spline},
        {"facets", SurfaceInterpolation::Kind::facets}};
      return table;
    }

    const NameTable<CurveWeights::Knots> &
    knots()
    {
      static const NameTable<CurveWeights::Knots> table = {
        {"centripetal", CurveWeights::Knots::centripetal},
        {"uniform", CurveWeights::Knots::uniform}};
      return table;
    }

    const NameTable<Overclosure> &
    overclosures()
    {
      static const NameTable<Overclosure> table = {
        {"refuse", Overclosure::refuse},
        {"press fit", Overclosure::press_fit},
        {"adjust", Overclosure::adjust}};
      return table;
    }

    struct Entry
    {
      std::string name;
      std::string default_value;
      std::string pattern; // alternatives of a selection; empty: a number
      std::string documentation;
    };

    const std::vector<Entry> &
    entries()
    {
      static const std::vector<Entry> list = {
        {"Constraint",
         "automatic",
         constraints().names(),
         "automatic: node to surface; but mortar in 2-D on a flat deforming "
         "target, with finite strain, where surfaces leave each other over "
         "edges, and where the contactor is coarser, so that nodes of the "
         "target would go through between its own. node to surface: the gap of each contactor node is constrained. "
         "mortar (2-D): the mean gap over the share of the surface that "
         "belongs to each node, so that a uniform pressure passes through "
         "meshes that do not match."},
        {"Surface",
         "spline",
         surfaces().names(),
         "A deforming target of node to surface: splines through its nodes, or "
         "straight facets between them. mortar takes the boundary as the "
         "elements have it. In 3-D always facets, whose normals go over into "
         "each other."},
        {"Knots",
         "centripetal",
         knots().names(),
         "Parameters of the nodes of a spline, which decide how it swings "
         "between nodes at unequal distances."},
        {"Feature angle",
         "40",
         "",
         "Where a deforming target turns by more than this between two nodes, "
         "its spline has a corner. Unit: degrees."},
        {"Search distance",
         "10",
         "",
         "A contactor node sees a deforming target up to this distance, in "
         "lengths of its longest piece. Unit: 1."},
        {"Search depth",
         "3",
         "",
         "A contactor node deeper inside of a deforming target does not "
         "belong to that side of it; in lengths of its longest piece. Unit: "
         "1."},
        {"Overclosure",
         "refuse",
         overclosures().names(),
         "Contactor nodes inside of their target at t = 0. refuse: an error. "
         "press fit: they are pushed out with strain until the Press fit end. "
         "adjust: the overlap counts as contact, free of strain."},
        {"Press fit end",
         "1",
         "",
         "The overclosure of a press fit is resolved linearly from t = 0 to "
         "this time. Unit: s."}};
      return list;
    }

    void
    declare(const Entry &entry, const bool in_pair, ParameterHandler &prm)
    {
      const std::string text =
        in_pair ? "As in Contact, for this pair. Empty: as there." :
                  entry.documentation;
      const std::string value = in_pair ? "" : entry.default_value;
      if (entry.pattern.empty())
        prm.declare_entry(entry.name, value, NumberText(), text);
      else
        prm.declare_entry(entry.name,
                          value,
                          Patterns::Selection(entry.pattern +
                                              (in_pair ? "|" : "")),
                          text);
    }

    // BODY.BOUNDARY after the word in the middle.
    bool
    has_deforming_target(const EntryCondition::Choice &pairs)
    {
      for (const std::string &pair : split_list(pairs.value, ','))
        if (pair.find('.') != pair.rfind('.'))
          return true;
      return false;
    }

  } // namespace



  void
  PairParameters::declare_parameters(const std::vector<std::string> &pairs,
                                     ParameterHandler               &prm)
  {
    ContactLaw::declare_parameters(/*in_pair=*/false, prm);
    for (const Entry &entry : entries())
      declare(entry, false, prm);
    for (const std::string &pair : pairs)
      {
        prm.enter_subsection("Pair " + pair);
        ContactLaw::declare_parameters(/*in_pair=*/true, prm);
        for (const Entry &entry : entries())
          declare(entry, true, prm);
        prm.leave_subsection();
      }
  }



  EntryConditions
  PairParameters::conditions()
  {
    EntryConditions list = {
      contradiction(read_with({"Press fit end"}, "Overclosure", {"press fit"})),
      read_with({"Surface", "Knots", "Feature angle"},
                "Constraint",
                {"automatic", "node to surface"}),
      read_with({"Knots", "Feature angle"}, "Surface", {"spline"}),
      {{"Surface", "Knots", "Feature angle", "Search distance", "Search depth"},
       "Pairs",
       &has_deforming_target,
       "Name a pair with a deforming target",
       false}};
    for (const EntryCondition &condition : ContactLaw::conditions())
      list.push_back(condition);
    return list;
  }



  PairParameters
  PairParameters::parse(const std::string &pair,
                        const Constants   &constants,
                        ParameterHandler  &prm)
  {
    const auto get_own = [&](const std::string &name) {
      prm.enter_subsection("Pair " + pair);
      const std::string own = prm.get(name);
      prm.leave_subsection();
      return own;
    };
    const auto get = [&](const std::string &name) {
      const std::string own = get_own(name);
      return own.empty() ? prm.get(name) : own;
    };
    const PairEntries entries = {get, [&](const std::string &name) {
                                   return (get_own(name).empty() ?
                                             "Contact / " :
                                             "Contact / Pair " + pair + " / ") +
                                          name;
                                 }};
    PairParameters    parameters;
    parameters.law           = ContactLaw::parse(constants, entries);
    parameters.constraint    = constraints().at(get("Constraint"));
    parameters.surface.kind  = surfaces().at(get("Surface"));
    parameters.surface.knots = knots().at(get("Knots"));
    // Facets are a target of node to surface.
    if (!parameters.constraint &&
        parameters.surface.kind == SurfaceInterpolation::Kind::facets)
      parameters.constraint = ContactConstraint::node_to_surface;
    parameters.surface.feature_angle = parse_positive(entries, "Feature angle");
    parameters.surface.reach = parse_positive(entries, "Search distance");
    parameters.surface.depth = parse_positive(entries, "Search depth");
    parameters.overclosure   = overclosures().at(get("Overclosure"));
    parameters.press_fit_end = parse_positive(entries, "Press fit end");
    return parameters;
  }
} // namespace Signorini
