// Scenes of catalogue bearings: every bearing with every make of cage is a scene that the reader
// takes.
#include "src/catalogue/bearing_scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "src/input/input_error.hpp"
#include "src/input/toml_file.hpp"
#include "src/lubrication/lubricant.hpp"
#include "src/quantities/operating_point.hpp"
#include "src/reading/idle_notes.hpp"
#include "src/reading/scene_keys.hpp"
#include "src/scene/materials.hpp"
#include "src/scene/pocket_clearances.hpp"
#include "src/scene/pocket_outline.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

Scene scene_of(const std::string& text) {
  return read_scene(parse_toml(text, "scene"), "scene");
}

std::vector<std::string> modelled() {
  std::vector<std::string> names;
  for (const CatalogueRow& row : catalogue()) names.push_back(row.designation);
  return names;
}

class ModelledRow : public testing::TestWithParam<std::string> {};

/// What must hold of a written scene.
void expect_sound(const Scene& scene, const CatalogueRow& row) {
  SCOPED_TRACE(row.designation + " " + scene.cage.material.name);
  RatedRollers rollers{scene.bearing.roller_count, scene.roller.diameter[0], scene.roller.length,
                       2 * pitch_radius(scene.bearing)};
  EXPECT_NEAR((row.uprated ? 1.15 : 1) * dynamic_rating(rollers) / row.dynamic_rating, 1, 0.03);
  EXPECT_NEAR(static_rating(rollers) / row.static_rating, 1, 0.03);
  const CageGeometry& cage = scene.cage;
  const double pocket = 2 * std::asin(cage.pocket_width[0] / cage.inner_diameter);
  EXPECT_GT((2 * std::numbers::pi / rollers.count - pocket) * cage.inner_diameter / 2,
            0.07 * rollers.diameter);
  EXPECT_LE(cage.width, row.width);
  EXPECT_GT(cage.width - cage.pocket_length[0], 0.2 * rollers.diameter);
  const PocketClearances clear = pocket_clearances(scene, 0);
  EXPECT_GT(clear.tangential, 0.015 * rollers.diameter);
  EXPECT_GT(clear.axial, scene.bearing.flange_clearance);
  for (const int ring : {0, 1}) EXPECT_GT(clear.ring[ring], 0.04e-3);
  const PocketOutline outline = pocket_outline(cage, pitch_radius(scene.bearing), 0);
  const double way = clear.ring[cage.guidance == Guidance::inner ? 0 : 1];
  if (cage.guidance != Guidance::roller) {
    EXPECT_LT(outline.end[0].height, pitch_radius(scene.bearing) - way);
    EXPECT_GT(outline.end[1].height, pitch_radius(scene.bearing) + way);
  }
  EXPECT_THAT(scene_doubts(scene), IsEmpty());
  EXPECT_THAT(operating_warnings(scene), IsEmpty());
  EXPECT_THAT(idle_notes(scene), IsEmpty());
}

TEST_P(ModelledRow, GivesASoundSceneWithEveryMakeOfCage) {
  const CatalogueRow& row = catalogue_row(GetParam());
  for (const auto& make : spellings(CageMake{}))
    for (const Guidance guidance : {Guidance::outer, Guidance::roller}) {
      if (make.value == CageMake::steel_sheet && guidance == Guidance::roller) continue;
      expect_sound(scene_of(bearing_scene({row.designation, make.value, guidance})), row);
    }
}

INSTANTIATE_TEST_SUITE_P(Rows, ModelledRow, testing::ValuesIn(modelled()), [](const auto& test) {
  std::string name = test.param;
  std::erase(name, ' ');
  return name;
});

TEST(DesignedBearing, ClearsTheFlangesOfEitherRing) {
  for (const CatalogueRow& row : catalogue()) {
    SCOPED_TRACE(row.designation);
    for (const auto& make : spellings(CageMake{})) {
      const DesignedBearing bearing = designed_bearing(row, make.value, Guidance::outer);
      const CageSection& cage = bearing.section;
      const double inner = row.type == BearingType::NU ? row.inner_raceway : row.inner_shoulder,
                   outer = row.type == BearingType::N ? bearing.roller.outer_raceway
                                                      : row.outer_shoulder;
      EXPECT_GT(cage.inner_diameter, inner + 0.04e-3);
      EXPECT_LT(cage.outer_diameter, outer);
      // Where faces, half a pocket beside the axes, are as high as these.
      const double axes = std::hypot(bearing.roller.pitch_diameter, cage.pocket_width);
      EXPECT_LT(cage.inner_diameter + 2 * cage.guide_clearance, axes);
      EXPECT_GT(cage.outer_diameter - 2 * cage.guide_clearance, axes);
      EXPECT_GT(bar_width(cage, bearing.set.rollers.count), 0.07 * bearing.roller.diameter);
    }
  }
}

// The flange on the right of an NJ's inner ring pushes the rollers to the left one of the outer.
TEST(BearingScene, AnAxialLoadIsCarriedByFlangesOfBothRings) {
  for (const char* name : {"NJ308", "NUP308"}) {
    SceneRequest request{name};
    request.axial = 300;
    const Scene scene = scene_of(bearing_scene(request));
    EXPECT_EQ(scene.operation.axial_load, -300) << name;
    EXPECT_EQ(scene.bearing.outer_flanges, FlangeSides::both) << name;
    EXPECT_EQ(scene.bearing.inner_flanges,
              std::string(name) == "NJ308" ? FlangeSides::right : FlangeSides::both);
    EXPECT_THAT(operating_warnings(scene), IsEmpty()) << name;
    request.axial.reset();
    EXPECT_EQ(scene_of(bearing_scene(request)).operation.axial_load, 0);
  }
}

