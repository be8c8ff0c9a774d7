#include <signorini/contact/archard_wear.h>
#include <signorini/input/input_error.h>

namespace Signorini
{
  using namespace dealii;

  void
  ArchardWear::declare_parameters(const bool in_pair, ParameterHandler &prm)
  {
    declare_pair_entry(
      "Wear coefficient",
      "0",
      "Archard's k: slip by a way s under the pressure p wears off the "
      "depth k p s / Hardness, of both surfaces together. The gap opens "
      "by it; meshes stay as they are, so that it has to be small beside "
      "the cells. 0: nothing wears. Unit: 1.",
      in_pair,
      prm);
    declare_pair_entry(
      "Hardness",
      "",
      "Hardness of the softer of the two bodies, for wear. Unit: Pa.",
      in_pair,
      prm);
  }



  EntryConditions
  ArchardWear::conditions()
  {
    return {read_if_set({"Hardness"}, "Wear coefficient")};
  }



  std::unique_ptr<const ContactProcess>
  ArchardWear::parse(const PairEntries &entries)
  {
    const double k = parse_not_negative(entries, "Wear coefficient");
    if (k == 0.)
      return nullptr;
    if (entries.get("Hardness").empty())
      throw InputError(entries.path("Hardness"),
                       "found nothing, but the Wear coefficient needs it. "
                       "Give the hardness of the softer body, in Pa.");
    return std::make_unique<const ArchardWear>(
      k / parse_positive(entries, "Hardness"));
  }



  const ContactProcess::Quantity &
  ArchardWear::quantity() const
  {
    static const Quantity quantity = {"worn_depth", "m", "worn_volume", "m^3"};
    return quantity;
  }
} // namespace Signorini
