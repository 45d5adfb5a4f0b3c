// Normal forces of the races, as statics takes them, against the contacts of the moving bearing.
#include "src/statics/race_normals.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/contacts/race_contacts.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

class NormalsOfARace : public testing::Test {
 protected:
  NormalsOfARace() {
    model_ = make_bearing_model(dry_scene("nu205"));
    model_.friction[kRacePair].static_coefficient = model_.friction[kRacePair].dynamic_coefficient =
        0;
    q_.r = splat(model_.inner_radius + model_.nominal_diameter / 2 - 3e-6);
    q_.a_r = splat(2e-4);
    q_.vt = splat(9);
    q_.vr = splat(-0.002);
    q_.spin = -q_.vt / model_.groups[0].radius;
    q_.cosine = splat(1);
  }
  RaceSide race(double sign, double u_r, double u_t, double tilt_r, double tilt_t) const {
    const bool inner = sign > 0;
    RaceSide side{sign, inner ? model_.inner_radius : model_.outer_radius, 0.0, {}, {}, {}, {}, {},
                  {}};
    side.u_r = splat(u_r);
    side.u_t = splat(u_t);
    side.B_r = splat(tilt_r);
    side.B_t = splat(tilt_t);
    return side;
  }
  RaceNormals normals(const RaceSide& race) const {
    return race_normals(model_, model_.race, model_.groups[0], q_, race);
  }

  BearingModel model_;
  RollerPack q_{};
};

TEST_F(NormalsOfARace, AreThoseOfItsContactsWithoutFriction) {
  for (const double sign : {1.0, -1.0}) {
    if (sign < 0) q_.r = splat(model_.outer_radius - model_.nominal_diameter / 2 + 2e-6);
    const RaceSide side = race(sign, 4e-6 * sign, 7e-6, 1e-4, 3e-4);
    RollerLoads loads;
    RaceTotals sums;
    GroupLinear linear{};
    Observation seen(model_);
    race_contacts<true, true>(model_, model_.groups[0], q_, side, loads, &linear, &seen, sums);
    const RaceNormals on = normals(side);
    ASSERT_GT(on.total[0], 10);
    const auto same = [](Pack a, Pack b) { EXPECT_NEAR(a[0], b[0], 1e-12 * std::abs(b[0])); };
    same(on.total, sums.normal);
    same(on.elastic[0], sums.normal_r);
    same(on.elastic[1], sums.normal_t);
    same(on.force[0][0], loads.f[kLr]);
    same(on.force[0][1], loads.f[kLt]);
    same(on.force[1][0], loads.f[kLar]);
    same(on.force[1][1], loads.f[kLat]);
  }
}

TEST_F(NormalsOfARace, HaveTheSlopesOfTheirForces) {
  const RaceNormals at = normals(race(1, 4e-6, 7e-6, 1e-4, 3e-4));
  // A move of the race by du, and by its tilt dB, of the axis seen by it: -du - X dB.
  for (int along = 0; along < 2; ++along)
    for (int of = 0; of < 2; ++of) {
      const double step = of == 0 ? 1e-10 : 1e-7;
      const auto moved = [&](double by) {
        double u[2] = {4e-6, 7e-6}, tilt[2] = {1e-4, 3e-4};
        (of == 0 ? u : tilt)[along] += by;
        return normals(race(1, u[0], u[1], tilt[0], tilt[1]));
      };
      const RaceNormals more = moved(step), less = moved(-step);
      for (int m = 0; m < 2; ++m)
        for (int i = 0; i < 2; ++i) {
          const double slope = -(more.force[m][i][0] - less.force[m][i][0]) / (2 * step);
          const double scale = std::abs(at.slope[m + of][0][0][0]);
          EXPECT_NEAR(at.slope[m + of][i][along][0], slope, 1e-6 * scale) << m << i << of << along;
        }
    }
}

}  // namespace
}  // namespace cagetol
