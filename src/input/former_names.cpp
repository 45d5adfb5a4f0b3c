#include "src/input/former_names.hpp"

#include <array>
#include <string>

namespace cagetol {
namespace {

// clang-format off
constexpr auto kFormerNames = std::to_array<FormerName>({
    // name, value, now, why, remedy
    {"lobes", "", "waviness", "", ""},
    {"bearing.least_load_factor", "", "bearing.minimum_load_factor", "", ""},
    {"lubrication.land_film_least_um", "", "lubrication.land_film_minimum_um", "", ""},
    {"tolerance.dimension.band_mm", "", "tolerance.dimension.tolerance_width_mm", "", ""},
    {"cage_yield_utilisation", "", "cage_strength_utilisation", "", ""},
    {"orbit_slip_ratio_loaded", "", "driving_slip_ratio", "", ""},
    {"orbit_slip_ratio", "", "", "over whole turns of the cage it was cage_slip_ratio", "limit driving_slip_ratio, the slip of the rollers that drive, or cage_slip_ratio"},
    {"whirl_energy_ratio", "", "", "it told nothing that whirl_ratio does not", "limit whirl_ratio"},
    {"whirl_speed_deviation_ratio", "", "", "regular circling has the least of all", "limit whirl_ratio"},
    {"model.rollers", "", "", "planar rollers saved no time at the same error", "leave the line out: rollers always tilt, skew and move axially"},
    {"orbit_class", "", "", "it told nothing that limits can use", "use whirl_resting_share, whirl_circling_share or whirl_irregular_share"},
    {"window.measure", "", "", "windows that end by themselves saved a fifth of the time and added noise", "leave it out; window.measure_revolutions is the length of the window"},
    {"window.measure_share", "", "", "windows no longer end by themselves", "leave it out; window.measure_revolutions is the length of the window"},
    {"trend", "", "", "claims of a source are no part of a study", "leave it out; a level is a study of its own by --set"},
    {"design", "grid", "", "it gave no yield and no tolerance", "use random or lhs; a level is a study of its own by --set"},
    {"design", "sobol", "", "exact bounds need independent rows, and lhs spreads them as well", "use random or lhs"},
    {"scrambles", "", "", "the design sobol had them", "leave it out"},
    {"grid_levels", "", "", "the design grid gave no yield and no tolerance", "leave it out; a level is a study of its own by --set"},
    {"multifidelity", "", "", "no quantity of the cage's motion gained from runs of a cheaper model", "leave it out; for fewer standard errors raise samples"},
    {"cage.model", "none", "", "only bearings with a cage are modelled; the torque of full complements was off by 1.8", "choose a bearing with a cage"},
    {"integration.method", "semi-implicit-euler", "", "arkode-erk shows what explicit steps do", "use arkode-erk"},
    {"integration.fixed_step_us", "", "", "no method has fixed steps any more", "use integration.max_step_us"},
    {"film", "", "", "the older film of the races alone is gone", "use lubrication.model = \"film\" with the keys of lubrication, or leave the line out"},
    {"speed.oscillation_amplitude_deg", "", "", "a duty that repeats says it", "give one period in duty.time_s and duty.inner_rpm, and duty.repeat_s"},
    {"speed.oscillation_Hz", "", "", "a duty that repeats says it", "give one period in duty.time_s and duty.inner_rpm, and duty.repeat_s"},
    {"tolerance.dimension.cost_a", "", "", "a table has the same costs at the candidates", "use cost_table = [[width in mm, cost], ...]"},
    {"tolerance.dimension.cost_b", "", "", "a table has the same costs at the candidates", "use cost_table = [[width in mm, cost], ...]"},
    {"tolerance.dimension.cost_k", "", "", "a table has the same costs at the candidates", "use cost_table = [[width in mm, cost], ...]"},
    {"cage.guide_film", "", "", "lubrication has a film at guide lands", "use lubrication.model = \"film\" with lubrication.land_film"},
    {"cage.guide_film_viscosity_Pa_s", "", "", "lubrication has a film at guide lands", "use lubrication.viscosity_Pa_s"},
    {"cage.guide_film_width_mm", "", "", "lubrication has a film at guide lands", "use lubrication.land_film_width_mm"},
    {"cage.guide_film_least_um", "", "", "lubrication has a film at guide lands", "use lubrication.land_film_minimum_um"},
    {"neighbour_force_rms_N", "", "", "only bearings with a cage are modelled", "limit pocket_force_rms_N"},
    {"neighbour_force_p99_N", "", "", "only bearings with a cage are modelled", "limit pocket_force_p99_N"},
    {"neighbour_force_peak_N", "", "", "only bearings with a cage are modelled", "limit pocket_force_peak_N"},
    {"neighbour_impacts_per_revolution", "", "", "only bearings with a cage are modelled", "use pocket_impacts_per_revolution"},
    {"power_neighbour_W", "", "", "only bearings with a cage are modelled", "use power_pocket_W"},
});
// clang-format on

}  // namespace

std::span<const FormerName> former_names() {
  return kFormerNames;
}

const FormerName* former_name(std::string_view name, std::string_view value) {
  if (name.starts_with("scene.")) name.remove_prefix(6);
  for (const FormerName& row : kFormerNames) {
    const bool below = value.empty() && name.size() > row.name.size() &&
                       name.starts_with(row.name) && name[row.name.size()] == '.';
    if (row.value == value && (name == row.name || below)) return &row;
  }
  return nullptr;
}

std::string former_problem(const FormerName& row) {
  if (!row.now.empty()) return "this was renamed";
  return "this is gone: " + std::string(row.why);
}

std::string former_remedy(const FormerName& row) {
  if (!row.now.empty()) return "write " + std::string(row.now);
  return std::string(row.remedy);
}

}  // namespace cagetol
