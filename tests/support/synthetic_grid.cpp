#include "tests/support/synthetic_grid.hpp"

#include <gsl/gsl_cdf.h>

#include <cmath>

#include "distributions/basics/random_stream.hpp"
#include "tests/support/not_a_number.hpp"
#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

constexpr std::int64_t kLengths = 5, kRows = 2 * kLengths;
constexpr const char* kLength = "cage.pocket_length_mm";
constexpr const char* kTilt = "bearing.misalignment_z_mrad";

std::string study_json() {
  nlohmann::ordered_json study{{"name", "grid"}, {"scene", {{"cage", {{"model", "rigid"}}}}}};
  study["inputs"] = {{{"key", kTilt},
                      {"unit", "mrad"},
                      {"nominal", 0.0},
                      {"lot", {{"law", "uniform"}, {"lower", 0.0}, {"upper", 2.0}}}},
                     {{"key", kLength},
                      {"unit", "mm"},
                      {"nominal", 9.4},
                      {"lot", {{"law", "uniform"}, {"lower", -0.25}, {"upper", 0.25}}}}};
  return study.dump();
}

double normal(std::int64_t id, std::uint32_t stream) {
  return gsl_cdf_ugaussian_Pinv(
      uniform(3, Purpose::noise, static_cast<std::uint64_t>(id), stream, 0));
}

}  // namespace

StudyData make_synthetic_grid(std::int64_t replicates) {
  StudyData study = plain_study(kRows * replicates, "grid");
  study.provenance.schema_version = 1;
  study.plan = read_study_plan(study_json(), "synthetic");
  study.design.rows_planned = kRows;
  study.design.columns =
      study.design.groups = {std::string(kTilt) + ":lot", std::string(kLength) + ":lot"};
  study.quantities = {{"slip", "-", "", {}}, {"orbit", "um", "", {}}, {"stress", "MPa", "", {}}};
  InputColumns tilt{kTilt, "mrad", {0}, {}, {}, {}, {}, false};
  InputColumns length{kLength, "mm", {9.4}, {}, {}, {}, {}, true};
  for (std::int64_t id = 0; id < kRows * replicates; ++id) {
    const auto i = static_cast<std::size_t>(id);
    const std::int64_t row = id % kRows, replicate = id / kRows;
    study.row[i] = study.lot[i] = row;
    study.replicate[i] = replicate;
    const bool misaligned = row >= kLengths;
    const double u = double(row % kLengths) / (kLengths - 1), deviation = -0.25 + 0.5 * u;
    study.design.point.insert(study.design.point.end(), {misaligned ? 1.0 : 0.0, u});
    tilt.lot.push_back(misaligned ? 2 : 0);
    tilt.value.push_back(tilt.lot.back());
    length.lot.push_back(deviation);
    length.value.insert(length.value.end(), study.pockets, 9.4 + deviation);
    const bool failed = misaligned && row == kRows - 1 && replicate == 1;
    if (failed) study.status[i] = RunStatus::failed;
    const double slip =
        misaligned ? 2 - 4 * deviation + 0.1 * normal(id, 1) : 2 + normal(replicate, 2);
    study.quantities[0].values.push_back(failed ? kNan : slip);
    study.quantities[1].values.push_back(failed ? kNan : 5 + normal(id, 3));
    study.quantities[2].values.push_back(kNan);
  }
  study.inputs = {tilt, length};
  return study;
}

}  // namespace cagetol
