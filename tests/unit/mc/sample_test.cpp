#include "mc/study/sample.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <set>

#include "distributions/basics/random_stream.hpp"
#include "mc/study/cage_fit.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {
namespace {

constexpr double kSigma = 0.009;

Study base_study() {
  Study study;
  study.samples = 64;
  UncertainInput width{.key = "cage.pocket_width_mm",
                       .unit = "mm",
                       .nominal = {7.65},
                       .per_pocket = true,
                       .lot = Normal{0, kSigma},
                       .pocket = Normal{0, kSigma},
                       .noise = std::nullopt};
  UncertainInput pitch{.key = "cage.pocket_pitch_mrad",
                       .unit = "mrad",
                       .nominal = {0},
                       .per_pocket = true,
                       .lot = std::nullopt,
                       .pocket = Normal{0, 0.3},
                       .noise = std::nullopt};
  UncertainInput load{.key = "load.radial_N",
                      .unit = "N",
                      .nominal = {1000},
                      .per_pocket = false,
                      .lot = Uniform{-10, 10},
                      .pocket = std::nullopt,
                      .noise = std::nullopt};
  UncertainInput phase{.key = "start.cage_phase_deg",
                       .unit = "deg",
                       .nominal = {0},
                       .per_pocket = false,
                       .lot = std::nullopt,
                       .pocket = std::nullopt,
                       .noise = Uniform{0, 360}};
  study.inputs = {width, pitch, load, phase};
  return study;
}

void expect_identical(const Sample& a, const Sample& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.row, b.row);
  EXPECT_EQ(a.candidate, b.candidate);
  ASSERT_EQ(a.inputs.size(), b.inputs.size());
  for (std::size_t i = 0; i < a.inputs.size(); ++i) {
    EXPECT_EQ(a.inputs[i].lot, b.inputs[i].lot);
    EXPECT_EQ(a.inputs[i].pocket, b.inputs[i].pocket);
    EXPECT_EQ(a.inputs[i].noise, b.inputs[i].noise);
    EXPECT_EQ(a.inputs[i].value, b.inputs[i].value);
  }
  EXPECT_EQ(a.scene.cage.pocket_width, b.scene.cage.pocket_width);
  EXPECT_EQ(a.scene.cage.pocket_pitch, b.scene.cage.pocket_pitch);
  EXPECT_EQ(a.scene.operation.radial_load, b.scene.operation.radial_load);
  EXPECT_EQ(a.scene.start.cage_phase, b.scene.start.cage_phase);
}

TEST(Sample, IsAPureFunctionOfStudyAndId) {
  using enum DesignKind;
  for (const DesignKind design : {random, lhs}) {
    Study study = base_study();
    study.design = design;
    study.extra_replicates = 1;
    const Sampler forward(study), backward(study);
    const std::uint64_t count = std::min<std::uint64_t>(sample_count(study), 200);
    std::vector<Sample> there;
    for (std::uint64_t id = 0; id < count; ++id) there.push_back(forward.draw(id));
    for (std::uint64_t id = count; id-- > 0;) expect_identical(there[id], backward.draw(id));
    expect_identical(there[count / 2], draw_sample(study, count / 2));
  }
}

TEST(Sample, AddingAnInputMovesNoOtherDraw) {
  Study with = base_study(), without = base_study();
  without.inputs.erase(without.inputs.begin());
  const Sampler a(with), b(without);
  for (std::uint64_t id = 0; id < 20; ++id) {
    EXPECT_EQ(a.draw(id).inputs[1].value, b.draw(id).inputs[0].value);
    EXPECT_EQ(a.draw(id).inputs[3].value, b.draw(id).inputs[2].value);
  }
}

