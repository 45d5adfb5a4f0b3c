#include "src/integration/rosenbrock.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "src/integration/step_control.hpp"

namespace cagetol {

const RosenbrockTable kRodas3 = {
    .stages = 4,
    .gamma = 0.5,
    .error_order = 3,
    .a = {{}, {0}, {2, 0}, {2, 0, 1}},
    .c = {{}, {4}, {1, -1}, {1, -1, -8.0 / 3}},
    .alpha = {0, 0, 1, 1},
    .gamma_sum = {0.5, 1.5, 0, 0},
    .m = {2, 0, 1, 1},
    .new_rates = {false, false, true, true},
};

const RosenbrockTable kRodasP = {
    .stages = 6,
    .gamma = 0.25,
    .error_order = 4,
    .a = {{},
          {3},
          {1.831036793486759, 0.4955183967433795},
          {2.304376582692669, -0.05249275245743001, -1.176798761832782},
          {-7.170454962423024, -4.741636671481785, -16.31002631330971, -1.062004044111401},
          {-7.170454962423024, -4.741636671481785, -16.31002631330971, -1.062004044111401, 1}},
    .c = {{},
          {-12},
          {-8.791795173947035, -2.207865586973518},
          {10.81793056857153, 6.780270611428266, 19.53485944642410},
          {34.19095006749676, 15.49671153725963, 54.74760875964130, 14.16005392148534},
          {34.62605830930532, 15.30084976114473, 56.99955578662667, 18.40807009793095,
           -5.714285714285717}},
    .alpha = {0, 0.75, 0.21, 0.63, 1, 1},
    .gamma_sum = {0.25, -0.5, -0.023504, -0.0362, 0, 0},
    .m = {-7.170454962423024, -4.741636671481785, -16.31002631330971, -1.062004044111401, 1, 1},
    .new_rates = {false, true, true, true, true, true},
};

namespace {

/// to = from + sum of weights times terms, in one pass over n numbers in whole packs.
template <int terms>
void add_up(const double* from, const double* const* term, const double* weight, double* to,
            int n) {
  for (int i = 0; i < n; i += kLanes) {
    Pack sum = load(from + i);
    for (int k = 0; k < terms; ++k) sum += weight[k] * load(term[k] + i);
    store(to + i, sum);
  }
}

}  // namespace

Rosenbrock::Rosenbrock(const RosenbrockTable& table, const Integration& keys, const System& system)
    : table_(table),
      keys_(keys),
      newton_(system.model),
      next_step_(kStepControl.first_step),
      stage_(static_cast<std::size_t>(table.stages),
             PackVector(static_cast<std::size_t>(system.size))),
      rates_(static_cast<std::size_t>(system.size)),
      argument_(static_cast<std::size_t>(system.size)),
      time_rates_(static_cast<std::size_t>(system.size)) {}

void Rosenbrock::combine(const double* from, const double* weights, double factor, int stages,
                         double* to) const {
  const double* term[RosenbrockTable::kMaxStages];
  double weight[RosenbrockTable::kMaxStages];
  int terms = 0;
  for (int j = 0; j < stages; ++j) {
    if (weights[j] == 0) continue;
    term[terms] = stage_[static_cast<std::size_t>(j)].data();
    weight[terms++] = factor * weights[j];
  }
  using AddUp = void (*)(const double*, const double* const*, const double*, double*, int);
  static constexpr AddUp kOf[] = {add_up<0>, add_up<1>, add_up<2>, add_up<3>,
                                  add_up<4>, add_up<5>, add_up<6>};
  static_assert(std::size(kOf) == RosenbrockTable::kMaxStages + 1);
  kOf[terms](from, term, weight, to, static_cast<int>(rates_.size()));
}

void Rosenbrock::advance(const double* y, const double* weights, int stages, double* to) {
  const int last = stages - 1;
  const bool goes_on =
      last > 0 && table_.new_rates[last] && std::equal(weights, weights + last, table_.a[last]);
  if (!goes_on) return combine(y, weights, 1, stages, to);
  double added[RosenbrockTable::kMaxStages] = {};
  added[last] = weights[last];
  combine(argument_.data(), added, 1, stages, to);
}

StepStatus Rosenbrock::step(System& system, double& t, double* y, double t_end) {
  const int n = system.size;
  double h = std::min(next_step_, keys_.max_step);
  const bool driven = system.driven_by_time(t);
  if (driven) system.rates_by_time(t, y, time_rates_.data());
  bool rejected = false;
  for (;;) {
    if (system.counts.steps + system.counts.rejected >= system.step_budget)
      return StepStatus::out_of_budget;
    const bool last = t + h >= t_end;
    if (last) h = t_end - t;
    ++system.counts.factorisations;
    bool sound = newton_.factor(system.linear, table_.gamma * h);
    const double* rates = system.rate.data();
    for (int s = 0; s < table_.stages && sound; ++s) {
      const auto& a = table_.a[s];
      const auto& c = table_.c[s];
      if (table_.new_rates[s]) {
        advance(y, a, s, argument_.data());
        sound = system.rates(t + table_.alpha[s] * h, argument_.data(), rates_.data());
        rates = rates_.data();
      }
      double* u = stage_[static_cast<std::size_t>(s)].data();
      combine(rates, c, 1 / h, s, u);
      if (driven && table_.gamma_sum[s] != 0)
        for (int i = 0; i < n; ++i)
          u[i] += table_.gamma_sum[s] * h * time_rates_[static_cast<std::size_t>(i)];
      newton_.solve(u, u);
    }
    double error = 1e6;
    if (sound) {
      error = error_norm(system, stage_.back().data()) / keys_.tolerance;
      if (!std::isfinite(error)) error = 1e6;
    }
    const double log_error = std::log(std::clamp(error, 1e-6, 1e6));
    const double log_factor = std::log(kStepControl.safety) - log_error / table_.error_order;
    if (error <= 1) {
      // No growth right after a rejection.
      const double predicted =
          log_factor + std::min(0.0, kStepControl.memory * (last_log_error_ - log_error));
      const double factor = std::clamp(std::exp(predicted), kStepControl.shortest,
                                       rejected ? 1.0 : kStepControl.longest);
      advance(y, table_.m, table_.stages, y);
      t = last ? t_end : t + h;
      ++system.counts.steps;
      if (!last) system.counts.smallest_step = std::min(system.counts.smallest_step, h);
      last_log_error_ = std::max(log_error, std::log(kStepControl.minimum_error));
      next_step_ = last ? std::max(next_step_, h * factor) : h * factor;
      stalled_ = h < kStepControl.stalled ? stalled_ + 1 : 0;
      if (stalled_ == kStepControl.stalled_steps) {
        stalled_ = 0;
        next_step_ = std::max(kStepControl.dive * h, 2 * kStepControl.smallest_step);
      }
      return StepStatus::accepted;
    }
    ++system.counts.rejected;
    rejected = true;
    h *= std::clamp(std::exp(log_factor), kStepControl.shortest_again, kStepControl.longest_again);
    if (h < kStepControl.smallest_step) {
      failure_ = "the step fell below 1e-12 s at t = " + std::to_string(t) + " s";
      return StepStatus::failed;
    }
  }
}

}  // namespace cagetol
