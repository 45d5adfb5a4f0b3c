// What a scene must say about oil, and what lubrication.model makes of the other keys about it.
#include "src/reading/oil_keys.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <cmath>
#include <functional>
#include <numbers>

#include "src/lubrication/lubricant.hpp"
#include "src/model/bearing_model.hpp"
#include "src/reading/scene_keys.hpp"
#include "src/scene/oil_supply.hpp"
#include "tests/support/reference_scene.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Scene scene_of(const std::string& text) {
  return read_scene(reference_scene_table(text, "t.toml"), "t.toml");
}
Scene without_oil(const std::string& text = "") {
  return read_scene(parse_toml(reference_scene_without_oil(text), "t.toml"), "t.toml");
}

std::string problem(const std::function<void()>& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}
std::string problem_of(const std::string& text) {
  return problem([&] { scene_of(text); });
}

const std::string kFilm = "lubrication.model = 'film'\n";
const std::string kNone = "lubrication.model = 'none'\n";

TEST(OilKeys, ADynamicSceneMustSayWhetherThereIsOil) {
  EXPECT_THAT(
      problem([] { without_oil(); }),
      AllOf(HasSubstr("t.toml: lubrication.model: a dynamic scene must say whether there is "
                      "oil in the bearing"),
            HasSubstr("remedy: give lubrication.model = \"film\" for a bearing with oil, or "
                      "\"none\" for a dry one (in"),
            HasSubstr("below [scene]")));
  EXPECT_THAT(problem([] { without_oil("model.motion = 'dynamic'\n"); }),
              HasSubstr("a dynamic scene must say"));
  EXPECT_EQ(problem_of(kFilm), "no error");
  EXPECT_EQ(problem_of(kNone), "no error");
}

TEST(OilKeys, AQuasiStaticSceneThatDoesNotSayIsDry) {
  EXPECT_FALSE(is_lubricated(without_oil("model.motion = 'quasi-static'\n")));
  EXPECT_TRUE(is_lubricated(scene_of("model.motion = 'quasi-static'\n" + kFilm)));
}

TEST(OilKeys, AreNamedAmongWhatElseIsMissing) {
  const auto missing = [](const std::string& motion) {
    return problem([&] {
      toml::table root = parse_toml(reference_scene_without_oil(motion), "t.toml");
      root.erase("load");
      read_scene(root, "t.toml");
    });
  };
  EXPECT_THAT(missing(""), AllOf(HasSubstr("leaves out 2 keys"), HasSubstr("\n    load.radial_N"),
                                 HasSubstr("\n    lubrication.model: ")));
  EXPECT_THAT(missing("model.motion = 'quasi-static'\n"),
              AllOf(HasSubstr("leaves out 1 key"), Not(HasSubstr("lubrication.model"))));
}

TEST(OilKeys, DumpAndTableSayWhereTheyAreRequired) {
  EXPECT_THAT(dump_keys(scene_keys(), example_scene()),
              HasSubstr("\"none\", \"film\"; required where model.motion = \"dynamic\")\n"));
  EXPECT_THAT(
      key_table_markdown(scene_keys(), example_scene()),
      HasSubstr("| `lubrication.model` | - | required where model.motion = \"dynamic\", else "
                "\"none\" |"));
}

TEST(OilKeys, ContactsWithAFilmRefuseTheImpactLaw) {
  for (const std::string kind : {"race", "bar"}) {
    const std::string text = "contact." + kind + ".force_law = 'impact'\n";
    EXPECT_THAT(problem_of(kFilm + text),
                AllOf(HasSubstr("t.toml:2: contact." + kind +
                                ".force_law = \"impact\": the film at this "
                                "contact (lubrication.model = \"film\")"),
                      HasSubstr("remedy: set contact." + kind + ".force_law = \"hertz\"")));
    EXPECT_EQ(problem_of(kNone + text), "no error");
  }
  EXPECT_EQ(problem_of(kFilm + "contact.land.force_law = 'impact'\n"), "no error");
}

TEST(OilKeys, OilMustThinAndFlow) {
  EXPECT_THAT(
      problem_of(kFilm + "lubrication.viscosity_40_mm2_s = 5\n"),
      AllOf(HasSubstr("t.toml:2: lubrication.viscosity_40_mm2_s = 5: the oil must be thinner at "
                      "100 degC (8.7 mm2/s) than at 40 degC (5 mm2/s)"),
            HasSubstr("remedy: give both viscosities")));
  EXPECT_THAT(problem_of(kFilm + "lubrication.viscosity_100_mm2_s = 68\n"),
              HasSubstr("t.toml:2: lubrication.viscosity_100_mm2_s = 68: the oil must be thinner"));
  EXPECT_THAT(problem_of(kFilm + "lubrication.viscosity_100_mm2_s = 0.3\n"),
              HasSubstr("lubrication.viscosity_100_mm2_s = 0.3: Walther's law"));
  const std::string steep = kFilm +
                            "lubrication.viscosity_40_mm2_s = 1e5\n"
                            "lubrication.viscosity_100_mm2_s = 1\n";
  EXPECT_THAT(problem_of(steep + "lubrication.temperature_C = -60\n"),
              HasSubstr("lubrication.temperature_C = -60: by its viscosities at 40 and 100 degC "
                        "(1e+05 and 1 mm2/s) this oil is solid"));
  EXPECT_EQ(problem_of(steep), "no error");
  EXPECT_EQ(problem_of("lubrication.viscosity_40_mm2_s = 5\n"), "no error");  // dry
}