TEST(Sample, DrawsStandAtTheirAddresses) {
  const Study study = base_study();
  const Sample sample = draw_sample(study, 5);
  const auto stream = stream_address("cage.pocket_width_mm");
  EXPECT_EQ(sample.inputs[0].lot[0],
            quantile(*study.inputs[0].lot, uniform(1, Purpose::lot, 5, stream, 0)));
  EXPECT_EQ(sample.inputs[0].pocket[3],
            quantile(*study.inputs[0].pocket, uniform(1, Purpose::pocket, 5, stream, 3)));
  EXPECT_EQ(sample.inputs[3].noise[0],
            quantile(*study.inputs[3].noise,
                     uniform(1, Purpose::noise, 5, stream_address("start.cage_phase_deg"), 0)));
}

TEST(Sample, DeviationsAddUpAndArriveInTheScene) {
  const Sample sample = draw_sample(base_study(), 7);
  ASSERT_EQ(sample.scene.cage.pocket_width.size(), 13u);
  for (std::size_t j = 0; j < 13; ++j) {
    EXPECT_EQ(sample.inputs[0].value[j],
              7.65 + sample.inputs[0].lot[0] + sample.inputs[0].pocket[j]);
    EXPECT_NEAR(sample.scene.cage.pocket_width[j], sample.inputs[0].value[j] * 1e-3, 1e-17);
  }
  EXPECT_EQ(sample.scene.operation.radial_load, sample.inputs[2].value[0]);
  EXPECT_NEAR(sample.scene.start.cage_phase, sample.inputs[3].value[0] * M_PI / 180, 1e-15);
}

TEST(Sample, ReplicatesKeepTheRowAndChangeTheNoise) {
  Study study = base_study();
  study.extra_replicates = 2;
  const Sampler sampler(study);
  const auto first = sampler.draw(3), second = sampler.draw(64 + 3), third = sampler.draw(128 + 3);
  EXPECT_EQ(second.row, 3u);
  EXPECT_EQ(third.replicate, 2u);
  EXPECT_EQ(first.inputs[0].value, second.inputs[0].value);
  EXPECT_NE(first.inputs[3].noise, second.inputs[3].noise);
  EXPECT_NE(second.inputs[3].noise, third.inputs[3].noise);
}

TEST(Sample, CagesOfALotShareItsDraw) {
  Study study = base_study();
  study.cages_per_lot = 4;
  const Sampler sampler(study);
  EXPECT_EQ(sampler.draw(4).inputs[0].lot, sampler.draw(7).inputs[0].lot);
  EXPECT_NE(sampler.draw(7).inputs[0].lot, sampler.draw(8).inputs[0].lot);
  EXPECT_NE(sampler.draw(4).inputs[0].pocket, sampler.draw(7).inputs[0].pocket);
  EXPECT_EQ(sampler.draw(7).lot, 1u);
}

TEST(Sample, ACandidateScalesTheDeviationsOfItsKey) {
  Study study = base_study(), plain = base_study();
  study.tolerance.dimensions = {{"cage.pocket_width_mm", 0.1, {"0.05", "0.2"}, {}}};
  study.candidates = {{{0.05}, {""}, {0.5}}, {{0.2}, {""}, {2}}};
  const Sampler scaled(study), unscaled(plain);
  for (std::uint64_t id = 0; id < 6; ++id) {
    const auto a = scaled.draw(id), b = unscaled.draw(id);
    const double scale = id % 2 ? 2 : 0.5;
    EXPECT_EQ(a.candidate, static_cast<long>(id % 2));
    EXPECT_EQ(a.inputs[0].lot[0], scale * b.inputs[0].lot[0]);
    EXPECT_EQ(a.inputs[0].pocket[12], scale * b.inputs[0].pocket[12]);
    EXPECT_EQ(a.inputs[1].value, b.inputs[1].value);
  }
  study.scale_lots = false;
  const auto a = Sampler(study).draw(1), b = unscaled.draw(1);
  EXPECT_EQ(a.inputs[0].lot, b.inputs[0].lot);
  EXPECT_EQ(a.inputs[0].pocket[12], 2 * b.inputs[0].pocket[12]);
}

