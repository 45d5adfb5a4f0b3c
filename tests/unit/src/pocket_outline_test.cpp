// The outline of bars in the radial plane, by closed forms.
#include "src/scene/pocket_outline.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <cmath>

#include "src/contacts/pocket_face.hpp"
#include "src/model/bearing_model.hpp"
#include "src/scene/pocket_clearances.hpp"
#include "src/simulate.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

constexpr double kPitch = 19.5e-3, kRoller = 3.75e-3, kPocket = 7.65e-3;

CageGeometry with_lips(double inner, double outer) {
  CageGeometry cage;
  cage.retention_inner = {inner};
  cage.retention_outer = {outer};
  return cage;
}

TEST(PocketOutline, FlatFacesEndARoundingBelowTheCagesSurfaces) {
  const CageGeometry cage;
  const PocketOutline outline = pocket_outline(cage, kPitch, 0);
  const double half = kPocket / 2, r = cage.edge_radius;
  EXPECT_DOUBLE_EQ(outline.end[0].height, std::sqrt(18.5e-3 * 18.5e-3 - half * half) + r);
  EXPECT_DOUBLE_EQ(outline.end[1].height, std::sqrt(21.7e-3 * 21.7e-3 - half * half) - r);
  EXPECT_DOUBLE_EQ(outline.end[0].offset, half + r);
  EXPECT_TRUE(std::isinf(roller_guide_clearance(Scene(), kPitch)));
}

// Sharp lips touch the roller where the chord between them is their opening.
TEST(PocketOutline, SharpLipsHoldTheRollerByTheChord) {
  CageGeometry cage = with_lips(6.4e-3, 6.8e-3);
  cage.edge_radius = 1e-12;
  const PocketOutline outline = pocket_outline(cage, kPitch, 0);
  const auto chord = [](double opening) {
    return std::sqrt(kRoller * kRoller - opening * opening / 4);
  };
  const auto surface = [](double radius, double opening) {
    return std::sqrt(radius * radius - opening * opening / 4);
  };
  EXPECT_NEAR(radial_play(outline, kPitch, kRoller, 1),
              surface(21.7e-3, 6.8e-3) - kPitch - chord(6.8e-3), 1e-11);
  EXPECT_NEAR(radial_play(outline, kPitch, kRoller, 0),
              kPitch - surface(18.5e-3, 6.4e-3) - chord(6.4e-3), 1e-11);
}

TEST(PocketOutline, SuggestsTheOpeningForAPlay) {
  CageGeometry cage;
  for (const int end : {0, 1}) {
    const double width = retention_width(cage, kPitch, kRoller, end, 80e-6);
    const CageGeometry lips = with_lips(end == 0 ? width : NAN, end == 1 ? width : NAN);
    EXPECT_NEAR(radial_play(pocket_outline(lips, kPitch, 0), kPitch, kRoller, end), 80e-6, 1e-12);
  }
}

TEST(PocketOutline, EachPocketHasItsOwnLips) {
  Scene scene = shipped_scene("nu205");
  const auto count = static_cast<std::size_t>(scene.bearing.roller_count);
  const double loose = retention_width(scene.cage, kPitch, kRoller, 1, 90e-6),
               tight = retention_width(scene.cage, kPitch, kRoller, 1, 50e-6),
               pinching = retention_width(scene.cage, kPitch, kRoller, 1, -5e-6);
  scene.cage.retention_outer.assign(count, loose);
  EXPECT_NEAR(roller_guide_clearance(scene, kPitch), 90e-6, 1e-12);
  scene.cage.retention_outer[3] = tight;
  EXPECT_NEAR(roller_guide_clearance(scene, kPitch), 50e-6, 1e-12);
  EXPECT_NEAR(pocket_clearances(scene, 3).radial[1], 50e-6, 1e-12);
  EXPECT_NEAR(pocket_clearances(scene, 4).radial[1], 90e-6, 1e-12);
  EXPECT_EQ(find_jam(scene).pocket, -1);
  scene.cage.retention_outer[5] = pinching;
  EXPECT_EQ(find_jam(scene).pocket, 5);
}

