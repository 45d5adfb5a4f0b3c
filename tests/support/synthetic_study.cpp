#include "tests/support/synthetic_study.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "distributions/basics/random_stream.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kPockets = 13;

nlohmann::ordered_json normal_law(double sigma) {
  return {{"law", "normal"}, {"mean", 0.0}, {"sigma", sigma}};
}

nlohmann::ordered_json study_json(const SyntheticOptions& options) {
  using Json = nlohmann::ordered_json;
  Json study{{"name", "synthetic"},
             {"seed", options.seed},
             {"samples", options.rows},
             {"cages_per_lot", options.cages_per_lot},
             {"allowed_failure_share", 0.02}};
  study["scene"] = {
      {"bearing", {{"roller_count", 13}, {"internal_clearance_um", 30.0}}},
      {"cage", {{"model", "rigid"}, {"pocket_width_mm", 7.65}, {"pocket_length_mm", 9.25}}},
      {"contact",
       {{"friction_static", 0.07},
        {"friction_dynamic", 0.06},
        {"static_speed_m_s", 0.1},
        {"dynamic_speed_m_s", 1.0}}},
      {"load", {{"radial_N", 1000.0}}},
      {"speed", {{"inner_rpm", 6000.0}}}};
  study["inputs"] = Json::array();
  for (const char* key : {"cage.pocket_width_mm", "cage.pocket_length_mm"})
    study["inputs"].push_back(
        {{"key", key},
         {"unit", "mm"},
         {"nominal", std::string(key).find("width") != std::string::npos ? 7.65 : 9.25},
         {"lot", normal_law(0.009)},
         {"pocket", normal_law(0.009)}});
  study["inputs"].push_back({{"key", "cage.pocket_squareness_mrad"},
                             {"unit", "mrad"},
                             {"nominal", 0.0},
                             {"pocket", normal_law(1.0)}});
  study["inputs"].push_back({{"key", "start.cage_phase_deg"},
                             {"unit", "deg"},
                             {"nominal", 0.0},
                             {"noise", {{"law", "uniform"}, {"lower", 0.0}, {"upper", 360.0}}}});
  study["limit"] = {{{"quantity", "cage_stress_peak_MPa"},
                     {"min", 20.0},
                     {"max", options.stress_limit},
                     {"source", "fatigue limit of the cage steel with a safety factor of 2"},
                     {"cage_revolutions", 6}},
                    {{"quantity", "whirl_radius_ratio_p95"},
                     {"max", options.whirl_limit},
                     {"source", "quiet running, test rig experience"},
                     {"cage_revolutions", 6}}};
  if (!options.candidates) return study;
  study["tolerance"] = {{"target_yield", 0.95},
                        {"confidence", 0.95},
                        {"dimension",
                         {{{"key", "cage.pocket_width_mm"}, {"tolerance_width_mm", 0.1}},
                          {{"key", "cage.pocket_length_mm"}, {"tolerance_width_mm", 0.1}}}}};
  const std::vector<std::pair<const char*, double>> widths = {
      {"IT9", 0.036}, {"IT10", 0.058}, {"IT11", 0.09}, {"IT12", 0.15}};
  const std::vector<std::pair<const char*, double>> lengths = {{"IT9", 0.036}, {"IT11", 0.09}};
  study["candidates"] = Json::array();
  for (const auto& [width_grade, width] : widths)
    for (const auto& [length_grade, length] : lengths)
      study["candidates"].push_back({{"tolerance_widths_mm", {width, length}},
                                     {"grades", {width_grade, length_grade}},
                                     {"scales", {width / 0.1, length / 0.1}}});
  return study;
}

double normal(RandomStream& stream) {
  return gsl_cdf_ugaussian_Pinv(stream.next());
}

/// Draws the columns of one input for one sample. Lot draws belong to the lot, pocket draws to the
/// row, noise to the sample.
void draw_input(StudyData& study, InputColumns& input, const InputPlan& plan, std::uint32_t stream,
                std::size_t sample) {
  const auto seed = static_cast<std::uint64_t>(study.provenance.seed);
  double scale = 1;
  for (std::size_t d = 0; d < study.plan.dimensions.size(); ++d)
    if (study.plan.dimensions[d].key == plan.key)
      scale = study.plan.candidates[static_cast<std::size_t>(study.candidate[sample])].scales[d];
  double lot = 0;
  if (!plan.lot.is_null()) {
    RandomStream draws(seed, Purpose::lot, static_cast<std::uint64_t>(study.lot[sample]), stream);
    lot = scale * plan.lot.at("sigma").get<double>() * normal(draws);
    input.lot.push_back(lot);
  }
  if (!plan.noise.is_null()) {
    RandomStream draws(seed, Purpose::noise, static_cast<std::uint64_t>(study.id[sample]), stream);
    input.noise.push_back(360 * draws.next());
    input.value.push_back(input.noise.back());
    return;
  }
  input.per_pocket = true;
  RandomStream draws(seed, Purpose::pocket, static_cast<std::uint64_t>(study.row[sample]), stream);
  for (std::size_t j = 0; j < kPockets; ++j) {
    input.pocket.push_back(scale * plan.pocket.at("sigma").get<double>() * normal(draws));
    input.value.push_back(plan.nominal[0] + lot + input.pocket.back());
  }
}

