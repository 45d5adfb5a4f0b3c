// Failures with their replay commands, worst samples, provenance, assumptions, definitions.
#include <fmt/format.h>

#include "analysis/report/html_report.hpp"
#include "analysis/report/html_text.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kFailuresShown = 25;

std::string value_text(const Json& value) {
  if (value.is_string()) return escaped(value.get<std::string>());
  if (value.is_number_float()) return fmt::format("{:.6g}", value.get<double>());
  std::string text = value.dump();
  return escaped(text.size() > 60 ? text.substr(0, 57) + "..." : text);
}

std::string law_text(const Json& law) {
  if (law.is_null()) return "";
  std::string text = law.value("law", "?");
  for (const auto& [key, value] : law.items())
    if (key != "law" && !value.is_null())
      text += (text.find('(') == std::string::npos ? " (" : ", ") + key + " " + value_text(value);
  return escaped(text) + (text.find('(') == std::string::npos ? "" : ")");
}

std::string inputs_table(const Json& from) {
  std::vector<std::vector<std::string>> rows;
  for (const Json& input : from["inputs"])
    rows.push_back({code(input["key"]),
                    input["nominal"].empty() ? "" : value_text(input["nominal"][0]),
                    law_text(input["lot"]), law_text(input["pocket"]), law_text(input["noise"])});
  return "<h3>What scatters</h3>\n" +
         table("tnttt", {"key", "nominal", "lot (whole cage)", "single pockets", "each run"}, rows);
}

std::string shift_text(const Json& shift) {
  const auto known = [&](const char* key) { return rounded(shift.value(key, Json())); };
  return known("shift") + " (" + known("lower") + " to " + known("upper") + ")";
}

/// "0.0021 % (0.063 %)"; nothing where the quantity's limits were not looked at.
std::string wrong_share_text(const Json& shift) {
  const Json share = shift.value("wrong_share", Json()),
             allowed = shift.value("allowed_wrong_share", Json());
  if (share.is_null() || allowed.is_null()) return "-";
  return fmt::format("{:.2g} % ({:.2g} %)", 100 * share.get<double>(), 100 * allowed.get<double>());
}

std::string quantity_text(const Json& shift) {
  const std::string limit = shift.value("limit", "");
  return escaped(readable(shift["quantity"])) +
         (limit.empty() ? "" : "<br><small>" + escaped(limit) + "</small>");
}

std::string fidelity_text(const Json& decision) {
  if (decision.is_null()) return "";
  std::vector<std::vector<std::string>> rows;
  for (const Json& shift : decision["shift"])
    rows.push_back({quantity_text(shift), escaped(shift["rung"]), shift_text(shift),
                    rounded(shift.value("budget", Json())), wrong_share_text(shift),
                    escaped(shift["verdict"])});
  std::string html = "<h3>The model, chosen by a pilot</h3>\n" +
                     paragraph("Rung <b>" + escaped(decision["rung"]) +
                               "</b>: " + escaped(decision["reason"]) + ".") +
                     table("ttnnnt",
                           {"limited quantity", "rung", "shift of the mean (95 %)", "budget",
                            "beyond the limit (allowed)", "verdict"},
                           rows);
  html += note(
      "Shifts are those against the highest rung; beyond the limit: the largest share of runs "
      "on its wrong side, and the share below which it is settled.");
  if (const std::string assumption = decision.value("assumption", ""); !assumption.empty())
    html += paragraph(
        "<b>Settled</b>: no run of the pilot is on the wrong side of the limit, "
        "on this rung and on the highest one, and at most the given share of all "
        "can be (95 % confidence): too little to move a yield. It assumes " +
        escaped(assumption) + ". The mean of such a quantity may be off by the shift.");
  return html;
}

std::string scene_items(const Json& section, const std::string& prefix) {
  std::string items;
  for (const auto& [key, value] : section.items()) {
    if (value.is_object())
      items += scene_items(value, prefix + key + ".");
    else if (prefix + key != "assumption")  // a chapter of its own
      items += "<div>" + code(prefix + key) + "<span>" + value_text(value) + "</span></div>";
  }
  return items;
}

std::string scene_list(const Json& scene) {
  const std::string items = scene_items(scene, "");
  return "<h3>The scene, nominal values</h3>\n<div class=\"columns\">" + items + "</div>\n";
}

/// Key, reason and range of an assumption.
std::vector<std::string> stated_row(const Json& entry) {
  if (!entry.is_object())
    return {code(entry.is_string() ? entry.get<std::string>() : entry.dump()), "", ""};
  const std::string range = entry.contains("low") && entry.contains("high")
                                ? value_text(entry["low"]) + " to " + value_text(entry["high"])
                                : "";
  return {code(entry.value("key", "")),
          value_text(entry.contains("note") ? entry["note"] : Json("")), range};
}

