// Curves over the levels of a grid's dimension, in time and against the level.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/report/html_report.hpp"
#include "analysis/report/html_text.hpp"

namespace cagetol {
namespace {

/// What a figure shows and which figures of Xin et al. 2024 it stands beside.
struct ResponseFigure {
  const char *name, *caption;
};

constexpr ResponseFigure kFigures[] = {
    {"response_cage_stress",
     "Largest equivalent (von Mises) stress in the cage (Figs. 8 and 16). Peaks are contacts of "
     "rollers with bars; the right-hand side says whether the level moves their mean or their "
     "fluctuation."},
    {"orbit_cage",
     "Paths of the cage's centre, one column for each level (six of them where there are more), "
     "the first runs of each in different colours (Figs. 9 and 17). Look for the size of the path "
     "and whether it circles; runs that differ as much as levels do mean that the level says "
     "little."},
    {"response_cage_velocity",
     "Speed of the cage's centre in the radial plane (Fig. 10). A wide fluctuation is a cage that "
     "is thrown about rather than one that circles."},
    {"response_cage_speed",
     "Rotational speed of the cage (Figs. 11 and 18). A mean below pure rolling is cage slip."},
    {"orbit_ring",
     "Paths of the inner ring's centre (Figs. 12 and 20). The arc comes from the rollers passing "
     "below the load; it hardly depends on the cage where the columns look alike."},
    {"response_ring_velocity", "Speed of the inner ring's centre (Fig. 13)."},
    {"response_ring_displacement",
     "Displacement of the inner ring along the load (Fig. 19): its mean is set by load and "
     "clearance, its ripple by the rollers passing."},
    {"response_ring_acceleration",
     "Acceleration of the inner ring (Fig. 21), at the stored instants; peaks between them are "
     "in the quantities."},
    {"response_roller_spin",
     "Spin of one roller about its own axis (Figs. 14 and 22). It drops where the roller leaves "
     "the load zone and is spun up again when it enters."},
    {"slip_bars",
     "Roller slip by level (Figs. 15 and 23): medians of the runs, with their 5 to 95 % range. "
     "Slip depends on the friction law's transition speeds."},
    {"response_quantities",
     "Every quantity the source speaks about, over the level: median of the runs, band from 5 to "
     "95 % of them. Bands that overlap all the way mean that the level is not felt in one run."},
};

std::string absent_text(const Json& report, const Json& history) {
  const Json& absent = history["absent"];
  if (std::find(absent.begin(), absent.end(), "cage_stress") == absent.end()) return {};
  const Json& scene = report["provenance"]["scene"];
  const bool rigid =
      scene.contains("cage") && scene["cage"].value("model", std::string("rigid")) == "rigid";
  return paragraph(
      rigid
          ? "The cage of these runs is rigid, so there are no stresses to show: Figs. 8 and 16 "
            "have no counterpart here. <code>scene.cage.model = \"flexible\"</code> computes them."
          : "No run has a cage stress, so Figs. 8 and 16 have no counterpart here.");
}

}  // namespace

std::string response_chapter(const Json& report, const FigureSet& figures) {
  const Json& response = report["response"];
  if (response.is_null()) return {};
  std::string body = paragraph(fmt::format(
      "Over the deviation of the {} from {}{}, {} levels.", escaped(response["name"]),
      rounded(response["nominal"]), unit_suffix(response["unit"]), response["levels"].size()));
  const Json& history = response["history"];
  if (history.is_null())
    body += paragraph(
        "The study keeps no time histories (<code>history.points</code>), so there are no curves "
        "over time.");
  else
    body += absent_text(report, history) +
            note(
                "Curves: the first run of the lowest, the nominal and the highest level, in the "
                "band that holds 90 % of the runs at each instant. Beside them, against the "
                "level: mean and standard deviation over time, median of the runs and 5 to 95 % "
                "of them. Figure numbers are those of Xin et al., Appl. Sci. 2024, 14, 9433.");
  for (const ResponseFigure& figure : kFigures)
    body += figure_html(figures, figure.name, figure.caption);
  return chapter("response", "Response to the " + escaped(response["name"]), body);
}

}  // namespace cagetol