TEST(OilSupply, FillsWhatIsNotGiven) {
  const auto layers_of = [](const std::string& text) {
    return oil_layers(scene_of(kFilm + text).lubrication);
  };
  EXPECT_EQ(layers_of("").outer, 200e-6);  // a circulation
  EXPECT_EQ(layers_of("lubrication.lubricant = 'grease-lithium-mineral'\n").outer, 50e-6);
  const OilLayers air =
      layers_of("lubrication.supply = 'oil-air'\nlubrication.outer_layer_um = 7\n");
  EXPECT_EQ(air.outer, 7e-6);
  EXPECT_EQ(air.inner, 5e-6);
  const OilLayers bath =
      layers_of("lubrication.supply = 'bath'\nlubrication.race_layer_um = 'flooded'\n");
  EXPECT_TRUE(std::isinf(bath.outer) && std::isinf(bath.inner) && std::isinf(bath.land));
  EXPECT_GT(bath.share, layers_of("").share);
  EXPECT_THAT(problem_of(kFilm + "lubrication.pocket_layer_um = 'flooded'\n"),
              HasSubstr("lubrication.pocket_layer_um"));
  const Scene scene = scene_of(kFilm + "lubrication.outer_layer_um = 'flooded'\n");
  EXPECT_EQ(key_text(*find_key(scene_keys(), "lubrication.outer_layer_um"), scene), "\"flooded\"");
  EXPECT_FALSE(make_bearing_model(scene).outer_line.starved);
}

ShortBearing guide_film_of(const std::string& text) {
  return make_bearing_model(scene_of(text)).guides[0].film;
}

TEST(LandFilm, LiesBetweenLandAndRingInTheOilOfTheBearing) {
  // A cage of 43.4 mm in shoulders of 43.8 mm.
  const double radius = 21.8e-3, width = 2e-3, viscosity = 0.03;
  const ShortBearing thick = guide_film_of(kFilm +
                                           "lubrication.viscosity_Pa_s = 0.03\n"
                                           "lubrication.land_film_width_mm = 2\n"
                                           "lubrication.land_film_minimum_um = 3\n");
  EXPECT_TRUE(thick.on);
  EXPECT_NEAR(thick.pressure / (viscosity * radius * std::pow(width, 3)), 1, 1e-9);
  EXPECT_NEAR(thick.torque / (2 * std::numbers::pi * viscosity * std::pow(radius, 3) * width), 1,
              1e-9);
  EXPECT_NEAR(thick.axial / (2 * std::numbers::pi * viscosity * radius * width), 1, 1e-9);
  EXPECT_NEAR(thick.clearance, 0.2e-3, 1e-12);
  EXPECT_NEAR(thick.minimum, 3e-6, 1e-15);
  // VG 68 at 70 degC: 0.01688 Pa s. The film is proportional to it.
  const double share = guide_film_of(kFilm).torque /
                       guide_film_of(kFilm + "lubrication.viscosity_Pa_s = 0.02\n").torque;
  EXPECT_NEAR(share * 0.02, 0.01688, 1e-5);
  const Scene film = scene_of(kFilm);
  const BearingModel model = make_bearing_model(film);
  EXPECT_NEAR(model.guide_clearance - model.guides[0].touching_at, 1e-6, 1e-15);
}

TEST(LandFilm, IsOffBySwitchAndWhereNoLandGuides) {
  EXPECT_FALSE(guide_film_of(kFilm + "lubrication.land_film = false\n").on);
  EXPECT_FALSE(guide_film_of(kNone + "lubrication.land_film = true\n").on);
  const BearingModel dry = make_bearing_model(scene_of(kFilm + "lubrication.land_film = false\n"));
  EXPECT_EQ(dry.guides[0].touching_at, dry.guide_clearance);
}

TEST(LandFilm, WantsRoom) {
  EXPECT_THAT(
      problem_of(kFilm + "lubrication.land_film_minimum_um = 60\n"),
      HasSubstr("t.toml:2: lubrication.land_film_minimum_um = 60: roughness this high fills the "
                "guide clearance (200 um)"));
  EXPECT_THAT(
      problem_of(kFilm + "lubrication.land_film_width_mm = 8\n"),
      HasSubstr("t.toml:2: lubrication.land_film_width_mm = 8: two lands this wide do not fit"));
  const std::string off = kFilm + "lubrication.land_film = false\n";
  EXPECT_EQ(problem_of(off + "lubrication.land_film_minimum_um = 60\n"), "no error");
  EXPECT_THAT(problem_of(kFilm + "cage.guidance = 'roller'\n"),
              HasSubstr("nothing would hold the cage's centre"));
}

}  // namespace
}  // namespace cagetol
