// Time histories of one run as an HDF5 file: motions, speeds and forces at accepted steps, at most
// one state per window.history_interval_us. mc/RUN_FORMAT.md lists the datasets.
#pragma once

#include <string>
#include <vector>

#include "src/integration/system.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

class RunHistory {
 public:
  explicit RunHistory(const Scene& scene);

  /// Keeps the state if the interval has passed. To be called at every accepted state.
  void record(double t, const double* y, const System& system);

  /// Throws WriteError.
  void write(const std::string& path) const;

 private:
  struct Series {
    std::string name, unit, description;
    bool per_roller;
    std::vector<double> values;
  };
  void add(std::size_t series, double value) { series_[series].values.push_back(value); }

  std::string scene_name_;
  double interval_, next_time_ = 0;
  std::size_t rollers_;
  std::vector<double> time_;
  std::vector<Series> series_;
};

}  // namespace cagetol