TEST(Sample, ACandidateMovesTheCentreOfItsKey) {
  Study study = base_study(), plain = base_study();
  study.tolerance.dimensions = {{"cage.pocket_width_mm", 0.1, {"0.1"}, {7.6, 7.7}, {}}};
  study.candidates = {{{0.1}, {""}, {1}, {-0.05}}, {{0.1}, {""}, {1}, {0.05}}};
  const Sampler moved(study), unmoved(plain);
  for (std::uint64_t id = 0; id < 4; ++id) {
    const auto a = moved.draw(id), b = unmoved.draw(id);
    const double shift = id % 2 ? 0.05 : -0.05;
    EXPECT_EQ(a.inputs[0].lot[0], b.inputs[0].lot[0] + shift);
    EXPECT_EQ(a.inputs[0].pocket, b.inputs[0].pocket);
    EXPECT_NEAR(a.inputs[0].value[5], b.inputs[0].value[5] + shift, 1e-12);
  }
  Study zoned = study;
  zoned.candidates[1].middles = {0.025};
  EXPECT_EQ(Sampler(zoned).draw(1).inputs[0].lot[0],
            unmoved.draw(1).inputs[0].lot[0] + (0.05 + 0.025));
  study.inputs[0].lot.reset();
  const auto a = Sampler(study).draw(1);
  plain.inputs[0].lot.reset();
  const auto b = Sampler(plain).draw(1);
  EXPECT_EQ(a.inputs[0].pocket[3], b.inputs[0].pocket[3] + 0.05);
}

TEST(Sample, ZeroWidthIsAPlainNumber) {
  Study study = base_study();
  study.inputs[0].lot = Normal{0.01, 0};
  study.inputs[0].pocket = Uniform{0, 0};
  EXPECT_EQ(design_columns(study), 13u + 1u);
  const auto sample = draw_sample(study, 9);
  for (const double value : sample.inputs[0].value) EXPECT_EQ(value, 7.65 + 0.01);
}

TEST(Sample, NoDeviationLeavesTheNominalBits) {
  Study study = base_study();
  study.inputs = {study.inputs[0]};
  study.inputs[0].lot = Normal{0, 0};
  study.inputs[0].pocket = std::nullopt;
  for (const double width : draw_sample(study, 0).scene.cage.pocket_width)
    EXPECT_EQ(width, study.scene.cage.pocket_width[0]);
}

TEST(Sample, ValuesOutsideTheRangeOfTheirKeyAreSetToItsEnd) {
  Study study = base_study();
  study.inputs = {study.inputs[2]};
  study.inputs[0].lot = Uniform{-3000, -2000};
  EXPECT_EQ(draw_sample(study, 0).scene.operation.radial_load, 0);
}

TEST(Sample, ColumnsAreThoseOfLotsAndOfEachPocket) {
  EXPECT_EQ(design_columns(base_study()), 1u + 13u + 13u + 1u);
}

TEST(Sample, CorrelatedInputsMoveTogether) {
  Study study = base_study();
  study.samples = 4000;
  study.correlations = {{"cage.pocket_width_mm:pocket", "cage.pocket_pitch_mrad:pocket", 0.8}};
  const Sampler sampler(study);
  double same = 0, other = 0, xx = 0, yy = 0;
  for (std::uint64_t id = 0; id < 4000; ++id) {
    const auto sample = sampler.draw(id);
    const double x = sample.inputs[0].pocket[4], y = sample.inputs[1].pocket[4];
    same += x * y;
    other += x * sample.inputs[1].pocket[5];
    xx += x * x;
    yy += y * y;
  }
  EXPECT_NEAR(same / std::sqrt(xx * yy), 0.8, 0.03);
  EXPECT_NEAR(other / std::sqrt(xx * yy), 0, 0.05);
}

