#include "src/newton/linearisation.hpp"

#include "src/model/flexible_cage.hpp"

namespace cagetol {

Linearisation::Linearisation(const StateLayout& layout)
    : groups(static_cast<std::size_t>(layout.groups)),
      tilts(layout.ring_tilt > 0 ? groups.size() : 0),
      border_position(Eigen::MatrixXd::Zero(layout.border(), layout.border())),
      border_velocity(Eigen::MatrixXd::Zero(layout.border(), layout.border())),
      power_position(Eigen::VectorXd::Zero(layout.border())),
      power_velocity(Eigen::VectorXd::Zero(layout.border())),
      couplings(static_cast<std::size_t>(layout.rollers)),
      slot(static_cast<std::size_t>(layout.rollers), -1) {
  for (auto& row : scratch.border)
    row.assign(static_cast<std::size_t>(kCageY + layout.coupled()), 0.0);
  const auto columns = static_cast<std::size_t>(layout.coupled());
  const auto packs = static_cast<std::size_t>(packs_for(layout.coupled()));
  film_position.resize(columns * packs);
  film_velocity.resize(columns * packs);
  for (auto& c : couplings) {
    c.position.resize(columns);
    c.velocity.resize(columns);
    c.to_position.resize(kLocalPositions * packs);
    c.to_velocity.resize(kLocalVelocities * packs);
  }
}

void Linearisation::clear() {
  for (auto& g : groups) g.clear();
  for (auto& t : tilts) t = TiltLinear{};
  if (cage_touched) {
    border_position.setZero();
    border_velocity.setZero();
  } else {
    const int ring[2] = {kRingY, static_cast<int>(border_position.rows()) - 2};
    const int vectors = tilts.empty() ? 1 : 2;
    for (int v = 0; v < vectors; ++v)
      for (int w = 0; w < vectors; ++w) {
        border_position.block<2, 2>(ring[v], ring[w]).setZero();
        border_velocity.block<2, 2>(ring[v], ring[w]).setZero();
      }
  }
  cage_touched = false;
  power_position.setZero();
  power_velocity.setZero();
  for (int i = 0; i < coupled; ++i)
    slot[static_cast<std::size_t>(couplings[static_cast<std::size_t>(i)].roller)] = -1;
  coupled = 0;
}

void Linearisation::add_films() {
  if (!films) return;
  const auto columns = static_cast<int>(couplings.front().position.size());
  const std::size_t packs = film_position.size() / static_cast<std::size_t>(columns);
  const auto add = [&](std::vector<Pack>& from, Eigen::MatrixXd& to) {
    for (int j = 0; j < columns; ++j) {
      const auto* column =
          reinterpret_cast<const double*>(from.data() + static_cast<std::size_t>(j) * packs);
      to.col(kCageY + j).segment(kCageY, columns) +=
          Eigen::Map<const Eigen::VectorXd>(column, columns);
    }
    std::fill(from.begin(), from.end(), Pack{});
  };
  add(film_position, border_position);
  add(film_velocity, border_velocity);
  films = false;
}

CageCoupling& Linearisation::coupling(int roller) {
  int& index = slot[static_cast<std::size_t>(roller)];
  if (index < 0) {
    index = coupled++;
    auto& c = couplings[static_cast<std::size_t>(index)];
    c.roller = roller;
    for (auto* part : {&c.position, &c.velocity}) std::fill(part->begin(), part->end(), Eight{});
    for (auto* part : {&c.to_position, &c.to_velocity})
      std::fill(part->begin(), part->end(), Pack{});
  }
  return couplings[static_cast<std::size_t>(index)];
}

namespace {

/// A contact's channels over some directions: e = g_n - ratio (v1 g_1 + v2 g_2), and what F1 and F2
/// lose to the sliding speeds.
template <class T>
struct Mixed {
  T e, by1, by2;
};

// One function, as the next: its parts are passes over the same mixed channels in registers.
template <int packs>
void add_contact_as(const ContactRows& rows, const ContactSlopes& s, int roller,
                    Linearisation& linear) {
  linear.cage_touched = true;
  // F1 = -ratio Q v1, F2 likewise; dQ = k dp + c dp', dp = -g_n P, dp' = -g_n V.
  const double d11 = s.force * (s.ratio + s.bend * s.v1 * s.v1),
               d12 = s.force * s.bend * s.v1 * s.v2;
  const double d22 = s.force * (s.ratio + s.bend * s.v2 * s.v2);
  const double along1 = s.ratio * s.v1, along2 = s.ratio * s.v2;
  const auto mixed = [&]<class T>(T gn, T g1, T g2) {
    return Mixed<T>{gn - along1 * g1 - along2 * g2, d11 * g1 + d12 * g2, d12 * g1 + d22 * g2};
  };
  const int first = roller < 0 ? 0 : kCageY;  // rollers never couple to the ring through the cage
  const int count = static_cast<int>(rows.border[0].size()) - first;
  const double *bn = rows.border[0].data() + first, *b1 = rows.border[1].data() + first,
               *b2 = rows.border[2].data() + first;
  const auto lost = dissipation_slopes(s.force, s.stiffness, s.damping, s.ratio, s.bend, s.v1, s.v2,
                                       s.elastic, s.elastic_stiffness, s.rate);
  Mixed<Pack> on_border[packs];
  for (int p = 0; p < packs; ++p) {
    const int at = p * kLanes, left = count - at;
    const Pack gn = load_first(bn + at, left), g1 = load_first(b1 + at, left),
               g2 = load_first(b2 + at, left);
    on_border[p] = mixed(gn, g1, g2);
    double *by_velocity = linear.power_velocity.data() + first + at,
           *by_position = linear.power_position.data() + first + at;
    store_first(by_velocity,
                load_first(by_velocity, left) + (lost.rate * gn - lost.v1 * g1 - lost.v2 * g2),
                left);
    store_first(by_position, load_first(by_position, left) + lost.p * gn, left);
  }
  // Column by column, as these matrices lie in memory.
  for (int j = 0; j < count; ++j) {
    double *velocity = &linear.border_velocity(first, first + j),
           *position = &linear.border_position(first, first + j);
    for (int p = 0; p < packs; ++p) {
      const int at = p * kLanes, left = count - at;
      const auto& [e, by1, by2] = on_border[p];
      store_first(
          velocity + at,
          load_first(velocity + at, left) - (e * (s.damping * bn[j]) + by1 * b1[j] + by2 * b2[j]),
          left);
      store_first(position + at, load_first(position + at, left) - e * (s.stiffness * bn[j]), left);
    }
  }
  if (roller < 0) return;
  const int lane = roller % kLanes;
  GroupLinear& group = linear.groups[static_cast<std::size_t>(roller / kLanes)];
  CageCoupling& coupling = linear.coupling(roller);
  const double *rn = rows.roller[0], *r1 = rows.roller[1], *r2 = rows.roller[2];
  const Mixed<Eight> on_roller = mixed(load_eight(rn), load_eight(r1), load_eight(r2));
  for (int i = 0; i < kLocalVelocities; ++i) {
    const double e = on_roller.e[i], w1 = on_roller.by1[i], w2 = on_roller.by2[i];
    for (int j = 0; j < kLocalVelocities; ++j)
      group.velocity[i][j][lane] -= e * s.damping * rn[j] + w1 * r1[j] + w2 * r2[j];
    for (int j = 0; j < kLocalPositions; ++j)
      group.position[i][j][lane] -= e * s.stiffness * rn[j] + w2 * rows.lean[j];
    group.power_velocity[i][lane] += lost.rate * rn[i] - lost.v1 * r1[i] - lost.v2 * r2[i];
    if (i < kLocalPositions)
      group.power_position[i][lane] += lost.p * rn[i] - lost.v2 * rows.lean[i];
  }
  for (int j = 0; j < count; ++j) {
    const auto at = static_cast<std::size_t>(j);
    coupling.velocity[at] -=
        on_roller.e * (s.damping * bn[j]) + on_roller.by1 * b1[j] + on_roller.by2 * b2[j];
    coupling.position[at] -= on_roller.e * (s.stiffness * bn[j]);
  }
  for (int j = 0; j < kLocalVelocities; ++j)
    for (int p = 0; p < packs; ++p) {
      const auto at = static_cast<std::size_t>(j * packs + p);
      const auto& [e, by1, by2] = on_border[p];
      coupling.to_velocity[at] -= e * (s.damping * rn[j]) + by1 * r1[j] + by2 * r2[j];
      if (j < kLocalPositions)
        coupling.to_position[at] -= e * (s.stiffness * rn[j]) + by2 * rows.lean[j];
    }
}

}  // namespace

void add_contact(const ContactRows& rows, const ContactSlopes& slopes, int roller,
                 Linearisation& linear) {
  const int first = roller < 0 ? 0 : kCageY;
  with_packs(packs_for(static_cast<int>(rows.border[0].size()) - first),
             [&]<int packs>() { add_contact_as<packs>(rows, slopes, roller, linear); });
}

namespace {

/// Forces along the channels, projected on some directions: their change with each variable.
template <class T>
struct Projected {
  T by[FilmContactSlopes::kVariables];
};
template <class T>
Projected<T> projected(const FilmContactSlopes& s, const T (&g)[ContactRows::kMostChannels]) {
  Projected<T> on;
  for (int z = 0; z < FilmContactSlopes::kVariables; ++z)
    on.by[z] =
        g[0] * s.force[z][0] + g[1] * s.force[z][1] + g[2] * s.force[z][2] + g[3] * s.force[z][3];
  return on;
}
/// Their change with a direction's velocity, whose entries in the channels are `g`.
template <class T>
T by_velocity(const Projected<T>& on, const double (&g)[ContactRows::kMostChannels]) {
  return on.by[FilmContactSlopes::kV1] * g[1] + on.by[FilmContactSlopes::kV2] * g[2] +
         on.by[FilmContactSlopes::kAxis] * g[3] - on.by[FilmContactSlopes::kRate] * g[0];
}
template <class T>
T power_by_velocity(const FilmContactSlopes& s, const T (&g)[ContactRows::kMostChannels]) {
  return s.power[FilmContactSlopes::kV1] * g[1] + s.power[FilmContactSlopes::kV2] * g[2] +
         s.power[FilmContactSlopes::kAxis] * g[3] - s.power[FilmContactSlopes::kRate] * g[0];
}

template <int packs>
void add_film_contact_as(const ContactRows& rows, const FilmContactSlopes& s, int roller,
                         Linearisation& linear) {
  constexpr int channels = ContactRows::kMostChannels;
  using F = FilmContactSlopes;
  linear.cage_touched = linear.films = true;
  const int first = kCageY, count = static_cast<int>(rows.border[0].size()) - first;
  const auto of_border = [&](int j, double(&g)[channels]) {
    for (int c = 0; c < channels; ++c) g[c] = rows.border[c][static_cast<std::size_t>(first + j)];
  };
  const auto of_roller = [&](int j, double(&g)[channels]) {
    for (int c = 0; c < channels; ++c) g[c] = rows.roller[c][j];
  };
  Projected<Pack> on_border[packs];
  for (int p = 0; p < packs; ++p) {
    const int at = first + p * kLanes, left = count - p * kLanes;
    Pack g[channels];
    for (int c = 0; c < channels; ++c) g[c] = load_first(rows.border[c].data() + at, left);
    on_border[p] = projected(s, g);
    double *by_speed = linear.power_velocity.data() + at,
           *by_place = linear.power_position.data() + at;
    store_first(by_speed, load_first(by_speed, left) + power_by_velocity(s, g), left);
    store_first(by_place, load_first(by_place, left) - s.power[F::kP] * g[0], left);
  }
  for (int j = 0; j < count; ++j) {
    double g[channels];
    of_border(j, g);
    Pack *velocity = linear.film_velocity.data() + j * packs,
         *position = linear.film_position.data() + j * packs;
    for (int p = 0; p < packs; ++p) {
      velocity[p] += by_velocity(on_border[p], g);
      position[p] -= on_border[p].by[F::kP] * g[0];
    }
  }
  const int lane = roller % kLanes;
  GroupLinear& group = linear.groups[static_cast<std::size_t>(roller / kLanes)];
  CageCoupling& coupling = linear.coupling(roller);
  Eight on_channels[channels];
  for (int c = 0; c < channels; ++c) on_channels[c] = load_eight(rows.roller[c]);
  const Projected<Eight> on_roller = projected(s, on_channels);
  for (int j = 0; j < kLocalVelocities; ++j) {
    double g[channels];
    of_roller(j, g);
    const Eight velocity = by_velocity(on_roller, g);
    group.power_velocity[j][lane] += power_by_velocity(s, g);
    for (int i = 0; i < kLocalVelocities; ++i) group.velocity[i][j][lane] += velocity[i];
    for (int p = 0; p < packs; ++p)
      coupling.to_velocity[static_cast<std::size_t>(j * packs + p)] += by_velocity(on_border[p], g);
    if (j >= kLocalPositions) continue;
    const Eight position = on_roller.by[F::kV2] * rows.lean[j] - on_roller.by[F::kP] * g[0];
    for (int i = 0; i < kLocalVelocities; ++i) group.position[i][j][lane] += position[i];
    group.power_position[j][lane] += s.power[F::kV2] * rows.lean[j] - s.power[F::kP] * g[0];
    for (int p = 0; p < packs; ++p)
      coupling.to_position[static_cast<std::size_t>(j * packs + p)] +=
          on_border[p].by[F::kV2] * rows.lean[j] - on_border[p].by[F::kP] * g[0];
  }
  for (int j = 0; j < count; ++j) {
    double g[channels];
    of_border(j, g);
    const auto at = static_cast<std::size_t>(j);
    coupling.velocity[at] += by_velocity(on_roller, g);
    coupling.position[at] -= on_roller.by[F::kP] * g[0];
  }
}

}  // namespace

void add_film_contact(const ContactRows& rows, const FilmContactSlopes& slopes, int roller,
                      Linearisation& linear) {
  with_packs(packs_for(static_cast<int>(rows.border[0].size()) - kCageY),
             [&]<int packs>() { add_film_contact_as<packs>(rows, slopes, roller, linear); });
}

}  // namespace cagetol
