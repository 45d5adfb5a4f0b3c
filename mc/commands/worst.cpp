// cagetol worst DIR: the cages nearest to a limit, with every pocket of theirs.
#include <memory>

#include "analysis/report/csv_tables.hpp"
#include "analysis/report/report.hpp"
#include "mc/commands/command.hpp"
#include "mc/commands/output_path.hpp"
#include "src/input/input_error.hpp"

namespace cagetol {

Chosen worst_command(CLI::App& command) {
  command.footer(
      "One line of CSV for each sample: what it is nearest to, its margin as a share of that "
      "limit\n"
      "(negative beyond it; empty where a roller jams), limited quantities, and the value of "
      "every\n"
      "input, of each pocket. `cagetol replay DIR --sample ID` runs it again.\n\n"
      "Examples:\n  cagetol worst out/nu205\n"
      "  cagetol worst out/nu205/confirm-1 -n 3 --quantity cage_fatigue_utilisation@rated");
  struct Arguments {
    std::string directory, quantity;
    std::size_t count = 10;
  };
  const auto arguments = std::make_shared<Arguments>();
  add_result_directory(command, "DIR", arguments->directory,
                       "Directory of a sweep, a stage or a recommendation");
  command.add_option("-n", arguments->count, "Samples at most")->capture_default_str();
  command.add_option("--quantity", arguments->quantity, "Go by the limits of this quantity alone");
  return [arguments] {
    const StudyData study = read_study_data(study_file_in(arguments->directory));
    const auto limited = [&](const Limit& limit) {
      return arguments->quantity.empty() || limit.quantity == arguments->quantity;
    };
    if (std::none_of(study.plan.limits.begin(), study.plan.limits.end(), limited))
      throw InputError({}, "--quantity", arguments->quantity, "the study has no limit on it",
                       "`cagetol judge DIR` lists its limits");
    print(worst_csv(study, arguments->count, arguments->quantity));
    return static_cast<int>(kDone);
  };
}

}  // namespace cagetol
