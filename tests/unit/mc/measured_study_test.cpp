// Studies whose laws are read from measured cages.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numeric>
#include <set>

#include "mc/study/sample.hpp"
#include "mc/study/study.hpp"
#include "src/input/input_error.hpp"
#include "tests/support/reference_scene.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;

constexpr int kCages = 12, kPockets = 13;

/// Width and length of pocket j of cage c, in mm: no two alike.
double width(int c, int j) {
  return 0.001 * c + 0.00001 * j;
}
double length(int c, int j) {
  return 2 * width(c, j);
}

class MeasuredStudy : public testing::Test {
 protected:
  MeasuredStudy() : folder_(testing::TempDir() + "measured_study/") {
    std::filesystem::create_directories(folder_);
    write("reference.toml", reference_scene_text());
    std::string text = "cage,width_mm,length_mm\n";
    for (int c = 0; c < kCages; ++c)
      for (int j = 0; j < kPockets; ++j)
        text += fmt::format("{},{},{}\n", c, width(c, j), length(c, j));
    write("shop.csv", text);
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ + name) << text;
  }

  std::string text_of(const std::string& more) const {
    std::string text = "samples = 40\n[scene]\nfile = 'reference.toml'\n[scene.cage]\n";
    for (const char* key : {"width", "length"})
      text += fmt::format(
          "pocket_{0}_mm = {{ pocket = {{ law = 'empirical', file = 'shop.csv', column = '{0}', "
          "group = 'cage'{1} }} }}\n",
          key, more);
    return text +
           "[scene.load]\nradial_N = { nominal = 1000, lot = { law = 'normal', sigma = 9 } }\n"
           "[[tolerance.dimension]]\nkey = 'cage.pocket_width_mm'\ntolerance_width_mm = 0.1\n"
           "candidates = [0.1, 0.05]\n";
  }

  Study study(const std::string& more = "", const std::vector<std::string>& settings = {}) const {
    write("study.toml", text_of(more));
    return read_study(folder_ + "study.toml", settings);
  }

  std::string folder_;
};

TEST_F(MeasuredStudy, DrawsWholeCagesWithAllThatWasMeasuredOfThem) {
  const Study drawn = study();
  EXPECT_EQ(design_columns(drawn), 2u);  // of the cages, and of the load
  const Sampler sampler(drawn);
  std::set<int> cages;
  for (std::uint64_t id = 0; id < 40; ++id) {
    const Sample sample = sampler.draw(id);
    const DrawnInput &widths = sample.inputs[0], &lengths = sample.inputs[1];
    const double scale = sample.candidate == 0 ? 1 : 0.5;
    const int cage = static_cast<int>(std::floor((lengths.lot[0] + lengths.pocket[0]) / 0.002));
    cages.insert(cage);
    for (int j = 0; j < kPockets; ++j) {
      const auto at = static_cast<std::size_t>(j);
      EXPECT_NEAR(widths.lot[0] + widths.pocket[at], scale * width(cage, j), 1e-12);
      EXPECT_NEAR(lengths.lot[0] + lengths.pocket[at], length(cage, j), 1e-12);
    }
    EXPECT_NEAR(std::accumulate(widths.pocket.begin(), widths.pocket.end(), 0.0), 0, 1e-12);
  }
  EXPECT_GT(cages.size(), 6u);
}

TEST_F(MeasuredStudy, FittedDrawsNormalLawsOfBothParts) {
  const Study fitted = study(", fitted = true");
  EXPECT_EQ(law_name(*fitted.inputs[0].lot), "normal");
  // Cages lie 0.001 mm apart: their standard deviation is sqrt((12^2 - 1) / 12) of that, times
  // sqrt(12 / 11), less what the pockets' part would make of it.
  EXPECT_NEAR(standard_deviation(*fitted.inputs[0].lot), 0.001 * std::sqrt(13.0), 1e-7);
  EXPECT_EQ(design_columns(fitted), 2u * (1 + kPockets) + 1);
}

TEST_F(MeasuredStudy, ReadsBackFromItsOwnText) {
  for (const char* more : {"", ", fitted = true, centred = true, exclude = [3]"}) {
    const Study once = study(more);
    const Study again = read_resolved_study(once.resolved_toml, "again");
    EXPECT_EQ(again.resolved_toml, once.resolved_toml);
    EXPECT_EQ(draw_sample(again, 7).inputs[0].value, draw_sample(once, 7).inputs[0].value);
    EXPECT_EQ(again.hash, once.hash);
    EXPECT_EQ(again.inputs[0].measured->hash, once.files[0].second);
  }
  std::string broken = study().resolved_toml;
  broken.replace(broken.find("names = ["), 9, "names = [ 'x',");
  EXPECT_THROW(read_resolved_study(broken, "broken"), InputError);
}

TEST_F(MeasuredStudy, RunsTheMeasuredCagesInTurn) {
  const Study turn = read_measured_study(
      (study(", fitted = true, centred = true"), folder_ + "study.toml"), {}, folder_ + "shop.csv");
  EXPECT_EQ(turn.samples, 48);  // whole rounds of 12
  EXPECT_TRUE(turn.candidates.empty());
  for (const std::uint64_t id : {0u, 5u, 17u, 47u}) {
    const Sample sample = draw_sample(turn, id);
    EXPECT_NEAR(sample.inputs[0].lot[0] + sample.inputs[0].pocket[4],
                width(static_cast<int>(id % kCages), 4), 1e-12);
    EXPECT_EQ(sample.lot, id % kCages);
  }
  EXPECT_NE(draw_sample(turn, 5).inputs[2].lot, draw_sample(turn, 17).inputs[2].lot);
}

TEST_F(MeasuredStudy, RefusesWhatContradictsTheCages) {
  const auto problem = [&](const std::string& setting) -> std::string {
    try {
      study("", {setting});
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(problem("scene.cage.pocket_width_mm.lot={law='normal',sigma=0.01}"),
              HasSubstr("measured cages say how cages differ"));
  EXPECT_THAT(problem("correlation=[{between=['cage.pocket_width_mm:lot','load.radial_N:lot'],"
                      "rho=0.5}]"),
              HasSubstr("drawn as whole measured cages"));
  EXPECT_THAT(problem("scene.cage.pocket_width_mm={law='normal',sigma=0.01}"), "no error");
}

TEST_F(MeasuredStudy, InTurnNeedsMeasuredCages) {
  write("study.toml", "samples = 4\n[scene]\nfile = 'reference.toml'\n");
  EXPECT_THROW(read_measured_study(folder_ + "study.toml", {}, folder_ + "shop.csv"), InputError);
}

}  // namespace
}  // namespace cagetol
