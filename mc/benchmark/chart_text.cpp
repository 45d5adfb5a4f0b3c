// The chart as JSON and sentences.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "mc/benchmark/chart.hpp"
#include "mc/host/json_number.hpp"
#include "src/quantities/quantity_table.hpp"

namespace cagetol {
namespace {

using Json = nlohmann::ordered_json;

Json cost_json(const ChartCost& cost) {
  return {{"rtf", json_number(cost.rtf)},
          {"rhs_evaluations_per_s", json_number(cost.rhs_per_s)},
          {"problem", cost.problem},
          {"on_front", cost.on_front}};
}

Json biases_json(const WindowErrors& p) {
  Json list = Json::array();
  for (std::size_t q = 0; q < p.biases.size(); ++q) {
    const Bias& b = p.biases[q];
    list.push_back({{"quantity", quantity_table()[q].key},
                    {"bias", json_number(b.bias)},
                    {"standard_error", json_number(b.standard_error)},
                    {"upper_limit", json_number(b.upper_limit)},
                    {"allowed", json_number(b.allowed)},
                    {"verdict", verdict_name(b.verdict)}});
  }
  return list;
}

Json window_json(const WindowErrors& p) {
  Json json = cost_json(p.window);
  json["bias_rms"] = json_number(p.bias_rms);
  json["bias_noise"] = json_number(p.bias_noise);
  json["biases"] = biases_json(p);
  return json;
}

std::string rungs_text(const Chart& chart) {
  std::string text = fmt::format(
      "\nrungs of the model ladder against {}, integrated tightly\n{:<32}{:>9}{:>11}{:>11}{:>11}\n",
      chart.rungs.back().rung.name, "rung", "RTF", "quantities", "bias rms", "resolved");
  for (const RungPoint& p : chart.rungs)
    text += fmt::format("{:<32}{:>9.3f}{:>11}{:>11.2g}{:>11.2g}{}\n", p.rung.name, p.window.rtf,
                        p.quantities, p.bias_rms, p.bias_noise,
                        p.window.problem.empty() ? "" : "  " + p.window.problem);
  return text;
}

/// Keys of the quantities with that verdict, separated by commas.
std::string quantities_that_are(BiasVerdict verdict, const ChartPoint& p) {
  std::string text;
  for (std::size_t q = 0; q < p.biases.size(); ++q)
    if (p.biases[q].verdict == verdict)
      text += (text.empty() ? "" : ", ") + std::string(quantity_table()[q].key);
  return text;
}

}  // namespace

Json chart_json(const Chart& chart) {
  Json json = {{"kind", "chart"},
               {"scene", chart.scene},
               {"horizon_s", chart.options.horizon},
               {"replicas", chart.options.replicas},
               {"study_samples", kStudySamples},
               {"reference_gap", json_number(chart.reference_gap)}};
  auto& points = json["points"] = Json::array();
  for (const ChartPoint& p : chart.points) {
    Json point = {{"label", setting_label(p.setting)},
                  {"method", spelled(p.setting.method)},
                  {"tolerance", p.setting.tolerance},
                  {"default", &p == &chart.points.front()},
                  {"reference", setting_label(reference_setting(p.setting.method))}};
    point["trajectory"] = cost_json(p.brief);
    point["trajectory"]["error"] = json_number(p.trajectory_error);
    point["window"] = window_json(p);
    points.push_back(std::move(point));
  }
  json["rungs"] = Json::array();
  for (const RungPoint& p : chart.rungs)
    json["rungs"].push_back({{"rung", p.rung.name},
                             {"meaning", p.rung.meaning},
                             {"settings", p.rung.settings},
                             {"quantities", p.quantities},
                             {"window", window_json(p)}});
  return json;
}

std::string chart_text(const Chart& chart) {
  const ChartPoint& own = chart.points.front();
  std::string text = fmt::format(
      "scene {}, in error scales of integration.tolerance, after {:g} ms, median of {} starts "
      "(references apart by {:.2g}):\n"
      "{:<32}{:>9}{:>11}{:>11}{:>11}\n",
      chart.scene, 1e3 * chart.options.horizon, chart.options.starts, chart.reference_gap,
      "setting (* on the front)", "RTF", "error", "bias rms", "resolved");
  for (const ChartPoint& p : chart.points) {
    text += fmt::format(
        "{:<32}{:>9.3g}{:>11.2g}{:>11.2g}{:>11.2g}",
        setting_label(p.setting) + (p.brief.on_front ? " *" : "") + (p.window.on_front ? " +" : ""),
        std::isfinite(p.window.rtf) ? p.window.rtf : p.brief.rtf, p.trajectory_error, p.bias_rms,
        p.bias_noise);
    for (const std::string& problem : {p.brief.problem, p.window.problem})
      if (!problem.empty()) text += "  " + problem;
    text += "\n";
  }
  text += fmt::format("The default, {}, is {} the front of error against time over {:g} ms.\n",
                      setting_label(own.setting), own.brief.on_front ? "on" : "NOT on",
                      1e3 * chart.options.horizon);
  if (chart.options.replicas == 0) return text;
  text +=
      "(+: on the front of bias against time.) Bias rms and what is resolved are in standard "
      "deviations of a quantity between replicas.\n";
  const std::string biased = quantities_that_are(BiasVerdict::biased, own);
  if (!biased.empty()) text += "The default is biased in " + biased + ".\n";
  const std::string steady = quantities_that_are(BiasVerdict::steady, own);
  if (!steady.empty()) text += "Without scatter between replicas: " + steady + ".\n";
  bool named = false;
  for (const ChartPoint& p : chart.points) {
    const std::string sound = quantities_that_are(BiasVerdict::unbiased, p);
    if (sound.empty() || !p.window.problem.empty() || !(p.window.rtf < own.window.rtf)) continue;
    text +=
        setting_label(p.setting) + " is cheaper than the default and unbiased for " + sound + ".\n";
    named = true;
  }
  if (!named)
    text += fmt::format(
        "No cheaper setting is shown to be unbiased: {} replicas leave the rest unresolved; {:.0f} "
        "at most would resolve a bias of one standard error of a {:g}-sample study.\n",
        chart.options.replicas, replicas_to_resolve(), kStudySamples);
  if (!chart.rungs.empty()) text += rungs_text(chart);
  return text;
}

}  // namespace cagetol
