#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "src/lubrication/lubricant.hpp"
#include "src/reading/scene_check.hpp"
#include "src/scene/materials.hpp"
#include "src/scene/pocket_outline.hpp"

namespace cagetol {
namespace {

void check_rings(const Scene& scene, const SceneCheck& check) {
  const auto& bearing = scene.bearing;
  check.require(bearing.bore_diameter < bearing.inner_raceway_diameter, "bearing.bore_diameter_mm",
                "the bore is not smaller than the inner raceway (" +
                    check.with_value("bearing.inner_raceway_diameter_mm") + ")",
                "correct the bore or the inner raceway diameter");
  check.require(bearing.outer_raceway_diameter < bearing.outside_diameter,
                "bearing.outer_raceway_diameter_mm",
                "the outer raceway is not smaller than the bearing's outside diameter (" +
                    check.with_value("bearing.outside_diameter_mm") + ")",
                "correct the outer raceway or the outside diameter");
  for (const double diameter : scene.roller.diameter) {
    const double clearance = bearing.outer_raceway_diameter - bearing.inner_raceway_diameter -
                             2 * diameter + bearing.internal_clearance;
    const std::string raceways = check.with_value("bearing.inner_raceway_diameter_mm") + ", " +
                                 check.with_value("bearing.outer_raceway_diameter_mm") + ", " +
                                 check.with_value("bearing.internal_clearance_um");
    check.require(std::abs(clearance) < diameter / 10, "roller.diameter_mm",
                  std::string("the rollers do not ") + (clearance < 0 ? "fit" : "fill the gap") +
                      " between the raceways: " + number_text(std::round(clearance * 1e9) / 1e6) +
                      " mm of diametral clearance (" + raceways + ")",
                  "give raceways with outer - inner = 2 roller diameters, and the clearance as "
                  "bearing.internal_clearance_um");
  }
  const double pitch_diameter =
      (bearing.inner_raceway_diameter + bearing.outer_raceway_diameter) / 2;
  check.require(bearing.outer_flanges == FlangeSides::none ||
                    (bearing.shoulder_diameter > pitch_diameter &&
                     bearing.shoulder_diameter < bearing.outer_raceway_diameter),
                "bearing.shoulder_diameter_mm",
                "the shoulders must stand between the pitch circle (" +
                    number_text(unit_value(pitch_diameter, 1e-3)) + " mm) and the outer raceway (" +
                    check.with_value("bearing.outer_raceway_diameter_mm") + ")",
                "correct the shoulder diameter, or set bearing.outer_flanges = \"none\"");
  check.require(bearing.inner_flanges == FlangeSides::none ||
                    (bearing.inner_flange_diameter < pitch_diameter &&
                     bearing.inner_flange_diameter > bearing.inner_raceway_diameter),
                "bearing.inner_flange_diameter_mm",
                "the inner ring's flanges must end between the inner raceway (" +
                    check.with_value("bearing.inner_raceway_diameter_mm") +
                    ") and the pitch circle (" + number_text(unit_value(pitch_diameter, 1e-3)) +
                    " mm)",
                "give their diameter, or set bearing.inner_flanges = \"none\"");
  check.require(scene.roller.length < bearing.width, "roller.length_mm",
                "the rollers are not shorter than the bearing is wide (" +
                    check.with_value("bearing.width_mm") + ")",
                "correct the roller length or the width");
}

void check_cage_between_rings(const Scene& scene, const SceneCheck& check) {
  const auto& cage = scene.cage;
  check.require(
      cage.inner_diameter < cage.outer_diameter, "cage.inner_diameter_mm",
      "the cage has no wall: its inner diameter is not smaller than its outer diameter (" +
          check.with_value("cage.outer_diameter_mm") + ")",
      "correct one of the two");
  check.require(cage.inner_diameter > scene.bearing.inner_raceway_diameter,
                "cage.inner_diameter_mm",
                "the cage does not fit over the inner ring (" +
                    check.with_value("bearing.inner_raceway_diameter_mm") + ")",
                "give a larger inner diameter of the cage");
  check.require(cage.inner_diameter > inner_land_diameter(scene.bearing), "cage.inner_diameter_mm",
                "the cage does not fit over the inner ring's flanges (" +
                    number_text(unit_value(inner_land_diameter(scene.bearing), 1e-3)) + " mm, " +
                    check.with_value("bearing.inner_land_diameter_mm") + ")",
                "give a larger inner diameter of the cage or smaller flanges");
  check.require(cage.outer_diameter < outer_land_diameter(scene.bearing), "cage.outer_diameter_mm",
                "the cage does not fit inside the outer ring's shoulders or its land, " +
                    number_text(unit_value(outer_land_diameter(scene.bearing), 1e-3)) + " mm (" +
                    check.with_value("bearing.shoulder_diameter_mm") + ")",
                "give a smaller outer diameter of the cage or larger shoulders");
  check.require(std::isnan(cage.land_offset) || cage.land_offset <= cage.width / 2,
                "cage.land_offset_mm",
                "the guide lands lie outside the cage (" + check.with_value("cage.width_mm") + ")",
                "give at most half the cage's width");
  if (!has_land_film(scene)) return;
  const Lubrication& film = scene.lubrication;
  const double on_diameter = cage.guidance == Guidance::inner
                                 ? cage.inner_diameter - inner_land_diameter(scene.bearing)
                                 : outer_land_diameter(scene.bearing) - cage.outer_diameter;
  const double clearance =
      std::isnan(cage.guide_clearance) ? on_diameter / 2 : cage.guide_clearance;
  check.require(4 * film.land_film_minimum < clearance, "lubrication.land_film_minimum_um",
                "roughness this high fills the guide clearance (" +
                    number_text(std::round(clearance * 1e9) / 1e3) + " um)",
                "give less than a quarter of the clearance");
  check.require(
      std::isnan(film.land_film_width) || film.land_film_width <= cage.width / 2,
      "lubrication.land_film_width_mm",
      "two lands this wide do not fit on the cage (" + check.with_value("cage.width_mm") + ")",
      "give at most half the cage's width");
}

/// "10.34 mm, say, leaves 0.1 mm": lips that hold a cage as loosely as pockets are wide.
std::string suggested_lips(const Scene& scene, int end) {
  const double radius = each(scene.roller.diameter, 0) / 2,
               play = std::max(each(scene.cage.pocket_width, 0) / 2 - radius, 0.05e-3);
  CageGeometry cage = scene.cage;
  cage.face_radius = kAuto;
  const double width = retention_width(cage, pitch_radius(scene.bearing), radius, end, play);
  return std::isnan(width) ? "" : " (" + in_mm(width) + ", say, leaves " + in_mm(play) + ")";
}

// Lips and curved faces of the bars.
void check_outline(const Scene& scene, const SceneCheck& check) {
  const auto& cage = scene.cage;
  const double pitch = pitch_radius(scene.bearing);
  const std::string retention[2] = {"cage.retention_width_inner_mm",
                                    "cage.retention_width_outer_mm"};
  const std::vector<double>* widths[2] = {&cage.retention_inner, &cage.retention_outer};
  const bool curved = !std::isnan(cage.face_radius);
  for (const int end : {0, 1})
    check.require(!curved || std::isnan(widths[end]->front()), retention[end],
                  "curved faces hold the rollers by their own ends (" +
                      check.with_value("cage.face_radius_mm") + ")",
                  "give either lips or a face radius");
  for (long j = 0; j < scene.bearing.roller_count; ++j) {
    const double radius = each(scene.roller.diameter, j) / 2, width = each(cage.pocket_width, j);
    const std::string pocket = "pocket " + std::to_string(j) + ": ";
    check.require(
        !curved || cage.face_radius >= width / 2 || scene.allow_interference, "cage.face_radius_mm",
        pocket + "a face more hollow than the pocket is wide (" +
            check.with_value("cage.pocket_width_mm") + ") would meet the roller at its ends",
        "give at least half the pocket's width");
    check.require(!curved || cage.face_radius > radius, "cage.face_radius_mm",
                  pocket + "the face is not wider than the roller (" +
                      check.with_value("roller.diameter_mm") + ")",
                  "give more than the roller's radius");
    const PocketOutline outline = pocket_outline(cage, pitch, j);
    for (const int end : {0, 1}) {
      if (!outline.end[end].lip) continue;
      check.require(each(*widths[end], j) < width, retention[end],
                    pocket + "lips narrow a pocket, and this is not narrower than the pocket (" +
                        check.with_value("cage.pocket_width_mm") + ")",
                    "give less than the pocket's width");
      const double play = radial_play(outline, pitch, radius, end);
      check.require(play > 0, retention[end],
                    pocket + "the lips pinch the roller by " + in_mm(-play) + " (" +
                        check.with_value("roller.diameter_mm") + ")",
                    "give a wider opening" + suggested_lips(scene, end) +
                        ", or a cage that reaches farther there");
    }
  }
  if (cage.guidance != Guidance::roller || is_quasi_static(scene)) return;
  check.require(has_shaped_pockets(cage), "cage.guidance",
                "flat parallel pocket faces act along the circumference only: nothing would hold "
                "the cage's centre, and it would leave the bearing",
                "give the pockets lips at the outside, cage.retention_width_outer_mm" +
                    suggested_lips(scene, 1) + ", or at the bore, cage.retention_width_inner_mm" +
                    suggested_lips(scene, 0) +
                    ", or curved faces (cage.face_radius_mm), or guide the cage by a ring "
                    "(\"outer\" or \"inner\")");
  const double play = roller_guide_clearance(scene, pitch);
  const double out = (outer_land_diameter(scene.bearing) - cage.outer_diameter) / 2,
               in = (cage.inner_diameter - inner_land_diameter(scene.bearing)) / 2;
  check.require(play > 0 && play < std::min(out, in), "cage.guidance",
                (std::isinf(play) ? "rollers never hold the cage"
                                  : "rollers let the cage go by " + in_mm(play) +
                                        " before its pockets touch them") +
                    " in the radial plane, and the rings stop it at " + in_mm(std::min(out, in)),
                "narrow the pockets at bore or outside (cage.retention_width_*, or a smaller "
                "cage.face_radius_mm), or guide the cage by a ring");
}

/// Of a pocket's smaller dimension: what bars touch and what the stress at corners is computed
/// from.
constexpr double kLargestCorner = 0.3;

void check_pockets(const Scene& scene, const SceneCheck& check) {
  const auto& cage = scene.cage;
  const double inner_radius = cage.inner_diameter / 2;
  for (long j = 0; j < scene.bearing.roller_count; ++j) {
    const double width = each(cage.pocket_width, j);
    const double length = each(cage.pocket_length, j);
    const std::string pocket = "pocket " + std::to_string(j) + ": ";
    if (!scene.allow_interference) {
      check.require(width > each(scene.roller.diameter, j), "cage.pocket_width_mm",
                    pocket + "the nominal pocket is not wider than its roller (" +
                        check.with_value("roller.diameter_mm") + "), so every cage jams",
                    "give a pocket width above the roller diameter, or set "
                    "cage.allow_interference = true to simulate the pinch");
      check.require(length > scene.roller.length, "cage.pocket_length_mm",
                    pocket + "the nominal pocket is not longer than its roller (" +
                        check.with_value("roller.length_mm") + "), so every cage jams",
                    "give a pocket length above the roller length, or set "
                    "cage.allow_interference = true to simulate the pinch");
    }
    check.require(
        width < cage.inner_diameter &&
            std::asin(width / 2 / inner_radius) * static_cast<double>(scene.bearing.roller_count) <
                std::numbers::pi,
        "cage.pocket_width_mm",
        pocket + "pockets this wide leave no bar between them at the cage's inner diameter (" +
            check.with_value("cage.inner_diameter_mm") + ", " +
            check.with_value("bearing.roller_count") + ")",
        "give narrower pockets, fewer rollers or a larger cage");
    check.require(
        length < cage.width, "cage.pocket_length_mm",
        pocket + "the pocket leaves no side rings (" + check.with_value("cage.width_mm") + ")",
        "give a shorter pocket or a wider cage");
    check.require(cage.model == CageKind::rigid ||
                      cage.corner_radius <= kLargestCorner * std::min(width, length),
                  "cage.corner_radius_mm",
                  pocket + "corners this round leave too little of its walls flat (" +
                      check.with_value("cage.pocket_width_mm") + ", " +
                      check.with_value("cage.pocket_length_mm") + ")",
                  "give at most 0.3 of the pocket's smaller dimension");
  }
}

void check_ring_tilt(const Scene& scene, const SceneCheck& check) {
  check.require(!has_free_ring_tilt(scene) || scene.cage.guidance != Guidance::inner,
                "model.ring_tilt",
                "the lands of a cage do not follow the free tilt of the ring that guides it (" +
                    check.with_value("cage.guidance") + ")",
                "set model.ring_tilt = \"prescribed\", or guide the cage by the outer ring or the "
                "rollers");
  const auto& load = scene.operation;
  for (const auto& [key, moment] : {std::pair{"load.tilting_moment_y_N_m", load.tilting_moment_y},
                                    std::pair{"load.tilting_moment_z_N_m", load.tilting_moment_z}})
    check.require(scene.model.ring_tilt == TiltModel::free || moment == 0, key,
                  "a ring whose tilt is prescribed hands any moment on to its shaft (" +
                      check.with_value("model.ring_tilt") + ")",
                  "set model.ring_tilt = \"free\", or leave the moment out");
}

// The viscosity by Walther's law, at the temperature of the oil.
void check_oil(const Scene& scene, const SceneCheck& check) {
  if (!is_lubricated(scene)) return;
  const Lubrication& l = scene.lubrication;
  const Oil& named = lubricant_named(l.lubricant).oil;
  const bool cold_given = !std::isnan(l.viscosity_40), hot_given = !std::isnan(l.viscosity_100);
  const double cold = cold_given ? l.viscosity_40 : named.viscosity_40,
               hot = hot_given ? l.viscosity_100 : named.viscosity_100;
  check.require(hot > kThinnestOil, "lubrication.viscosity_100_mm2_s",
                "Walther's law of viscosity ends at " + number_text(kThinnestOil) + " mm2/s",
                "give the kinematic viscosity at 100 degC, in mm2/s");
  check.require(cold > hot,
                cold_given ? "lubrication.viscosity_40_mm2_s" : "lubrication.viscosity_100_mm2_s",
                "the oil must be thinner at 100 degC (" + number_text(hot) +
                    " mm2/s) than at 40 degC (" + number_text(cold) + " mm2/s)",
                "give both viscosities, of one oil");
  const double viscosity = kinematic_viscosity(viscosity_curve(cold, hot), l.temperature);
  check.require(std::isfinite(viscosity), "lubrication.temperature_C",
                "by its viscosities at 40 and 100 degC (" + number_text(cold) + " and " +
                    number_text(hot) + " mm2/s) this oil is solid at this temperature",
                "give a higher temperature, or the viscosities of another oil");
}

// A film lies on bodies that flatten as Hertz says: the impact law tells no elastic approach.
void check_filmed_contacts(const Scene& scene, const SceneCheck& check) {
  if (!is_lubricated(scene)) return;
  const auto& contact = scene.contact;
  for (const auto& [key, law] : {std::pair{"contact.race.force_law", contact.race.law},
                                 std::pair{"contact.bar.force_law", contact.bar.law}})
    check.require(law == ForceLaw::hertz, key,
                  "the film at this contact (" + check.with_value("lubrication.model") +
                      ") needs the bodies' elastic approach, which the impact law does not give",
                  std::string("set ") + key +
                      " = \"hertz\", or lubrication.model = \"none\" for a dry bearing");
}

// By the two-dimensional theory the strip of contact is narrow against the bodies. Its half width
// is that of src/contact_laws/hertz_line.hpp under the most loaded roller by Stribeck's estimate.
void check_line_races(const Scene& scene, const SceneCheck& check) {
  if (scene.contact.race.law != ForceLaw::hertz ||
      scene.contact.race_approach != RaceApproach::line)
    return;
  const auto& b = scene.bearing;
  const double radius = each(scene.roller.diameter, 0) / 2;
  const auto softness = [](const Material& m) { return (1 - m.poisson * m.poisson) / m.young; };
  const double load = 5 * largest_radial_load(scene.operation) /
                      (static_cast<double>(b.roller_count) * scene.roller.length);
  const auto require = [&](double thickness, double curvature, const char* ring, const char* key) {
    const double width =
        std::sqrt(4 * load * (softness(roller_material(scene)) + softness(ring_material(scene))) /
                  (std::numbers::pi * (1 / radius + curvature)));
    check.require(4 * width < std::min(radius, thickness), "contact.race.approach",
                  std::string("the theory of line contact needs a narrow contact: that on the ") +
                      ring + " ring has a half width of " + in_mm(width) +
                      ", more than a quarter of the roller's radius or of the ring's thickness (" +
                      check.with_value("load.radial_N") + ", " + check.with_value(key) + ")",
                  "set contact.race.approach = \"palmgren\", or correct the load or the ring's "
                  "diameters");
  };
  require((b.inner_raceway_diameter - b.bore_diameter) / 2, 2 / b.inner_raceway_diameter, "inner",
          "bearing.bore_diameter_mm");
  require((b.outside_diameter - b.outer_raceway_diameter) / 2, -2 / b.outer_raceway_diameter,
          "outer", "bearing.outside_diameter_mm");
}

void check_window(const Scene& scene, const SceneCheck& check) {
  const Window& w = scene.window;
  if (std::isnan(w.peak_revolutions)) return;
  check.require(std::isnan(w.measure_time), "window.peak_revolutions",
                "the window is given in seconds (" + check.with_value("window.measure_time_s") +
                    "), not in cage revolutions",
                "leave window.measure_time_s out, or set window.peak_revolutions = \"auto\"");
  check.require(w.peak_revolutions <= w.measure_revolutions, "window.peak_revolutions",
                "the window is shorter (" + check.with_value("window.measure_revolutions") + ")",
                "give at most window.measure_revolutions");
}

}  // namespace

void check_scene(const Scene& scene, const std::string& file, const toml::table* root) {
  const SceneCheck check(scene, file, root);
  check_rings(scene, check);
  check_cage_between_rings(scene, check);
  check_pockets(scene, check);
  check_outline(scene, check);
  check.require(!is_flexible(scene) || !scene.cage.bar_modes ||
                    scene.cage.modes + scene.bearing.roller_count <= kMostModes,
                "cage.modes",
                "with a static mode of every bar these are more than " +
                    std::to_string(kMostModes) + " modes (" +
                    check.with_value("bearing.roller_count") + ")",
                "keep fewer elastic modes, or set cage.bar_modes = false");
  check_operation(scene, check);
  check_filmed_contacts(scene, check);
  check_line_races(scene, check);
  check_oil(scene, check);
  check.require(scene.contact.static_speed < scene.contact.dynamic_speed,
                "friction.static_speed_m_s",
                "friction must peak at a lower speed than that of full sliding (" +
                    check.with_value("friction.dynamic_speed_m_s") + ")",
                "give a smaller static_speed or a larger dynamic_speed");
  check.require(!is_quasi_static(scene) || !is_flexible(scene), "cage.model",
                "no force bends the cage while model.motion = \"quasi-static\"",
                "set cage.model = \"rigid\", or model.motion = \"dynamic\"");
  check_flanges(scene, check);
  check_ring_tilt(scene, check);
  check.require(scene.start.state != StartState::steady || is_lubricated(scene), "start.state",
                "only a lubricated bearing has the steady state that is sought (" +
                    check.with_value("lubrication.model") + ")",
                "set start.state = \"equilibrium\" or \"auto\", or lubrication.model = \"film\"");
  const auto& rings = scene.operation;
  const double rolling = rings.inner_speed * scene.bearing.inner_raceway_diameter +
                         rings.outer_speed * scene.bearing.outer_raceway_diameter;
  check.require(rolling != 0 || !std::isnan(scene.window.measure_time) || changes_over_time(rings),
                "speed.inner_rpm",
                "rolling does not turn the cage, so it makes no revolutions to measure over (" +
                    check.with_value("speed.outer_rpm") + ")",
                "give window.settle_time_s and window.measure_time_s");
  check_window(scene, check);
  check_duty(scene, check);
}

}  // namespace cagetol
