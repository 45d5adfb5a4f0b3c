// The chapter of a flexible cage.
#include <fmt/format.h>

#include "analysis/report/html_report.hpp"
#include "analysis/report/html_text.hpp"

namespace cagetol {
namespace {

std::string accuracy_text(const Json& accuracy) {
  const std::string target = fmt::format(
      "wanted: within {} on scattered pockets, {} where all deviate to the end of what the model "
      "covers",
      percent(accuracy["target_scattered"]), percent(accuracy["target_extreme"]));
  if (accuracy["samples_checked"] == 0)
    return paragraph(
        "No sample's cage was also solved in full (<code>cage_check_share</code>): "
        "nothing is known of the error of the per-sample model here; " +
        target + ".");
  return paragraph(fmt::format(
      "The cages of <b>{}</b> of {} samples, chosen at random, were also solved in full: the "
      "per-sample model's frequencies up to 20 kHz are off by <b>{:.3f} %</b> at most, {:.3f} % on "
      "average over these cages ({}).",
      rounded(accuracy["samples_checked"]), rounded(accuracy["samples"]),
      100 * accuracy["largest_error"].get<double>(), 100 * accuracy["mean_error"].get<double>(),
      target));
}

std::string thickness_text(const Json& thickness) {
  if (thickness.is_null()) return {};
  return paragraph(fmt::format(
      "The diameters of these cages deviate by up to {} of the thickness, bore and outside "
      "together. Contacts, clearances and mass follow them; the elasticity stays that of nominal "
      "diameters, which leaves errors of up to {} of frequencies, {} of the bars' compliance and "
      "{} of stress.",
      percent(thickness["largest_share"]), percent(thickness["frequency_error"]),
      percent(thickness["compliance_error"]), percent(thickness["stress_error"])));
}

std::string peak_text(const Json& peak, const FigureSet& figures) {
  if (peak.is_null())
    return note(
        "No stress field is drawn: no sample has a stress yet, or the last step of the sweep, "
        "which stores the field, is missing. Start the same sweep again to make it.");
  const Json& at = peak["full"];
  return paragraph(fmt::format(
             "The largest stress of all samples: <b>{} MPa</b> at a stress station of sample {}, "
             "{} ms after its start, beside pocket {} ({}). The whole field recovered at that "
             "instant has its peak of <b>{} MPa</b> at {:.1f}&deg;, x = {:.2f} mm, radius {:.2f} "
             "mm. The same field for ParaView: <code>{}</code>",
             rounded(peak["stations_MPa"]), peak["sample"].dump(), rounded(peak["time_ms"]),
             peak["pocket"].dump(), escaped(peak["station"].get<std::string>()),
             rounded(at["stress_MPa"]), at["angle_deg"].get<double>(), at["axial_mm"].get<double>(),
             at["radius_mm"].get<double>(), escaped(peak["replay"].get<std::string>()))) +
         figure_html(figures, "cage_stress",
                     fmt::format("Von Mises stress of the whole cage at the instant of the largest "
                                 "stress, its surfaces laid flat; the circle marks the peak; "
                                 "colours rise with the square root of the stress. "
                                 "Pockets are numbered from 0; the walls are those of pocket {}.",
                                 peak["pocket"].dump()));
}

}  // namespace

std::string cage_chapter(const Json& report, const FigureSet& figures) {
  const Json& cage = report["cage"];
  if (cage.is_null()) return {};
  return chapter("cage", "Flexible cage",
                 peak_text(cage["peak"], figures) + accuracy_text(cage["accuracy"]) +
                     thickness_text(cage["thickness"]));
}

}  // namespace cagetol
