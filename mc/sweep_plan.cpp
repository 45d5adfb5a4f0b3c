#include "mc/sweep_plan.hpp"

#include "mc/cage_cache.hpp"

namespace cagetol {

SweepPlan make_sweep_plan(const Study& study) {
  SweepPlan plan;
  plan.study = study;
  plan.columns = design_columns(study);
  plan.rows = static_cast<std::uint64_t>(study.samples);
  plan.samples = sample_count(study);
  plan.draw = [sampler = Sampler(study)](std::uint64_t id) { return sampler.draw(id); };
  const auto table = std::make_shared<std::shared_ptr<const CageTable>>();
  plan.prepare = [table, scene = study.scene] {
    if (is_flexible(scene)) *table = kept_cage_table(scene);
  };
  plan.job = [table, study](const Sample& sample, const StopRequested& stop_requested) {
    SimulateOptions options;
    options.cage_table = *table;
    options.stop_requested = stop_requested;
    return run_sample(study, sample, options);
  };
  return plan;
}

}  // namespace cagetol