// Generous: the bound is there to catch a design or a factorisation made anew for every draw.
TEST(Sample, ADrawCostsMicroseconds) {
  Study study = base_study();
  study.design = DesignKind::lhs;
  study.correlations = {{"cage.pocket_width_mm:pocket", "cage.pocket_pitch_mrad:pocket", 0.8}};
  const Sampler sampler(study);
  const auto start = std::chrono::steady_clock::now();
  double sum = 0;
  for (std::uint64_t id = 0; id < 2000; ++id) sum += sampler.draw(id % 64).inputs[0].value[0];
  const std::chrono::duration<double, std::micro> each =
      (std::chrono::steady_clock::now() - start) / 2000;
  RecordProperty("microseconds", static_cast<int>(each.count()));
  EXPECT_GT(sum, 0);
  EXPECT_LT(each.count(), 400);
}

/// Two in five cages do not fit.
Study jamming_study() {
  Study study = base_study();
  study.scene.cage.pocket_width = {7.65e-3};
  study.inputs[0].pocket = Normal{0, 0.08};
  study.redraw_jams = true;
  return study;
}

TEST(Redraw, GivesCagesThatFitAndKeepsThoseThatDo) {
  using enum DesignKind;
  for (const DesignKind design : {random, lhs}) {
    Study study = jamming_study();
    study.design = design;
    Study plain = study;
    plain.redraw_jams = false;
    const Sampler redrawing(study), as_drawn(plain), again(study);
    int redrawn = 0;
    std::set<std::uint64_t> lots;
    for (auto id = static_cast<std::uint64_t>(study.samples); id-- > 0;) {
      const Sample sample = redrawing.draw(id), first = as_drawn.draw(id);
      EXPECT_TRUE(cage_fits(study, sample.scene));
      expect_identical(sample, again.draw(id));
      lots.insert(sample.lot);
      if (cage_fits(study, first.scene)) {
        expect_identical(sample, first);
      } else {
        ++redrawn;
        EXPECT_NE(sample.inputs[0].lot, first.inputs[0].lot);  // the lot is drawn again as well
        EXPECT_NE(sample.inputs[2].value, first.inputs[2].value);
        EXPECT_EQ(sample.inputs[3].value, first.inputs[3].value);  // noise is the sample's own
      }
    }
    EXPECT_GT(redrawn, study.samples / 5);
    EXPECT_EQ(lots.size(), static_cast<std::size_t>(study.samples));
  }
}

TEST(Redraw, RepetitionsAreOfOneCage) {
  Study study = jamming_study();
  study.extra_replicates = 1;
  const Sampler sampler(study);
  for (std::uint64_t row = 0; row < 64; ++row) {
    const Sample first = sampler.draw(row), second = sampler.draw(row + 64);
    EXPECT_EQ(first.scene.cage.pocket_width, second.scene.cage.pocket_width);
    EXPECT_NE(first.scene.start.cage_phase, second.scene.start.cage_phase);
  }
}

// Of a tolerance under which nothing fits a run jams.
TEST(Redraw, EndsWhereNothingFits) {
  Study study = jamming_study();
  study.inputs[0].nominal = {7.3};
  study.inputs[0].pocket = Normal{0, 0.01};
  EXPECT_FALSE(cage_fits(study, draw_sample(study, 0).scene));
}

// A lot's redrawn cage is of another lot.
TEST(Redraw, TakesALotOfItsOwn) {
  Study study = jamming_study();
  study.cages_per_lot = 8;
  const Sampler sampler(study);
  std::map<std::uint64_t, double> value;
  std::size_t redrawn = 0;
  for (std::uint64_t id = 0; id < 64; ++id) {
    const Sample sample = sampler.draw(id);
    const auto [known, fresh] = value.try_emplace(sample.lot, sample.inputs[0].lot[0]);
    EXPECT_EQ(known->second, sample.inputs[0].lot[0]);
    redrawn += sample.lot != id / 8;
  }
  EXPECT_GT(redrawn, 5u);
}

}  // namespace
}  // namespace cagetol