TEST(PocketOutline, RoundingsOfCurvedFacesTouchFaceAndSurface) {
  CageGeometry cage;
  cage.face_radius = 3.9e-3;
  const PocketOutline outline = pocket_outline(cage, kPitch, 0);
  const double surface[2] = {18.5e-3, 21.7e-3};
  for (const int k : {0, 1}) {
    const OutlineEnd& end = outline.end[k];
    EXPECT_NEAR(std::hypot(end.height - kPitch, end.offset - outline.face_offset),
                cage.face_radius + cage.edge_radius, 1e-15);
    const double top = end.height + (k == 0 ? -1 : 1) * cage.edge_radius;
    EXPECT_NEAR(std::hypot(top, end.offset), surface[k], 1e-12);
    EXPECT_NEAR(std::hypot(end.normal_height, end.normal_offset), 1, 1e-14);
  }
}

// As the axis passes the end of a face, flat or curved, the penetration goes on from face to
// rounding without a jump, and just one of them answers.
TEST(PocketFace, FaceAndRoundingMeetSmoothly) {
  for (const double face_radius : {kAuto, 3.9e-3}) {
    Scene scene;
    scene.cage.face_radius = face_radius;
    const BearingModel model = make_bearing_model(scene);
    const RollerGroup& group = model.groups[0];
    for (const std::size_t end : {0, 1}) {
      const OutlineArc& arc = group.ends[end];
      const double w = end == 0 ? arc.low_w[0] : arc.high_w[0],
                   u = end == 0 ? arc.low_u[0] : arc.high_u[0];
      const double d = group.radius[0] + arc.radius - 2e-6;
      double p[2];
      for (const int side : {0, 1}) {
        const double turn = (side == 0 ? -1 : 1) * 1e-7;
        PocketFrame f{};
        f.D_R = splat(arc.height[0] - d * (w * std::cos(turn) - u * std::sin(turn)));
        f.D_T = splat(arc.offset[0] - d * (u * std::cos(turn) + w * std::sin(turn)));
        const AxisPlace at = axis_place(f, 0);
        const FaceMeeting face =
            std::isnan(face_radius)
                ? FlatFace(model, group, f, beyond_edges(model, group, f)).meet(at, 1)
                : ArcFace(model, group, f, group.face).meet(at, 1);
        const FaceMeeting edge = ArcFace(model, group, f, arc).meet(at, 1);
        EXPECT_NE(face.here[0] != 0, edge.here[0] != 0) << end << ", " << side;
        p[side] = face.here[0] ? face.p[0] : edge.p[0];
      }
      EXPECT_NEAR(p[0], 2e-6, 1e-9);
      EXPECT_NEAR(p[1], p[0], 1e-9);
    }
  }
}

TEST(PocketOutline, ChecksRefuseWhatHoldsNoRoller) {
  const auto problem = [](auto change) -> std::string {
    Scene scene = shipped_scene("nu205");
    change(scene);
    try {
      check_scene(scene, "scene.toml", nullptr);
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_THAT(problem([](Scene& s) { s.cage.guidance = Guidance::roller; }),
              HasSubstr("flat parallel pocket faces"));
  EXPECT_THAT(problem([](Scene& s) { s.cage.retention_outer = {7.7e-3}; }),
              HasSubstr("not narrower than the pocket"));
  EXPECT_THAT(problem([](Scene& s) { s.cage.retention_outer = {5e-3}; }), HasSubstr("pinch"));
  EXPECT_THAT(problem([](Scene& s) { s.cage.face_radius = 3.8e-3; }), HasSubstr("more hollow"));
  EXPECT_THAT(problem([](Scene& s) {
                s.cage.face_radius = 4e-3;
                s.cage.retention_outer = {7e-3};
              }),
              HasSubstr("either lips or a face radius"));
  // Rings that stop the cage first.
  EXPECT_THAT(problem([](Scene& s) {
                s.cage.guidance = Guidance::roller;
                s.cage.retention_outer = {7.2e-3};
              }),
              HasSubstr("the rings stop it"));
  EXPECT_THAT(problem([](Scene& s) {
                s.cage.guidance = Guidance::roller;
                s.cage.retention_outer = {7.6e-3};
              }),
              HasSubstr("rollers never hold the cage"));
  EXPECT_EQ(problem([](Scene& s) {
              s.cage.guidance = Guidance::roller;
              s.cage.retention_outer = {retention_width(s.cage, kPitch, kRoller, 1, 80e-6)};
            }),
            "none");
}

TEST(PocketOutline, NamesRollersBesideTheFaces) {
  Scene scene = shipped_scene("nu205");
  EXPECT_THAT(scene_doubts(scene), SizeIs(0));
  scene.cage.outer_diameter = 39e-3;
  EXPECT_THAT(scene_doubts(scene), SizeIs(1));
}

}  // namespace
}  // namespace cagetol