// Bars at the bore of a cage on the inner raceway take room from the rollers; where too few are
// left for the ratings, that is said.
TEST(BearingScene, AnInnerGuidedCageHasFewerRollers) {
  const Scene outer = scene_of(bearing_scene({"NU205", CageMake::brass_machined})),
              inner = scene_of(bearing_scene({"NU205", CageMake::brass_machined, Guidance::inner}));
  EXPECT_LT(inner.bearing.roller_count, outer.bearing.roller_count);
  EXPECT_GT(inner.roller.length, outer.roller.length);
  expect_sound(inner, catalogue_row("NU205"));
  int refused = 0;
  for (const std::string& name : modelled()) try {
      expect_sound(scene_of(bearing_scene({name, CageMake::brass_machined, Guidance::inner})),
                   catalogue_row(name));
    } catch (const InputError& error) {
      ++refused;
      EXPECT_THAT(error.what(), HasSubstr("another --guidance"));
    }
  EXPECT_GT(refused, 0);
  EXPECT_LT(refused, 24);
}

TEST(BearingScene, NoLipsOfSheetHoldRollers) {
  EXPECT_THROW(bearing_scene({"NU205", CageMake::steel_sheet, Guidance::roller}), InputError);
}

TEST(BearingScene, TakesWhatIsAskedFor) {
  SceneRequest asked{"nu 2310", CageMake::peek_machined};
  asked.clearance = ClearanceClass::C3;
  asked.lubricant = "iso-vg-460";
  asked.temperature = 55;
  asked.load = 12345;
  asked.speed = 1234 * std::numbers::pi / 30;
  asked.model = CageKind::rigid;
  const Scene scene = scene_of(bearing_scene(asked));
  EXPECT_EQ(scene.cage.material.name, "peek-cf30");
  EXPECT_NEAR(scene.bearing.internal_clearance, 65e-6, 1e-12);  // 50 to 80 um
  EXPECT_EQ(scene.lubrication.lubricant, "iso-vg-460");
  EXPECT_EQ(scene.lubrication.temperature, 55);
  EXPECT_EQ(scene.operation.radial_load, 12345);
  EXPECT_NEAR(scene.operation.inner_speed / *asked.speed, 1, 1e-9);
  EXPECT_EQ(scene.cage.model, CageKind::rigid);
  EXPECT_THAT(idle_notes(scene), IsEmpty());
  for (const double temperature : {-50.0, 240.0}) {
    asked.temperature = temperature;
    asked.lubricant = "iso-vg-10";
    EXPECT_EQ(scene_of(bearing_scene(asked)).lubrication.temperature, temperature);
  }
}

TEST(BearingScene, LoadAndSpeedAreSharesOfTheCatalogues) {
  const Scene scene = scene_of(bearing_scene({"NU208"}));
  EXPECT_EQ(scene.operation.radial_load, 6200);
  EXPECT_NEAR(scene.operation.inner_speed, 5500 * std::numbers::pi / 30, 1e-6);
  EXPECT_EQ(scene.bearing.dynamic_rating, 62e3);
  EXPECT_EQ(scene.bearing.minimum_load_factor, 0.15);
  EXPECT_EQ(scene.cage.model, CageKind::flexible);
}

TEST(BearingScene, TheSuffixNamesTheCage) {
  EXPECT_EQ(usual_make("NU 208 ECP"), CageMake::polyamide);
  EXPECT_EQ(usual_make("N 205 ECJ"), CageMake::steel_sheet);
  for (const char* brass : {"NU 228 ECM", "NU 1008 ML", "NU 2324 ECMA", "NU 2228 ECML"})
    EXPECT_EQ(usual_make(brass), CageMake::brass_machined) << brass;
  EXPECT_EQ(usual_make("NU 1005"), CageMake::steel_machined);
  EXPECT_EQ(usual_make("NJ 1016"), CageMake::steel_machined);
}

// Every line of a section says where its value is from, and each assumed length has its entry.
TEST(BearingScene, SaysOfEveryNumberWhereItIsFrom) {
  const std::string text = bearing_scene({"NU 1014"});
  std::istringstream lines(text.substr(0, text.find("[[assumption]]")));
  for (std::string line; std::getline(lines, line);)
    if (line.find(" = ") != std::string::npos && line[0] != '#') {
      EXPECT_THAT(line, HasSubstr(" # "));
    }
  EXPECT_THAT(text, HasSubstr("outer_raceway_diameter_mm = 101.5"));
  EXPECT_THAT(text, HasSubstr("derived: F + 2 D_we; not in the catalogue"));
  std::set<std::string> assumed;
  for (const Assumption& entry : scene_of(text).assumptions) assumed.insert(entry.key);
  for (const char* key :
       {"bearing.roller_count", "bearing.outer_raceway_diameter_mm", "roller.diameter_mm",
        "roller.length_mm", "cage.pocket_width_mm", "bearing.internal_clearance_um"})
    EXPECT_TRUE(assumed.contains(key)) << key;
}

TEST(BearingScene, SaysWhichRingHasFlanges) {
  const BearingGeometry nj = scene_of(bearing_scene({"NJ 308"})).bearing,
                        n = scene_of(bearing_scene({"N 308"})).bearing;
  EXPECT_EQ(nj.outer_flanges, FlangeSides::both);
  EXPECT_EQ(nj.inner_flanges, FlangeSides::right);
  EXPECT_EQ(n.outer_flanges, FlangeSides::none);
  EXPECT_EQ(n.inner_flanges, FlangeSides::both);
  EXPECT_EQ(n.inner_flange_diameter, catalogue_row("N 308").inner_shoulder);
  EXPECT_TRUE(std::isnan(n.shoulder_diameter));
}

}  // namespace
}  // namespace cagetol
