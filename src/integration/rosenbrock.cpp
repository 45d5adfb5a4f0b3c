#include "src/integration/rosenbrock.hpp"

#include <algorithm>
#include <cmath>

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
    .e = {0, 0, 0, 1},
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
    .e = {0, 0, 0, 0, 0, 1},
    .new_rates = {false, true, true, true, true, true},
};

namespace {

constexpr double kFirstStep = 1e-7, kSmallestStep = 1e-12;
constexpr double kTouchMargin =
    0.5e-6;  ///< steps end this long after a predicted touch, inside the contact [s]

}  // namespace

Rosenbrock::Rosenbrock(const RosenbrockTable& table, const Integration& keys, const System& system)
    : table_(table),
      keys_(keys),
      newton_(system.model),
      next_step_(kFirstStep),
      stage_(static_cast<std::size_t>(table.stages),
             std::vector<double>(static_cast<std::size_t>(system.size))),
      rates_(static_cast<std::size_t>(system.size)),
      argument_(static_cast<std::size_t>(system.size)),
      time_rates_(static_cast<std::size_t>(system.size)),
      error_(static_cast<std::size_t>(system.size)) {}

StepStatus Rosenbrock::step(System& system, double& t, double* y, double t_end) {
  const int n = system.size;
  double h = std::min(next_step_, keys_.max_step);
  if (keys_.touch_aware) h = std::min(h, system.seen.time_to_touch + kTouchMargin);
  const bool driven = system.driven_by_time(t);
  if (driven) {
    const double dt = 1e-7;
    system.rates(t + dt, y, time_rates_.data());
    for (int i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      time_rates_[k] = (time_rates_[k] - system.rate[k]) / dt;
    }
  }
  bool rejected = false;
  for (;;) {
    if (system.counts.steps + system.counts.rejected >= keys_.step_budget)
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
        std::copy(y, y + n, argument_.begin());
        for (int j = 0; j < s; ++j)
          if (a[j] != 0)
            for (int i = 0; i < n; ++i)
              argument_[static_cast<std::size_t>(i)] +=
                  a[j] * stage_[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)];
        sound = system.rates(t + table_.alpha[s] * h, argument_.data(), rates_.data());
        rates = rates_.data();
      }
      double* u = stage_[static_cast<std::size_t>(s)].data();
      std::copy(rates, rates + n, u);
      for (int j = 0; j < s; ++j)
        if (c[j] != 0) {
          const double* from = stage_[static_cast<std::size_t>(j)].data();
          for (int i = 0; i < n; ++i) u[i] += c[j] / h * from[i];
        }
      if (driven && table_.gamma_sum[s] != 0)
        for (int i = 0; i < n; ++i)
          u[i] += table_.gamma_sum[s] * h * time_rates_[static_cast<std::size_t>(i)];
      newton_.solve(u, u);
    }
    double error = 1e6;
    if (sound) {
      std::fill(error_.begin(), error_.end(), 0.0);
      for (int s = 0; s < table_.stages; ++s)
        if (table_.e[s] != 0)
          for (int i = 0; i < n; ++i)
            error_[static_cast<std::size_t>(i)] +=
                table_.e[s] * stage_[static_cast<std::size_t>(s)][static_cast<std::size_t>(i)];
      error = step_error_(system, y, error_.data(), h, keys_.tolerance);
      if (!std::isfinite(error)) error = 1e6;
    }
    const double bounded = std::clamp(error, 1e-6, 1e6);
    double factor = 0.9 * std::pow(bounded, -1 / table_.error_order);
    if (error <= 1) {
      // Gustafsson's predictive part; no growth right after a rejection.
      factor = std::min(factor, factor * std::pow(last_error_ / bounded, 0.08));
      factor = std::clamp(factor, 0.2, rejected ? 1.0 : 4.0);
      for (int s = 0; s < table_.stages; ++s)
        if (table_.m[s] != 0)
          for (int i = 0; i < n; ++i)
            y[i] += table_.m[s] * stage_[static_cast<std::size_t>(s)][static_cast<std::size_t>(i)];
      t = last ? t_end : t + h;
      step_error_.advance(system, h);
      ++system.counts.steps;
      if (!last) system.counts.smallest_step = std::min(system.counts.smallest_step, h);
      last_error_ = std::max(bounded, 1e-2);
      next_step_ = last ? std::max(next_step_, h * factor) : h * factor;
      return StepStatus::accepted;
    }
    ++system.counts.rejected;
    rejected = true;
    h *= std::clamp(factor, 0.1, 0.7);
    if (h < kSmallestStep) {
      failure_ = "the step fell below 1e-12 s at t = " + std::to_string(t) + " s";
      return StepStatus::failed;
    }
  }
}

}  // namespace cagetol
