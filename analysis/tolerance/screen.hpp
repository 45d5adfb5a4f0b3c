// How far each tolerance moves each limited quantity, from a few dozen runs of a factorial design.
//
// Runs (mc/commands/screen_stages.hpp): lots of each dimension as at the screened width, scatter
// among the pockets of a cage absent or as at the screened width, all dimensions independent. Least
// squares,
//
//   y = c + sum_d (b_d u_d + q_d u_d^2 + p_d s_d) + sum_k a_k x_k + e
//
// u_d mean deviation of the cage's pockets, s_d their standard deviation, x_k the lots of all other
// inputs less their means. Rows run twice count as 2 / (1 + r) rows, r the share of e that repeats.
// Terms are left out from the last one on where rows are fewer than twice as many. Standard errors
// are the larger of the usual ones and HC3, which allows for an e that grows with the deviations
// (MacKinnon & White 1985, doi:10.1016/0304-4076(85)90158-7).
//
// At the widths w_d, as shares of those screened, the quantity has among cages
//
//   mean      c + sum_d (b_d m_d + q_d (v_d + m_d^2) + p_d w_d pocket_sigma_d)
//   variance  sum_d ((b_d + 2 q_d m_d)^2 v_d + 2 q_d^2 v_d^2) + sum_k a_k^2 var(x_k) + var(e)
//   v_d = w_d^2 (lot_sigma_d^2 + pocket_sigma_d^2 / pockets)
//   m_d = (w_d - 1) middle_d, as the zone of a tolerance keeps its form; u_d is about middle_d
//
// and is taken for normal. It reaches its limit where as many cages miss it as the target allows.
// Errors of mean and deviation follow from those of all coefficients and of var(e) to first order.
// The margin z, (bound - mean)/deviation, ends where mean + z deviation meets the bound with an
// error of that sum (Fieller): a limit far away stays far however little is known of the deviation.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/study/study_data.hpp"

namespace cagetol {

struct ScreenDimension {
  std::string key;
  double hundredth = 0.01;                ///< 0.01 mm in the key's unit
  double width_mm = 0, narrowest_mm = 0;  ///< screened, and the narrowest candidate
  /// Standard deviations at width_mm, in the key's unit; 0: no such part.
  double lot_sigma = 0, pocket_sigma = 0;
  double middle = 0;  ///< of the zone screened less the nominal value, in the key's unit
  JamCurve jams = {};
};

/// Shift of the quantity by 0.01 mm, with its standard error.
struct PartShift {
  std::string key, part;  ///< "lot": all pockets of a cage; "pocket": their standard deviation
  double shift = 0, error = 0;
  bool bent = false;      ///< of a lot: its square moves the quantity as much, one lot sigma away
  bool resolved = false;  ///< error within 30 % of the shift, or 5 % of the distance to the limit
};

/// Tolerance width at which the limit is reached, all other dimensions at their narrowest; nothing
/// within the curve of jams.
struct LimitReach {
  std::string key;
  std::optional<double> width_mm = {}, lower_mm = {}, upper_mm = {};  ///< with its interval
  std::optional<double> jam_mm = {};  ///< where jams alone miss the target
  double searched_mm = 0;
};

struct ScreenedLimit {
  std::string quantity, unit;
  double bound = 0;
  bool is_maximum = true;
  double level = 0, level_error = 0;  ///< c: of a cage without deviations
  double start_noise = 0;             ///< standard deviation over starts of a cage
  double scatter = 0;                 ///< of all that is no tolerance in question
  std::vector<PartShift> parts = {};
  std::vector<LimitReach> reach = {};
  /// At the widths screened: standard deviations from mean to bound, and share of cages beyond it.
  double margin = 0, missed = 0, missed_upper = 0;
};

struct Screen {
  std::size_t runs = 0, lost = 0;
  double target_yield = 0, jams = 0;  ///< share of cages that jam at the widths screened
  std::vector<ScreenedLimit> limits = {};
  /// Of each dimension: where jams and all limits together miss the target. At the ends of its
  /// interval all limits are at the ends of theirs.
  std::vector<LimitReach> together = {};
  /// No limit takes, at the widths screened, what jams leave of the target: geometry decides.
  bool jams_alone = false;
  std::size_t nearest = 0;  ///< limit with the least margin there
};

/// To the runs of a screen those of another one of the same study, in rows of their own: what
/// screen_limits reads of them. `runs` may be empty.
void add_runs(StudyData& runs, const StudyData& more);

/// Throws Refused where too few runs gave a result.
Screen screen_limits(const StudyData& runs, const std::vector<ScreenDimension>& dimensions,
                     double jams);

}  // namespace cagetol
