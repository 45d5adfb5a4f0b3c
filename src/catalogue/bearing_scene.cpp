#include "src/catalogue/bearing_scene.hpp"

#include <algorithm>
#include <cmath>

#include "src/catalogue/scene_text.hpp"
#include "src/input/input_error.hpp"
#include "src/input/toml_file.hpp"
#include "src/input/unit.hpp"
#include "src/operation/heat_shed.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {
namespace {

constexpr double kLoadShare = 0.1;                // of C
constexpr double kSpeedShare = 0.5;               // of the limiting speed
constexpr double kFlangeClearance = 0.01;         // over L_we
constexpr double kColdest = -60, kHottest = 250;  // of lubrication.temperature_C [degC]
constexpr const char* kCatalogue = "catalogue";   // sources of values
constexpr const char* kAsked = "as asked for";

std::string share_text(double share) {
  return number_text(std::round(1e4 * share) / 1e4);
}

std::string rule(const std::string& text) {
  return "design rule: " + text + "; assumption";
}

std::string signed_percent(double share) {
  const double percent = std::round(1000 * share) / 10;
  return (percent < 0 ? "" : "+") + number_text(percent) + " %";
}

/// Three digits at most, as a user would write it.
double few_digits(double value) {
  const double step = std::pow(10, std::floor(std::log10(value)) - 2);
  return step >= 1 ? step * std::round(value / step) : std::round(value / step) / (1 / step);
}

std::string outer_raceway_source(const DesignedBearing& bearing) {
  const std::string& from = bearing.row->outer_raceway_from;
  if (bearing.roller.from_ratings) return "derived: F + 2 D_we; not in the catalogue";
  if (from == "own row") return "catalogue, E";
  return "catalogue, E, of " + from;
}

void write_head(const DesignedBearing& bearing, SceneText& out) {
  const CatalogueRow& row = *bearing.row;
  const RatedSet& set = bearing.set;
  out.comment(row.designation +
              ", written by `cagetol scene`. Behind each value stands where it is "
              "from: the catalogue (inputs/catalogue.csv), a derivation, or a design rule. Replace "
              "what you know better, above all the cage.");
  out.comment(
      "The catalogue gives neither number nor length of the rollers. " +
      std::to_string(set.rollers.count) + " rollers of " +
      number_text(in_mm(set.rollers.diameter)) + " x " + number_text(in_mm(set.rollers.length)) +
      " mm give C by ISO 281 (b_m = " + number_text(std::round(1e3 * rating_factor(row)) / 1e3) +
      ") within " + signed_percent(set.dynamic_error) + " and C0 by ISO 76 within " +
      signed_percent(set.static_error) +
      ". Other numbers with lengths of their own would as well: the ratings hardly tell "
      "them apart. The length is that which carries, without chamfers.");
  out.word("name", row.designation, "for titles");
}

void write_flanges(const CatalogueRow& row, SceneText& out) {
  if (has_outer_flanges(row.type))
    out.number("shoulder_diameter_mm", in_mm(row.outer_shoulder), "catalogue, D1");
  else
    out.word("shoulder_diameter_mm", "auto", "the outer ring has no flanges");
  if (!has_inner_flanges(row.type)) return;
  const std::string type = std::string("type ") + spelled(row.type);
  const bool both = row.type != BearingType::NJ;
  out.word("outer_flanges", has_outer_flanges(row.type) ? "both" : "none", type);
  out.word("inner_flanges", both ? "both" : "right", type);
  out.number("inner_flange_diameter_mm", in_mm(row.inner_shoulder), "catalogue, d1");
  if (!both)
    out.number("inner_land_diameter_mm", in_mm(row.inner_shoulder),
               "catalogue, d1: the cage must clear the flange");
}

void write_bearing(const SceneRequest& asked, const DesignedBearing& bearing, SceneText& out) {
  const CatalogueRow& row = *bearing.row;
  const ClearanceRange range = clearance_range(asked.clearance, row.bore);
  const std::string of_class =
      std::string("middle of class ") + spelled(asked.clearance) + " of ISO 5753-1";
  const double minimum = std::round(1e6 * range.minimum), most = std::round(1e6 * range.most);
  out.section("bearing");
  out.number("roller_count", static_cast<double>(bearing.set.rollers.count),
             "derived: ISO 281 and ISO 76, with room for the cage's bars");
  out.number("bore_diameter_mm", in_mm(row.bore), kCatalogue);
  out.number("outside_diameter_mm", in_mm(row.outside), kCatalogue);
  out.number("width_mm", in_mm(row.width), kCatalogue);
  out.number("inner_raceway_diameter_mm", in_mm(row.inner_raceway), "catalogue, F");
  out.number("outer_raceway_diameter_mm", in_mm(bearing.roller.outer_raceway),
             outer_raceway_source(bearing));
  write_flanges(row, out);
  out.number("internal_clearance_um", (minimum + most) / 2,
             of_class + "; the catalogue diameters leave none");
  out.number("flange_clearance_mm", in_mm(kFlangeClearance * bearing.set.rollers.length),
             rule(share_text(kFlangeClearance) + " L_we"));
  out.number("misalignment_z_mrad", 0.3, "assumption: one minute of arc, a well made seat");
  out.number("dynamic_rating_kN", 1e-3 * row.dynamic_rating, "catalogue, C");
  out.number("static_rating_kN", 1e-3 * row.static_rating, "catalogue, C0");
  out.number("reference_speed_rpm", std::round(row.reference_speed / kRpm), kCatalogue);
  out.number("limiting_speed_rpm", std::round(row.limiting_speed / kRpm), kCatalogue);
  out.number("minimum_load_factor", row.minimum_load_factor, "catalogue, kr");
  out.assume("bearing.roller_count",
             "not in the catalogue; with the rollers' length it gives C (ISO 281) and C0 (ISO 76), "
             "as other pairs would");
  if (bearing.roller.from_ratings)
    out.assume("bearing.outer_raceway_diameter_mm",
               "not in the catalogue; with the rollers' diameter it gives both ratings best");
  out.assume("bearing.internal_clearance_um",
             of_class + ", unmounted: fits and temperatures take some of it", minimum, most);
  out.assume("bearing.flange_clearance_mm", "not in the catalogue");
  out.assume("bearing.misalignment_z_mrad", "one minute of arc, a well made seat");
}

void write_rollers(const DesignedBearing& bearing, SceneText& out) {
  out.section("roller");
  out.number("diameter_mm", in_mm(bearing.set.rollers.diameter),
             bearing.roller.from_ratings ? "derived: ISO 281 and ISO 76" : "catalogue: (E - F)/2");
  out.number("length_mm", in_mm(bearing.set.rollers.length), "derived: ISO 281 and ISO 76");
  out.word("profile", "logarithmic", "assumption: ISO/TS 16281");
  if (bearing.roller.from_ratings)
    out.assume("roller.diameter_mm", "not in the catalogue; it gives both ratings best");
  out.assume("roller.length_mm",
             "not in the catalogue; with the number of rollers it gives C (ISO 281) and C0 (ISO "
             "76)");
  out.assume("roller.profile",
             "logarithmic as in ISO/TS 16281; the maker's profile is not published");
}

std::string guided_by(Guidance guidance, BearingType type) {
  if (guidance == Guidance::roller) return "the rollers";
  if (guidance == Guidance::outer)
    return has_outer_flanges(type) ? "the outer ring's shoulders" : "the outer raceway";
  return has_inner_flanges(type) ? "the inner ring's flanges" : "the inner raceway";
}

void write_guidance(const DesignedBearing& bearing, SceneText& out) {
  const CageSection& cage = bearing.section;
  const CageRule& of = cage_rule(cage.make);
  out.word("guidance", spelled(cage.guidance), guided_by(cage.guidance, bearing.row->type));
  if (cage.guidance == Guidance::roller) {
    out.number("retention_width_inner_mm", in_mm(cage.retention_inner),
               rule("lips leave half the pocket's clearance"));
    out.number("retention_width_outer_mm", in_mm(cage.retention_outer), rule("likewise"));
    return;
  }
  const std::string land = number_text(in_mm(cage.land_diameter)) + " mm, " +
                           guided_by(cage.guidance, bearing.row->type);
  if (cage.flanged)
    out.number(
        "guide_clearance_mm", in_mm(cage.guide_clearance),
        rule(share_text(of.guide_clearance) + " of " + land + ", which flanged side rings reach"));
  out.assume("cage.guide_clearance_mm",
             "radial, " + share_text(of.guide_clearance) + " of " + land +
                 ". The range: half as much to half as much again",
             in_mm(cage.guide_clearance / 2), in_mm(1.5 * cage.guide_clearance));
}

void write_cage(const SceneRequest& asked, const DesignedBearing& bearing, SceneText& out) {
  const CageSection& cage = bearing.section;
  const CageRule& of = cage_rule(cage.make);
  const bool outer = cage.guidance == Guidance::outer && !cage.flanged,
             inner = cage.guidance == Guidance::inner && !cage.flanged;
  const std::string thick = rule("thickness " + share_text(of.thickness) +
                                 " D_we, or as the guide clearance needs"),
                    land = rule("radial clearance " + share_text(of.guide_clearance) +
                                " of the guiding diameter"),
                    about = rule("about the axes, thickness " + share_text(of.thickness) +
                                 " D_we, or as the guide clearance needs");
  out.section("cage");
  out.word("model", spelled(asked.model), "rigid, or flexible for modes and stress");
  out.word("material", of.material, std::string("of a ") + spelled(cage.make) + " cage");
  out.number("inner_diameter_mm", in_mm(cage.inner_diameter), outer ? thick : inner ? land : about);
  out.number("outer_diameter_mm", in_mm(cage.outer_diameter), outer ? land : inner ? thick : about);
  out.number("width_mm", in_mm(bearing.lengths.width),
             rule("side rings of " + share_text(of.side_ring) + " D_we, at most 14/15 B in all"));
  out.number("pocket_width_mm", in_mm(cage.pocket_width),
             rule("clearance " + share_text(of.pocket_width) + " D_we"));
  out.number("pocket_length_mm", in_mm(bearing.lengths.pocket_length),
             rule("clearance " + share_text(of.pocket_length) + " D_we"));
  const char* rule_note = "a design rule; no catalogue states it";
  if (asked.model == CageKind::flexible) {
    out.number("corner_radius_mm", in_mm(cage.corner_radius),
               rule(share_text(of.corner) + " D_we"));
    out.assume("cage.corner_radius_mm", rule_note);
  }
  out.number("edge_radius_mm", in_mm(cage.edge_radius), rule("0.0267 D_we"));
  write_guidance(bearing, out);
  for (const char* key : {"inner_diameter_mm", "outer_diameter_mm", "width_mm", "pocket_width_mm",
                          "pocket_length_mm"})
    out.assume(std::string("cage.") + key, rule_note);
}

void write_oil(const SceneRequest& asked, SceneText& out) {
  out.section("lubrication");
  out.word("model", "film", "an oiled bearing; \"none\" makes a dry one");
  out.word("lubricant", asked.lubricant.value_or(kUsualLubricant),
           asked.lubricant ? kAsked : "assumption");
  if (asked.temperature) out.number("temperature_C", *asked.temperature, kAsked);
  out.word("supply", "circulation", "assumption; or \"bath\", \"oil-air\", \"grease\"");
  out.assume("lubrication.lubricant",
             "thicker oil brings more torque and more slip under light "
             "load");
  if (asked.temperature)
    out.assume("lubrication.temperature_C",
               "of the oil in the bearing; a colder one has thicker oil. The range: 30 K less to "
               "30 K more",
               std::max(*asked.temperature - 30, kColdest),
               std::min(*asked.temperature + 30, kHottest));
  out.assume("lubrication.supply",
             "how oil comes to the bearing: it sets the layers and the oil share below, where "
             "they are not given");
  out.assume("lubrication.race_layer_um",
             "20 um of circulating oil; rolling resistance and slip depend on it. The range: from "
             "starved to an oil bath",
             5, 50);
  out.assume("lubrication.outer_layer_um",
             "200 um: oil is thrown there; at speed most of the torque depends on it. The range: "
             "from what the inner race has to flooded",
             20, 1000);
  out.assume("lubrication.pocket_layer_um", "20 um; as at the inner race", 5, 50);
  out.assume("lubrication.land_layer_um",
             "200 um between lands and their ring, which drags the cage along or back. The range: "
             "likewise",
             20, 1000);
  out.assume("lubrication.race_roughness_um",
             "0.2 um, ground races. The range: from superfinished to ground", 0.05, 0.4);
  out.assume("lubrication.pocket_roughness_um",
             "0.5 um, a pocket run in. The range: from reamed to milled and new", 0.2, 1.5);
  out.assume("lubrication.oil_share",
             "0.02, mist or jet. The range: from a trace of mist to a shallow bath", 0.005, 0.1);
  out.assume("friction.static_coefficient",
             "0.07 where roughness reaches through the oil. The range: from no peak to boundary "
             "friction of steel in mineral oil",
             0.06, 0.12);
  out.assume("friction.dynamic_coefficient", "0.06 of full sliding", 0.03, 0.07);
}

/// Against -x, where the one flange of an NJ's inner ring carries it.
void write_axial_load(double force, const CatalogueRow& row, SceneText& out) {
  if (!has_outer_flanges(row.type) || !has_inner_flanges(row.type))
    throw InputError({}, "--axial", number_text(force),
                     row.designation + " has flanges on one ring alone, which carry no axial load",
                     "take an NJ or NUP of this size (`cagetol scene --list`), or leave it out");
  out.number("axial_N", -force,
             std::string(kAsked) + "; the inner ring's right flange hands it to the outer's left");
}

/// Oil and rings as warm as the heat makes them that the bearing loses.
void write_heat(const CatalogueRow& row, SceneText& out) {
  out.section("temperature");
  out.flag("balance", "found before all runs; or false and lubrication.temperature_C");
  out.number("ambient_C", 20, "assumption");
  out.assume("temperature.ambient_C",
             "what the bearing sheds its heat to. The range: from a cold to a warm housing", 0, 60);
  Scene size;
  size.bearing.width = row.width;
  size.bearing.bore_diameter = row.bore;
  size.bearing.outside_diameter = row.outside;
  const double standard = heat_shed(size).slope;
  out.assume("temperature.conductance_W_K",
             number_text(few_digits(standard)) +
                 " W/K by ISO 15312. The range: from a housing of half to one of twice the heat",
             few_digits(standard / 2), few_digits(2 * standard));
}

void write_operation(const SceneRequest& asked, const CatalogueRow& row, SceneText& out) {
  out.section("load");
  out.number("radial_N", asked.load.value_or(few_digits(kLoadShare * row.dynamic_rating)),
             asked.load ? kAsked : "0.1 C");
  if (asked.axial) write_axial_load(*asked.axial, row, out);
  out.section("speed");
  const double half = std::round(kSpeedShare * row.limiting_speed / kRpm);
  out.number("inner_rpm", asked.speed ? std::round(1e6 * *asked.speed / kRpm) / 1e6 : half,
             asked.speed ? kAsked : "half the limiting speed");
  out.section("window");
  out.number("settle_revolutions", 2, "of the cage");
  out.number("measure_revolutions", 6, "of the cage");
}

}  // namespace

DesignedBearing designed_bearing(const CatalogueRow& row, CageMake make, Guidance guidance) {
  DesignedBearing bearing;
  bearing.row = &row;
  bearing.roller = roller_diameter(row);
  bearing.section = cage_section(row, bearing.roller, make, guidance);
  bearing.set = rated_set(row, bearing.roller, most_rollers(bearing.section, bearing.roller));
  bearing.lengths = cage_lengths(row, bearing.section, bearing.set.rollers);
  return bearing;
}

std::string bearing_scene(const SceneRequest& request) {
  const CatalogueRow& row = catalogue_row(request.designation);
  const CageMake make = request.make.value_or(usual_make(row.designation));
  const DesignedBearing bearing =
      designed_bearing(row, make, request.guidance.value_or(cage_rule(make).guidance));
  SceneText out;
  write_head(bearing, out);
  write_bearing(request, bearing, out);
  write_rollers(bearing, out);
  write_cage(request, bearing, out);
  write_oil(request, out);
  if (!request.temperature) write_heat(*bearing.row, out);
  write_operation(request, row, out);
  const std::string name = "scene of " + row.designation;
  read_scene(parse_toml(out.str(), name), name);
  return out.str();
}

}  // namespace cagetol
