#include "mc/sweep/sweep_plan.hpp"

#include "mc/run/cage_cache.hpp"

namespace cagetol {

SweepPlan make_sweep_plan(const Study& study) {
  SweepPlan plan;
  plan.study = study;
  plan.rows = static_cast<std::uint64_t>(study.samples);
  plan.samples = sample_count(study);
  plan.draw = [sampler = Sampler(study)](std::uint64_t id) { return sampler.draw(id); };
  const auto tables =
      is_flexible(study.scene) ? std::make_shared<CageTables>(study.scene) : nullptr;
  if (tables)
    plan.prepare = [tables, draw = plan.draw, samples = plan.samples](int rank, int ranks) {
      std::set<GridPoint> points;
      for (std::uint64_t id = 0; id < samples; ++id)
        points.insert(tables->point_of(draw(id).scene));
      tables->make(points, rank, ranks);
    };
  plan.job = [tables, study](const Sample& sample, const StopRequested& stop_requested) {
    SimulateOptions options;
    if (tables) options = tables->options_of(sample.scene);
    options.stop_requested = stop_requested;
    return run_sample(study, sample, options);
  };
  return plan;
}

}  // namespace cagetol
