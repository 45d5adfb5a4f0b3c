// Whether the means of a window have converged: how far chance lets each of them be off, from its
// means over successive cage revolutions.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace cagetol {

/// What is watched. Rare events (impacts, forces on end walls, skew) are not: a window tells their
/// scatter no better than their mean.
enum WatchedMean : std::size_t {
  kMeanCageSlip,
  kMeanOrbitSlip,
  kMeanRaceSliding,   ///< rms
  kMeanPocketForce,   ///< rms
  kMeanGuideForce,    ///< rms
  kMeanDisplacement,  ///< of the inner ring
  kMeanTorque,
  kMeanStress,  ///< rms, of a flexible cage
  kWatchedMeans
};

/// A watched mean as a row of quantity_table(), whose error is taken relative to its magnitude.
struct WatchedQuantity {
  const char* key;
  bool root;     ///< the quantity is the root of the mean: half its relative error
  double floor;  ///< least magnitude that errors are relative to [unit of the integral]
};
const std::array<WatchedQuantity, kWatchedMeans>& watched_quantities();

/// Of one watched mean since the window's beginning.
struct MeanIntegral {
  double value = 0;   ///< integral over `weight`; of squares where the quantity is a root
  double weight = 0;  ///< 0: the run does not define the quantity
};

/// Half the width of the 95 % interval of a mean over the magnitude of that mean.
struct MeanShare {
  double share = std::numeric_limits<double>::quiet_NaN();  ///< none of less than two revolutions
  const char* key = "";  ///< of the watched quantity with the largest share
};

/// Batch means. Whole revolutions are independent of each other (correlation of neighbours 0.03 in
/// the lubricated NU 205); parts of one are not, because each pocket passes the load once in it.
class Convergence {
 public:
  using Integrals = std::array<MeanIntegral, kWatchedMeans>;
  /// At the end of a cage revolution.
  void add(const Integrals& since_begin);
  std::size_t revolutions() const { return ends_.size(); }
  /// Of the watched quantity that is known least.
  MeanShare worst() const;

 private:
  double share(std::size_t of) const;
  std::vector<Integrals> ends_;
};

}  // namespace cagetol