std::string assumptions_text(const Json& assumptions) {
  std::string html = "<h3>Assumptions</h3>\n";
  std::string speeds;
  for (const auto& [key, value] : assumptions["friction"].items())
    speeds += (speeds.empty() ? "" : ", ") + code(key) + " = " + value_text(value);
  if (!speeds.empty())
    html += paragraph("Friction law and its transition speeds: " + speeds +
                      ". Slip, wear and power loss depend on them; they are assumptions unless "
                      "measured for this lubricant.");
  if (assumptions["model"].value("rollers", "") == "planar")
    html += paragraph(
        "Rollers are planar: they stay parallel to the bearing's axis, in the middle. "
        "Misalignment, squareness and taper do nothing to them, and skew and tilt are not "
        "defined.");
  else if (assumptions["model"].value("ring_tilt", "") == "free")
    html += paragraph(
        "The tilt of the inner ring is free: rollers, shaft and the ring's inertia hold it, "
        "not the seat. Its shaft is a spring against the tilt that the misalignment states.");
  if (assumptions["model"].value("motion", "") == "quasi-static")
    html += paragraph(
        "The bearing is quasi-static: ring and rollers are in equilibrium at every position of the "
        "cage, which turns at its kinematic speed; rolling without slip is assumed, without an oil "
        "film. Forces on the cage, its motion, slip and friction are not defined.");
  const Json& stated = assumptions["stated"];
  if (stated.is_null() || stated.empty())
    return html + paragraph(
                      "The study does not mark which of its values are measured and which are "
                      "assumed. Take every value of the scene below as an assumption unless you "
                      "know where it comes from.");
  std::vector<std::vector<std::string>> rows;
  if (stated.is_object())
    for (const auto& [key, text] : stated.items())
      rows.push_back({code(key), value_text(text), ""});
  else
    for (const Json& entry : stated) rows.push_back(stated_row(entry));
  return html + table("ttt", {"value", "why it is an assumption", "may be"}, rows);
}

}  // namespace

std::string failures_chapter(const Json& report) {
  const Json& failures = report["failures"]["samples"];
  std::string body;
  if (failures.empty()) {
    body = paragraph("Every run gave a result.");
  } else {
    const Json& joint = report["limits"]["joint"];
    if (joint["if_unknown_fail"].is_number())
      body = paragraph(
          fmt::format("Joint yield of the scatter as sampled: {} if every run without a result "
                      "fails, {} if every one passes; jams count as failing in both.",
                      percent(joint["if_unknown_fail"]), percent(joint["if_unknown_pass"])));
    std::vector<std::vector<std::string>> rows;
    for (const Json& failure : failures) {
      if (rows.size() == kFailuresShown) break;
      rows.push_back({rounded(failure["id"]), escaped(failure["status"]),
                      escaped(failure["reason"]), rounded(failure["pocket"]),
                      rounded(failure["interference_um"]), code(failure["replay"])});
    }
    body +=
        table("nttnnt",
              {"sample", "outcome", "reason", "pocket", "interference [µm]", "run it again"}, rows);
    if (failures.size() > kFailuresShown)
      body += note(fmt::format("The first {} of {}; all are in report.json.", kFailuresShown,
                               failures.size()));
  }
  if (!report["worst_samples"].empty()) {
    std::vector<std::vector<std::string>> rows;
    for (const Json& worst : report["worst_samples"])
      rows.push_back({escaped(readable(worst["quantity"])),
                      rounded(worst["value"]) + unit_suffix(worst["unit"]), escaped(worst["limit"]),
                      worst["meets_limit"].get<bool>() ? "meets" : "misses", rounded(worst["id"]),
                      code(worst["replay"])});
    body +=
        "<h3>Worst samples</h3>\n" +
        table("tnttnt", {"quantity", "value", "limit", "", "sample", "run it again"}, rows) +
        note("DIR is the directory of the study. A replay gives the same numbers to the last bit.");
  }
  return chapter("failures", "Failures and worst samples", body);
}

std::string provenance_chapter(const Json& report) {
  const Json& from = report["provenance"];
  std::string libraries;
  if (from["libraries"].is_object())
    for (const auto& [name, version] : from["libraries"].items())
      libraries += (libraries.empty() ? "" : ", ") + escaped(name) + " " + value_text(version);
  else
    libraries = value_text(from["libraries"]);
  std::string files;
  for (const Json& file : from["files"]) files += (files.empty() ? "" : "; ") + escaped(file);
  std::string body =
      table("tt", {"", ""},
            {{"study", escaped(from["study_name"]) + ", hash " + code(from["study_hash"]) +
                           ", seed " + from["seed"].dump()},
             {"program", "cagetol " + escaped(from["tool_version"]) + ", commit " +
                             code(from["tool_commit"]) + "; " + escaped(from["build"])},
             {"libraries", libraries},
             {"further input files", files.empty() ? "none" : files},
             {"design", fmt::format("{}; {} cage(s) of a lot; {} pockets", escaped(from["design"]),
                                    rounded(from["cages_per_lot"]), rounded(from["pockets"]))},
             {"intervals", escaped(report["intervals"]["method"])}});
  body += fidelity_text(report["fidelity"]);
  body += assumptions_text(report["assumptions"]);
  body += inputs_table(from);
  std::vector<std::vector<std::string>> rows;
  for (const Json& quantity : report["quantities"])
    rows.push_back(
        {code(quantity["quantity"]), escaped(quantity["unit"]), escaped(quantity["definition"])});
  body += "<h3>Definitions</h3>\n" + table("ttt", {"quantity", "unit", "definition"}, rows);
  body += scene_list(from["scene"]);
  return chapter("provenance", "Where this comes from", body);
}

}  // namespace cagetol