void add_samples(StudyData& study, const SyntheticOptions& options) {
  const auto extra = static_cast<std::int64_t>(
      std::lround(options.replicate_share * static_cast<double>(options.rows)));
  study.design.rows_planned = options.rows;
  study.design.samples_planned = options.rows + extra;
  for (std::int64_t id = 0; id < options.rows + extra; ++id) {
    study.id.push_back(id);
    study.row.push_back(id % options.rows);
    study.replicate.push_back(id / options.rows);
    study.lot.push_back(study.row.back() / options.cages_per_lot);
    const auto candidates = static_cast<std::int64_t>(study.plan.candidates.size());
    study.candidate.push_back(candidates > 0 ? study.row.back() % candidates : -1);
  }
}

double scatter_of(const double* first) {
  double square = 0;
  for (std::size_t j = 0; j < kPockets; ++j) square += first[j] * first[j];
  return std::sqrt(square / kPockets);
}

void add_outcome(StudyData& study, std::size_t i, double failed_share) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const InputColumns& width = study.inputs[0];
  const InputColumns& square = study.inputs[2];
  const auto first = width.value.begin() + static_cast<std::ptrdiff_t>(i * kPockets);
  const auto narrowest = std::min_element(first, first + kPockets);
  RandomStream noise(static_cast<std::uint64_t>(study.provenance.seed), Purpose::noise,
                     static_cast<std::uint64_t>(study.id[i]), 99);
  const double chance = noise.next();
  study.status.push_back(*narrowest < 7.60             ? RunStatus::jammed
                         : chance < failed_share       ? RunStatus::failed
                         : chance < 1.5 * failed_share ? RunStatus::censored
                                                       : RunStatus::ok);
  const bool ok = study.status.back() == RunStatus::ok,
             jammed = study.status.back() == RunStatus::jammed;
  study.pocket.push_back(jammed ? narrowest - first : -1);
  study.interference_um.push_back(jammed ? 1e3 * (7.60 - *narrowest) : 0);
  study.reason.push_back(ok       ? ""
                         : jammed ? "roller too large for its pocket"
                                  : "static consistency error 3.1 % above its bound of 2 %");
  const double widest_um = 1e3 * (*std::max_element(first, first + kPockets) - 7.65);
  const double values[] = {
      60 + 1.2 * widest_um + 2 * normal(noise), 0.9 + 6.0 * width.lot[i] + 0.02 * normal(noise),
      0.01 + 0.004 * scatter_of(&square.pocket[i * kPockets]) + 0.0005 * normal(noise),
      std::exp(3 + 30 * width.pocket[i * kPockets + 4] + 0.1 * normal(noise)), nan};
  for (std::size_t q = 0; q < study.quantities.size(); ++q)
    study.quantities[q].values.push_back(ok ? values[q] : nan);
  const double run[] = {std::floor(48000 + 3000 * normal(noise)),
                        std::exp(-8.5 + 0.3 * normal(noise)), std::exp(-6 + 0.5 * normal(noise))};
  for (std::size_t q = 0; q < study.run.size(); ++q)
    study.run[q].values.push_back(jammed ? nan : run[q]);
  study.timing[0].values.push_back(1.4 + 0.1 * normal(noise));
}

}  // namespace

StudyData make_synthetic_study(const SyntheticOptions& options) {
  StudyData study;
  study.provenance = {"0.1.0",
                      "0123456789ab",
                      "GCC 12.2, -O3",
                      R"({"HDF5":"1.10.8","SUNDIALS":"6.4.1"})",
                      "synthetic",
                      "00c0ffee00c0ffee",
                      2,
                      options.seed,
                      {}};
  study.design.kind = options.design;
  study.plan = read_study_plan(study_json(options).dump(), "synthetic");
  study.pockets = kPockets;
  add_samples(study, options);
  study.quantities = {
      {"cage_stress_peak_MPa",
       "MPa",
       "largest von Mises stress in the cage over the measuring window",
       {}},
      {"whirl_radius_ratio_p95",
       "-",
       "95 % quantile over time of the cage centre's radius, divided by the guide clearance",
       {}},
      {"cage_slip_ratio", "-", "1 - cage speed / kinematic cage speed", {}},
      {"pocket_force_peak_N", "N", "largest force between a roller and a pocket bar", {}},
      {"lambda_min", "-", "smallest film thickness divided by the roughness", {}}};
  study.run = {{"steps", "-", "accepted steps", {}},
               {"energy_residual",
                "-",
                "|work in - dissipation - change of stored energy| / dissipation",
                {}},
               {"static_consistency_error",
                "-",
                "mean elastic force on the ring against the applied load",
                {}}};
  study.timing = {{"wall_s", "s", "wall-clock seconds of the run", {}}};
  for (const InputPlan& plan : study.plan.inputs) {
    InputColumns input{plan.key, plan.unit, plan.nominal, {}, {}, {}, {}, false};
    for (std::size_t i = 0; i < study.size(); ++i)
      draw_input(study, input, plan, stream_address(plan.key), i);
    study.inputs.push_back(std::move(input));
  }
  for (std::size_t i = 0; i < study.size(); ++i) add_outcome(study, i, options.failed_share);
  return study;
}

StudyData plain_study(std::int64_t rows, const std::string& design, std::int64_t cages_per_lot,
                      std::int64_t seed) {
  StudyData study;
  study.provenance.seed = seed;
  study.design.kind = design;
  study.design.rows_planned = study.design.samples_planned = rows;
  study.pockets = kPockets;
  for (std::int64_t row = 0; row < rows; ++row) {
    study.id.push_back(row);
    study.row.push_back(row);
    study.lot.push_back(row / cages_per_lot);
  }
  study.replicate.assign(study.size(), 0);
  study.candidate.assign(study.size(), -1);
  study.pocket.assign(study.size(), -1);
  study.status.assign(study.size(), RunStatus::ok);
  study.reason.resize(study.size());
  study.interference_um.assign(study.size(), 0);
  return study;
}

}  // namespace cagetol
