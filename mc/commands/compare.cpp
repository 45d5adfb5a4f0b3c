// cagetol compare OLD NEW: has any statistic of a study changed between two sweeps?
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/compare/bias.hpp"
#include "analysis/compare/comparison.hpp"
#include "analysis/compare/matched_runs.hpp"
#include "analysis/report/report.hpp"
#include "analysis/study/refused.hpp"
#include "mc/commands/command.hpp"
#include "mc/commands/output_path.hpp"
#include "mc/host/json_number.hpp"
#include "mc/host/log.hpp"
#include "mc/study_file/study_file_error.hpp"

namespace cagetol {
namespace {

using Json = nlohmann::ordered_json;

struct CompareArguments {
  std::string before, after;
  double error_rate = 0.01;
  bool json = false, all = false, despite_keys = false;
  long bias = 0;  ///< samples of the study whose standard error biases are held against; 0: none
  std::vector<std::string> judged;  ///< quantities whose biases decide; empty: all
};

/// Unchanged statistics that the table shows without --all: those nearest to a change.
constexpr std::size_t kUnchangedShown = 5;

Json to_json(const Comparison& comparison) {
  Json statistics = Json::array();
  for (const StatisticChange& change : comparison.statistics) statistics.push_back(to_json(change));
  return {{"comparable", true},
          {"same", comparison.same()},
          {"same_cages", comparison.paired},
          {"error_rate", comparison.error_rate},
          {"multiplicity", "Holm"},
          {"notes", comparison.notes},
          {"statistics", statistics}};
}

std::string table_text(const Comparison& comparison, bool all) {
  std::string text = fmt::format("{:<36}{:<22}{:>13}{:>13}{:>12}\n", "quantity", "statistic", "old",
                                 "new", "adjusted p");
  std::size_t changed = 0, unchanged = 0;
  for (const StatisticChange& change : comparison.statistics) {
    changed += change.changed;
    if (!change.changed && ++unchanged > kUnchangedShown && !all) continue;
    text += fmt::format("{:<36}{:<22}{:>13.6g}{:>13.6g}{:>12.3g}{}\n", change.quantity,
                        change.statistic, change.before, change.after, change.adjusted_p_value,
                        change.changed ? "  CHANGED" : "");
  }
  if (!all && unchanged > kUnchangedShown)
    text += fmt::format("and {} more that have not changed (--all shows them)\n",
                        unchanged - kUnchangedShown);
  for (const std::string& note : comparison.notes) text += "note: " + note + "\n";
  return text + fmt::format(
                    "{} of {} statistics changed{}; the chance of any false alarm is at most {:g} "
                    "(Holm)\n",
                    changed, comparison.statistics.size(),
                    comparison.paired ? ", the same cages compared pair by pair" : "",
                    comparison.error_rate);
}

int not_comparable(const CompareArguments& options, const std::string& reason) {
  if (options.json) print(Json{{"comparable", false}, {"reason", reason}}.dump(2) + "\n");
  say("cagetol: not comparable: {}\n", reason);
  return kBadInput;
}

struct NamedBias {
  std::string quantity, unit;
  Bias bias;
};

Json to_json(const std::vector<NamedBias>& biases, const std::vector<std::string>& notes) {
  Json quantities = Json::array();
  for (const auto& [quantity, unit, b] : biases)
    quantities.push_back({{"quantity", quantity},
                          {"unit", unit},
                          {"pairs", b.pairs},
                          {"mean", json_number(b.mean)},
                          {"bias", json_number(b.bias)},
                          {"standard_error", json_number(b.standard_error)},
                          {"upper_limit", json_number(b.upper_limit)},
                          {"allowed", json_number(b.allowed)},
                          {"verdict", verdict_name(b.verdict)}});
  return {{"comparable", true}, {"notes", notes}, {"biases", quantities}};
}

std::string bias_text(const std::vector<NamedBias>& biases, const std::vector<std::string>& notes,
                      long samples) {
  std::string text = fmt::format(
      "Mean of NEW less that of OLD, pair by pair: in per cent of the mean, and in standard errors "
      "of a study of {} samples; limits hold at 95 %, each by itself.\n\n"
      "{:<36}{:>13}{:>20}{:>16}{:>9}  {}\n",
      samples, "quantity", "mean", "difference, %", "study errors", "limit", "verdict");
  std::map<BiasVerdict, int> count;
  std::size_t pairs = 0;
  for (const auto& [quantity, unit, b] : biases) {
    ++count[b.verdict];
    pairs = std::max(pairs, b.pairs);
    const double percent = 100 / std::abs(b.mean);
    text += fmt::format(
        "{:<36}{:>13.6g}{:>20}{:>16}{:>9.2f}  {}\n", quantity, b.mean,
        fmt::format("{:+.3f} +- {:.3f}", percent * b.bias, percent * b.standard_error),
        fmt::format("{:+.2f} +- {:.2f}", b.bias / b.allowed, b.standard_error / b.allowed),
        b.upper_limit / b.allowed, verdict_name(b.verdict));
  }
  for (const std::string& note : notes) text += "note: " + note + "\n";
  return text + fmt::format(
                    "{} pairs: of {} quantities that scatter {} are unbiased (limit below "
                    "one standard error), {} biased, {} unresolved\n",
                    pairs, biases.size(), count[BiasVerdict::unbiased], count[BiasVerdict::biased],
                    count[BiasVerdict::unresolved]);
}

int run_bias(const CompareArguments& options, const StudyData& before, const StudyData& after) {
  std::vector<std::string> notes;
  require_comparable(before, after, options.despite_keys, notes);
  if (!same_cages(before, after))
    throw Refused("--bias compares pair by pair: give both sweeps the same seed and samples");
  if (share_lots(before))
    throw Refused("--bias takes runs for independent of each other, cages of one lot are not");
  std::vector<NamedBias> biases;
  for (const MatchedRuns& runs : matched_runs(before, after)) {
    const Bias bias = compare_pairs(runs.values, runs.reference, static_cast<double>(options.bias));
    if (bias.pairs >= 2 && bias.verdict != BiasVerdict::steady)
      biases.push_back({runs.quantity, runs.unit, bias});
  }
  // Judged quantities first, in the order asked for.
  const auto rank = [&](const NamedBias& b) {
    return std::find(options.judged.begin(), options.judged.end(), b.quantity) -
           options.judged.begin();
  };
  for (const std::string& name : options.judged)
    if (std::none_of(biases.begin(), biases.end(),
                     [&](const NamedBias& b) { return b.quantity == name; }))
      throw Refused("--judge " + name + ": no such quantity that scatters in both sweeps");
  std::stable_sort(biases.begin(), biases.end(),
                   [&](const NamedBias& a, const NamedBias& b) { return rank(a) < rank(b); });
  print(options.json ? to_json(biases, notes).dump(2) + "\n"
                     : bias_text(biases, notes, options.bias));
  const std::size_t count = options.judged.empty() ? biases.size() : options.judged.size();
  const auto judged_end = biases.begin() + static_cast<std::ptrdiff_t>(count);
  const auto unbiased = [](const NamedBias& b) { return b.bias.verdict == BiasVerdict::unbiased; };
  if (!options.judged.empty() && !options.json)
    print(fmt::format("judged: the first {}, of which {} are unbiased\n", count,
                      std::count_if(biases.begin(), judged_end, unbiased)));
  return std::all_of(biases.begin(), judged_end, unbiased) ? kDone : kLimitsNotMet;
}

int run_compare(const CompareArguments& options) {
  try {
    const StudyData before = read_study_data(study_file_in(options.before)),
                    after = read_study_data(study_file_in(options.after));
    if (options.bias > 0) return run_bias(options, before, after);
    const Comparison comparison =
        compare_studies(before, after, options.error_rate, options.despite_keys);
    print(options.json ? to_json(comparison).dump(2) + "\n" : table_text(comparison, options.all));
    return comparison.same() ? kDone : kLimitsNotMet;
  } catch (const Refused& refusal) {
    return not_comparable(options, refusal.what());
  } catch (const StudyFileError& error) {
    return not_comparable(options, error.what());
  }
}

}  // namespace

Chosen compare_command(CLI::App& command) {
  command.footer(
      "Exit code 0: nothing changed, 1: something did, 2: not comparable, with the reason.\n"
      "With --bias 0: every limit (of those of --judge) is below one standard error, 1: some are "
      "not.\n\n"
      "Examples:\n  cagetol compare out/yesterday out/today\n"
      "  cagetol compare out/tight out/default --despite-keys --bias 1000");
  auto options = std::make_shared<CompareArguments>();
  add_result_directory(command, "OLD", options->before, "Directory of the earlier sweep");
  add_result_directory(command, "NEW", options->after, "Directory of the later sweep");
  command
      .add_option("--error-rate", options->error_rate,
                  "Probability of any false alarm when nothing has changed")
      ->check(CLI::Range(1e-9, 0.5))
      ->capture_default_str();
  command.add_flag("--all", options->all, "Show every statistic");
  command.add_flag("--despite-keys", options->despite_keys,
                   "Compare sweeps whose keys differ; the differences are noted");
  command
      .add_option("--bias", options->bias,
                  "Show the difference of each mean instead, pair by pair, in standard errors of "
                  "a study of N samples")
      ->check(CLI::Range(2L, 1000000000L))
      ->type_name("N");
  command
      .add_option("--judge", options->judged,
                  "With --bias: only these quantities decide on the exit code, the others are "
                  "listed")
      ->delimiter(',')
      ->type_name("NAME,NAME");
  command.add_flag("--json", options->json, "Print every statistic as JSON");
  return [options] { return run_compare(*options); };
}

}  // namespace cagetol
