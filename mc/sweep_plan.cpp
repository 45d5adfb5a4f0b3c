#include "mc/sweep_plan.hpp"

namespace cagetol {

SweepPlan make_sweep_plan(const Study& study) {
  SweepPlan plan;
  plan.study = study;
  plan.columns = design_columns(study);
  plan.rows = static_cast<std::uint64_t>(study.samples);
  plan.samples = sample_count(study);
  plan.draw = [sampler = Sampler(study)](std::uint64_t id) { return sampler.draw(id); };
  plan.job = [history = study.history](const Sample& sample, const StopRequested& stop_requested) {
    SimulateOptions options;
    options.stop_requested = stop_requested;
    return run_sample(history, sample.scene, options);
  };
  return plan;
}

}  // namespace cagetol
