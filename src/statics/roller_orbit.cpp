// Above 400 lines: the steps of one search, which share its state.
#include "src/statics/roller_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "src/contacts/churning_loads.hpp"
#include "src/contacts/lubricated_pocket.hpp"
#include "src/contacts/lubricated_race.hpp"
#include "src/statics/static_equilibrium.hpp"

namespace cagetol {
namespace {

constexpr int kAngles = 128;
constexpr int kOrbitIterations = 60;
constexpr double kStaticsAccuracy = 1e-6;
constexpr double kRadialReach = 0.3e-3;  ///< from the pitch circle, of rollers at the start [m]
constexpr int kHalvings = 20;            ///< of that
constexpr double kSpinWithin = 1e-4;     ///< of the last move of a spin, share of pure rolling
constexpr double kPlaceWithin = 1e-9;    ///< likewise of a place [m]
constexpr double kOrbitMove = 2e-6;      ///< of a roller or the ring in one iteration [m]
constexpr double kLargestTurn = 0.2;     ///< change of a spin in one iteration, share of rolling
constexpr double kPlaceProbe = 1e-10, kSpinProbe = 1e-6;  ///< for slopes [m], share of rolling
constexpr double kGrowth = 1.2, kForget = 0.3, kProgress = 0.7;
constexpr int kMostTries = 3;
constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kMissWithin = 1e-8;  ///< sum of moments that is as good as none [N m]
constexpr double kOrbitSpring = 1e3;  ///< that keeps a matrix regular [N/m]
constexpr double kReach = 5e-6;       ///< of a bar's deformation, at most [m]
constexpr int kOrbitHalvings = 60;

/// All lanes a roller of mean size and place.
RollerGroup mean_roller(const BearingModel& m) {
  RollerGroup mean = m.groups.front();
  const double count = m.layout.rollers;
  const auto average = [&](Pack RollerGroup::*member) {
    double total = 0;
    for (const RollerGroup& g : m.groups) total += sum(g.exists * (g.*member));
    mean.*member = splat(total / count);
  };
  for (Pack RollerGroup::*member :
       {&RollerGroup::mass, &RollerGroup::polar, &RollerGroup::transverse, &RollerGroup::radius,
        &RollerGroup::half_width, &RollerGroup::half_length})
    average(member);
  mean.exists = splat(1);
  mean.inverse_mass = 1.0 / mean.mass;
  mean.inverse_polar = 1.0 / mean.polar;
  mean.inverse_transverse = 1.0 / mean.transverse;
  mean.taper_slope = mean.squareness = Pack{};
  return mean;
}

/// A rigid cage, and `count` mean rollers between rings that are not tilted.
BearingModel straight(const BearingModel& from, int count, const RollerGroup& roller) {
  BearingModel m = from;
  m.misalignment_y = m.misalignment_z = 0;
  m.forms = {};
  m.layout = {count, (count + kLanes - 1) / kLanes, 0, 0};
  m.flexible = {};
  m.groups.assign(static_cast<std::size_t>(m.layout.groups), roller);
  for (int j = count; j < m.layout.padded(); ++j) m.groups.back().exists[j % kLanes] = 0;
  return m;
}

}  // namespace

/// On a pack of rollers.
struct RollerOrbit::Forces {
  Pack radial, moment;       ///< balance along e_r [N], moment about the axis [N m]
  Pack inner, inner_moment;  ///< of the inner race: along e_r [N], about the axis [N m]
};

RollerOrbit::RollerOrbit(const BearingModel& model)
    : roller_(mean_roller(model)),
      model_(straight(model, kAngles, roller_)),
      bar_(model.bar_line),
      share_(static_cast<double>(model.layout.rollers) / kAngles),
      load_(ring_force_at(model, 0)),
      speeds_(ring_speeds_at(model.duty, 0)) {
  bar_.length *= static_cast<double>(model.bar_stations.size());
  rolling_ = std::abs(kinematic_cage_speed(model, speeds_) - speeds_.outer) * model.outer_radius /
             roller_.radius[0];
  for (int k = 0; k < kAngles; k += kLanes) {
    Pack angle, sine, cosine;
    for (int i = 0; i < kLanes; ++i) angle[i] = 2 * std::numbers::pi * (k + i) / kAngles;
    sine_cosine(angle, sine, cosine);
    sine_.push_back(sine);
    cosine_.push_back(cosine);
  }
  r_.resize(sine_.size());
  s_ = x_ = r_;
  start(straight(model, model.layout.rollers, roller_));
}

void RollerOrbit::start(const BearingModel& whole) {
  std::vector<double> angle(static_cast<std::size_t>(whole.layout.padded()));
  for (std::size_t j = 0; j < angle.size(); ++j)
    angle[j] = 2 * std::numbers::pi * static_cast<double>(j) / whole.layout.rollers;
  speed_ = kinematic_cage_speed(whole, speeds_);
  StaticEquilibrium statics(whole, kStaticsAccuracy);
  const StaticState& rest = statics.solve(angle.data(), speed_, load_at(whole.duty, 0));
  ring_[0] = rest.ring_y;
  ring_[1] = rest.ring_z;
  const Pack rolling =
      (whole.pitch_radius * speed_ - whole.inner_radius * speeds_.inner) / roller_.radius;
  for (std::size_t k = 0; k < r_.size(); ++k) {
    s_[k] = rolling;
    Pack low = splat(whole.pitch_radius - kRadialReach), high = low + 2 * kRadialReach;
    for (int halving = 0; halving < kHalvings; ++halving) {
      r_[k] = 0.5 * (low + high);
      x_[k] = Pack{};
      const Mask outwards = forces(k, r_[k], s_[k], x_[k]).radial > 0.0;
      low = select(outwards, r_[k], low);
      high = select(outwards, high, r_[k]);
    }
  }
}

// Net force of both bars on a roller along e_t falls with x, steeply where a film is thin and not
// at all between the layers: Newton's method between bounds.
void RollerOrbit::balance_pocket(Pack need, Pack s, Pack& x) const {
  using D = Dual<Pack, 1>;
  const Pack play = roller_.half_width - roller_.radius;
  const Pack u = 0.5 * roller_.radius * (speed_ - s);
  Pack low = -abs(play) - kReach, high = -low;
  const auto force = [&](double side) {  // of the bar ahead (side = 1) or behind
    D gap{};
    gap.value = play - side * x;
    gap.slope[0] = splat(-side);
    const Mask wet = gap.value < bar_.layer;
    gap.value = select(wet, gap.value, splat(0.5 * bar_.layer));
    D speed{};
    speed.value = side * u;
    D push = line_normal(bar_, line_speed(bar_, speed), gap, D{}).normal;
    push.value = select(wet, push.value, Pack{});
    push.slope[0] = select(wet, push.slope[0], Pack{});
    return push;
  };
  for (int k = 0; k < kOrbitHalvings; ++k) {
    const D behind = force(-1), ahead = force(1);
    const Pack miss = behind.value - ahead.value - need, slope = behind.slope[0] - ahead.slope[0];
    low = select(miss > 0.0, x, low);
    high = select(miss > 0.0, high, x);
    if (!any(abs(miss) > 1e-7 * abs(need) + 1e-10)) break;
    const Pack next = x - miss / min(slope, splat(-1e-9));
    x = select((next > low) & (next < high), next, 0.5 * (low + high));
    if (!any(high - low > 1e-14)) break;
  }
}

namespace {

/// A pack of rollers without lean that go round steadily.
RollerPack steady_pack(Pack sine, Pack cosine, Pack r, Pack s, double rate) {
  RollerPack q{};
  q.sine = sine;
  q.cosine = cosine;
  q.r = r;
  q.spin = s;
  q.omega = splat(rate);
  q.vt = r * rate;
  return q;
}

/// Bars at rest against a pack of rollers at `x` in its pockets, flat whatever their outline: it is
/// a start that is sought.
void bars_on(const BearingModel& model, const RollerGroup& roller, const RollerPack& q, Pack x,
             RollerLoads& loads, BorderLoads& border) {
  static const FlexibleCage rigid;
  const ModalState modal{&rigid, nullptr, nullptr, nullptr, 0, 0};
  PocketFrame f{};
  f.sin_b = x / q.r;
  f.cos_b = sqrt(1.0 - f.sin_b * f.sin_b);
  f.cos_p = q.cosine * f.cos_b + q.sine * f.sin_b;
  f.sin_p = q.sine * f.cos_b - q.cosine * f.sin_b;
  f.D_R = q.r * f.cos_b;
  f.D_T = x;
  f.v_R = -q.omega * x;
  f.v_T = q.omega * f.D_R;
  BorderState b{};
  b.phi_rate = q.omega[0];
  lubricated_pocket<false>(model, FlatFace(model, roller, f, false), q, b, modal, 0, loads, border,
                           nullptr, nullptr, nullptr);
}

}  // namespace

RollerOrbit::Forces RollerOrbit::forces(std::size_t pack, Pack r, Pack s, Pack& x) const {
  const Pack sine = sine_[pack], cosine = cosine_[pack], zero{};
  const RollerPack q = steady_pack(sine, cosine, r, s, speed_);
  const RaceSide inner{1,
                       model_.inner_radius,
                       speeds_.inner,
                       along_r(q, splat(ring_[0]), splat(ring_[1])),
                       along_t(q, splat(ring_[0]), splat(ring_[1])),
                       zero,
                       zero,
                       zero,
                       zero};
  const RaceSide outer{-1, model_.outer_radius, speeds_.outer, {}, {}, {}, {}, {}, {}};
  RollerLoads loads;
  RaceTotals totals;
  lubricated_race<false, true>(model_, model_.inner_line, roller_, q, inner, loads, nullptr,
                               nullptr, totals);
  Forces f;
  f.inner = loads.f[kLr];
  f.inner_moment = loads.f[kLs];
  lubricated_race<false, false>(model_, model_.outer_line, roller_, q, outer, loads, nullptr,
                                nullptr, totals);
  if (model_.churning.on) {
    BorderState cage{};
    cage.phi_rate = speed_;
    roller_churning<false>(model_.churning, roller_, q, cage, loads, nullptr, nullptr);
  }
  const Pack need = roller_.mass * model_.gravity * cosine - loads.f[kLt];
  balance_pocket(need, s, x);
  BorderLoads border;
  bars_on(model_, roller_, q, x, loads, border);
  f.radial = loads.f[kLr] + roller_.mass * (q.vt * q.omega - model_.gravity * sine);
  f.moment = loads.f[kLs];
  return f;
}

void RollerOrbit::collect(std::size_t pack, Pack r, Pack s, Pack x, double (&on_cage)[3]) const {
  const RollerPack q = steady_pack(sine_[pack], cosine_[pack], r, s, speed_);
  RollerLoads loads;
  BorderLoads border;
  bars_on(model_, roller_, q, x, loads, border);
  on_cage[0] += share_ * border.cage[0];
  on_cage[1] += share_ * border.cage[1];
  on_cage[2] += share_ * border.cage[3];
}

// Upwind differences of first order are stable, however stiff traction is. Newton's method for all
// angles at once; where traction saturates its slope is too small, so that it would jump to and fro
// across the steep middle. With a steeper one, of the last move, the sum of all misses cannot grow:
// the system is monotone.
struct RollerOrbit::Search {
  explicit Search(RollerOrbit& of)
      : orbit(of),
        packs(of.r_.size()),
        way(of.speed_ < 0 || (of.speed_ == 0 && of.speeds_.inner < 0) ? -1 : 1),
        inertia(std::abs(of.speed_) * of.roller_.polar[0] * kAngles / (2 * std::numbers::pi)),
        spin_probe(kSpinProbe * of.rolling_) {}

