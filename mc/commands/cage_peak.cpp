#include "mc/commands/cage_peak.hpp"

#include <spdlog/spdlog.h>

#include <cmath>
#include <numbers>

#include "analysis/report/cage_peak.hpp"
#include "mc/host/file_write.hpp"
#include "mc/ranks/signals.hpp"
#include "mc/run/cage_cache.hpp"
#include "mc/run/sample_run.hpp"
#include "mc/study_file/study_file_error.hpp"
#include "mc/sweep/replay.hpp"
#include "src/cage/mesh/cage_surface.hpp"
#include "src/cage/stress/field_recovery.hpp"
#include "src/cage/table/cage_recovery.hpp"
#include "src/operation/operating_scene.hpp"
#include "src/quantities/quantity_table.hpp"

namespace cagetol {
namespace {

constexpr double kDegree = std::numbers::pi / 180, kMillimetre = 1e-3, kMPa = 1e6;

/// The one state of a run's peak.
CageStates state_of(const CagePeak& peak, const CageGeometry& cage) {
  const auto column = [](const std::vector<double>& values) {
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<long>(values.size()));
  };
  return {column(peak.modes), column(peak.bar_force), Eigen::VectorXd::Constant(1, peak.spin),
          cage.bar_modes};
}

/// A number in its unit with four digits: enough to draw.
double drawn(double value, double unit) {
  return std::strtod(fmt::format("{:.4g}", value / unit).c_str(), nullptr);
}

Json surface_json(const std::string& name, const CageSurface& surface, double across_unit,
                  const Eigen::VectorXd& stress) {
  Json json{{"name", name}};
  for (std::size_t i = 0; i < surface.node.size(); ++i) {
    json["across"].push_back(drawn(surface.across[i], across_unit));
    json["up_mm"].push_back(drawn(surface.up[i], kMillimetre));
    json["stress_MPa"].push_back(drawn(stress[surface.node[i]], kMPa));
  }
  json["cells"] = surface.cells;
  return json;
}

Json field_json(const CageTable& table, const OperatingScene& scene, const CagePeak& peak) {
  const auto deviations = pocket_deviations(scene, table.cage);
  const auto recovered = recover_cage(table, deviations, state_of(peak, scene.cage));
  if (const auto* fault = std::get_if<CageFault>(&recovered))
    throw std::runtime_error(fault->reason);
  const auto& [cage, displacement] = std::get<CageRecovery>(recovered);
  const auto components = stress_everywhere(cage.mesh, table.material, displacement.col(0));
  Eigen::VectorXd stress(components.cols());
  for (Eigen::Index n = 0; n < stress.size(); ++n) stress[n] = von_mises(components.col(n));
  Eigen::Index node = 0;
  const double largest = stress.maxCoeff(&node);
  const Eigen::Vector3d at = cage.mesh.nodes.col(node);
  const auto pocket = static_cast<std::size_t>(peak.pocket);
  double angle = std::atan2(at[2], at[1]) / kDegree;
  const double first = -180.0 / static_cast<double>(table.cage.pocket_count);
  if (angle < first) angle += 360;
  const PocketDeviation& own = deviations.at(pocket);
  const double length = (table.cage.pocket_length + own.length) / kMillimetre;
  const double width = (table.cage.pocket_width + own.width) / kMillimetre;
  Json walls =
      surface_json("pocket walls", pocket_walls(cage, own, peak.pocket), kMillimetre, stress);
  walls["corners_mm"] = {length, length + width, 2 * length + width};
  return {{"station", station_name(table.stress_points.at(static_cast<std::size_t>(peak.station)))},
          {"full",
           {{"stress_MPa", largest / kMPa},
            {"angle_deg", angle},
            {"axial_mm", at[0] / kMillimetre},
            {"radius_mm", at.tail<2>().norm() / kMillimetre}}},
          {"pockets", table.cage.pocket_count},
          {"surfaces",
           {surface_json("outer surface", cylinder_surface(cage, true), kDegree, stress),
            surface_json("inner surface", cylinder_surface(cage, false), kDegree, stress), walls}}};
}

Json peak_json(const std::filesystem::path& sweep_directory, const StudyData& study,
               std::int64_t sample) {
  const StoredSample stored =
      read_stored_sample(sweep_directory.string(), static_cast<std::uint64_t>(sample));
  SimulateOptions options;
  options.cage_table = CageTables(stored.study.scene).of(stored.sample.scene);
  options.stop_requested = SignalWatch::stopping;
  const Outcome again = run_sample(stored.study, stored.sample, options);
  if (again.status == Status::not_run)
    throw std::runtime_error("interrupted; start the same command again to make it");
  if (!outcome_differences(stored.stored.value(),
                           make_stored_outcome(stored.sample.id, again, 0, 0))
           .empty())
    throw std::runtime_error(fmt::format(
        "this program gives another outcome of sample {} than the one that ran the sweep ({})",
        sample, stored.stored_build));
  const CagePeak& peak = again.cage_peak;
  Json json{
      {"study_hash", study.provenance.study_hash},
      {"build", study.provenance.build},
      {"sample", sample},
      {"time_ms", 1e3 * peak.time},
      {"pocket", peak.pocket},
      {"stations_MPa",
       again.quantities.at(static_cast<std::size_t>(quantity_index("cage_stress_peak_MPa")))}};
  json.update(field_json(*options.cage_table, stored.sample.scene, peak));
  return json;
}

}  // namespace

void update_cage_peak(const std::filesystem::path& sweep_directory) {
  try {
    const StudyData study = read_study_data(sweep_directory / "study.h5");
    const auto sample = most_stressed_sample(study);
    if (!sample || !read_cage_peak(sweep_directory, study).is_null()) return;
    if (SignalWatch::draining()) return;  // the same command makes it when it goes on
    replace_file(cage_peak_file(sweep_directory).string(),
                 peak_json(sweep_directory, study, *sample).dump() + "\n");
  } catch (const StudyFileError&) {
    // The report itself says what is wrong with the study file.
  } catch (const std::exception& problem) {
    spdlog::warn("no picture of the cage's stress: {}", problem.what());
  }
}

}  // namespace cagetol