  /// The n-th angle along the cage's turning.
  std::size_t angle(int n) const {
    return static_cast<std::size_t>((way > 0 ? n : -n) & (kAngles - 1));
  }
  double miss_now();
  void steepen();
  void keep();
  void linearise(bool better);
  void move_ring();
  double turn_spins();
  void move();

  RollerOrbit& orbit;
  const std::size_t packs;
  const int way;
  const double inertia, spin_probe;
  std::vector<Forces> now = std::vector<Forces>(packs), from_forces;
  std::vector<Pack> dr = std::vector<Pack>(packs), response = dr, by_place = dr, stiff = dr,
                    inner = dr, by_ring = dr, from_r, from_s, from_x;
  std::vector<double> spin = std::vector<double>(kAngles), miss = spin, from_miss = spin,
                      change = spin, steep = spin;
  double pushed[2] = {0, 0}, last_pushed[2] = {0, 0}, du[2] = {0, 0};
  double stiffness[3] = {0, 0, 0};       ///< of the rollers against the ring: yy, yz, zz
  double turned = kNone, moved = kNone;  ///< by the last move
};

/// The sum of what moments miss at the present spins.
double RollerOrbit::Search::miss_now() {
  for (std::size_t k = 0; k < packs; ++k) {
    now[k] = orbit.forces(k, orbit.r_[k], orbit.s_[k], orbit.x_[k]);
    store(spin.data() + k * kLanes, orbit.s_[k]);
    store(miss.data() + k * kLanes, now[k].moment);
  }
  double misses = 0;
  for (int n = 0; n < kAngles; ++n) {
    const std::size_t i = angle(n);
    miss[i] -= inertia * (spin[i] - spin[angle(n - 1)]);
    misses += std::abs(miss[i]);
  }
  return misses;
}

/// Slopes at least as steep as the last move found them.
void RollerOrbit::Search::steepen() {
  for (std::size_t k = 0; k < packs; ++k)
    for (int i = 0; i < kLanes; ++i) {
      const auto n = k * kLanes + static_cast<std::size_t>(i);
      if (std::abs(change[n]) < spin_probe) continue;
      const double secant = (from_forces[k].moment[i] - now[k].moment[i]) / change[n];
      steep[n] = std::max(steep[n], secant);
    }
}

/// The state from which the next move starts.
void RollerOrbit::Search::keep() {
  from_forces = now;
  from_r = orbit.r_;
  from_s = orbit.s_;
  from_x = orbit.x_;
}

/// Slopes of all forces; `better`: the steepest ones seen may be forgotten a little.
void RollerOrbit::Search::linearise(bool better) {
  pushed[0] = orbit.load_.y;
  pushed[1] = orbit.load_.z;
  stiffness[0] = stiffness[2] = kOrbitSpring;
  stiffness[1] = 0;
  for (std::size_t k = 0; k < packs; ++k) {
    const Forces& f = now[k];
    const Pack cosine = orbit.cosine_[k], sine = orbit.sine_[k];
    Pack near = orbit.x_[k];
    const Forces out = orbit.forces(k, orbit.r_[k] + kPlaceProbe, orbit.s_[k], near);
    near = orbit.x_[k];
    const Forces fast = orbit.forces(k, orbit.r_[k], orbit.s_[k] + spin_probe, near);
    stiff[k] = max((f.radial - out.radial) / kPlaceProbe, splat(kOrbitSpring));
    inner[k] = max((f.inner - out.inner) / kPlaceProbe, Pack{});
    response[k] = (fast.radial - f.radial) / spin_probe / stiff[k];
    by_place[k] = (out.moment - f.moment) / kPlaceProbe;
    by_ring[k] = (f.inner_moment - out.inner_moment) / kPlaceProbe;
    const Pack slope = (f.moment - fast.moment) / spin_probe - by_place[k] * response[k];
    double* const at = steep.data() + k * kLanes;
    store(at, max(slope, max((better ? kForget : 1.0) * load(at), splat(1e-12))));
    pushed[0] -= orbit.share_ * sum(cosine * f.inner);
    pushed[1] -= orbit.share_ * sum(sine * f.inner);
    const Pack both = inner[k] * max(1.0 - inner[k] / stiff[k], Pack{});
    stiffness[0] += orbit.share_ * sum(both * cosine * cosine);
    stiffness[1] += orbit.share_ * sum(both * cosine * sine);
    stiffness[2] += orbit.share_ * sum(both * sine * sine);
  }
}

/// How far the ring moves, and what moments miss with rollers that follow it.
void RollerOrbit::Search::move_ring() {
  const double det = stiffness[0] * stiffness[2] - stiffness[1] * stiffness[1];
  du[0] = (stiffness[2] * pushed[0] - stiffness[1] * pushed[1]) / det;
  du[1] = (stiffness[0] * pushed[1] - stiffness[1] * pushed[0]) / det;
  moved = std::hypot(du[0], du[1]);
  // Spins follow the ring and change what it bears: where that turns round, half as far.
  if (pushed[0] * last_pushed[0] + pushed[1] * last_pushed[1] < 0)
    for (double& d : du) d /= 2;
  std::copy(pushed, pushed + 2, last_pushed);
  if (moved > kOrbitMove)
    for (double& d : du) d *= kOrbitMove / moved;
  for (std::size_t k = 0; k < packs; ++k) {
    const Pack along = orbit.cosine_[k] * du[0] + orbit.sine_[k] * du[1];
    dr[k] = (now[k].radial + inner[k] * along) / stiff[k];
    store(from_miss.data() + k * kLanes,
          load(miss.data() + k * kLanes) + by_place[k] * dr[k] + by_ring[k] * along);
  }
}

/// Changes of all spins; the largest. Cyclic: what the last angle changes the first one starts from.
double RollerOrbit::Search::turn_spins() {
  double carried = 1, last = 0;
  for (int n = 0; n < kAngles; ++n) {
    const std::size_t i = angle(n);
    carried *= inertia / (inertia + steep[i]);
    last = (from_miss[i] + inertia * last) / (inertia + steep[i]);
  }
  last /= 1 - carried;
  const double turn_most = kLargestTurn * orbit.rolling_;
  double most = 0;
  for (int n = 0; n < kAngles; ++n) {
    const std::size_t i = angle(n);
    last = (from_miss[i] + inertia * last) / (inertia + steep[i]);
    most = std::max(most, std::abs(last));
    change[i] = last = std::clamp(last, -turn_most, turn_most);
  }
  return most;
}

void RollerOrbit::Search::move() {
  for (std::size_t k = 0; k < packs; ++k) {
    const Pack ds = load(change.data() + k * kLanes), along = dr[k] + response[k] * ds;
    orbit.s_[k] = from_s[k] + ds;
    orbit.r_[k] = from_r[k] + min(max(along, splat(-kOrbitMove)), splat(kOrbitMove));
    orbit.x_[k] = from_x[k];
  }
}

bool RollerOrbit::solve(double w) {
  speed_ = w;
  Search search(*this);
  double before = kNone;  // sum of misses before the last move
  int tries = 0;
  for (int iteration = 0; iteration < kOrbitIterations; ++iteration, ++iterations_) {
    const double misses = search.miss_now();
    if (!std::isfinite(misses)) return false;
    if (iteration > 0) search.steepen();
    if (misses > kGrowth * before && tries < kMostTries) {
      ++tries;
      search.turn_spins();
      search.move();
      continue;
    }
    tries = 0;
    const bool better = misses < kProgress * before;
    before = std::max(misses, kMissWithin);
    search.keep();
    search.linearise(better);
    search.move_ring();
    search.turned = search.turn_spins();
    for (std::size_t k = 0; k < search.packs; ++k)
      search.moved = std::max(
          search.moved, largest(abs(search.dr[k] +
                                    search.response[k] * load(search.change.data() + k * kLanes))));
    if (!std::isfinite(search.turned) || !std::isfinite(search.moved)) return false;
    if (search.turned < kSpinWithin * rolling_ && search.moved < kPlaceWithin) {
      finish();
      return true;
    }
    for (int d = 0; d < 2; ++d) ring_[d] += search.du[d];
    search.move();
  }
  finish();
  return search.turned < 10 * kSpinWithin * rolling_ && search.moved < 10 * kPlaceWithin;
}

void RollerOrbit::finish() {
  const std::size_t packs = r_.size();
  double on_cage[3] = {0, 0, 0};
  turn_.radius.resize(kAngles);
  turn_.spin.resize(kAngles);
  turn_.offset.resize(kAngles);
  for (std::size_t k = 0; k < packs; ++k) {
    Pack now = x_[k];
    forces(k, r_[k], s_[k], now);
    collect(k, r_[k], s_[k], now, on_cage);
    store(turn_.radius.data() + k * kLanes, r_[k]);
    store(turn_.spin.data() + k * kLanes, s_[k]);
    store(turn_.offset.data() + k * kLanes, now);
  }
  turn_.cage_speed = speed_;
  turn_.ring_y = ring_[0];
  turn_.ring_z = ring_[1];
  turn_.force_y = on_cage[0];
  turn_.force_z = on_cage[1];
  turn_.torque = on_cage[2];
}

}  // namespace cagetol
