// cagetol quantities [NAME]: what a run and an operating point tell, with unit, definition, what
// each needs of the model and what it is used for.
#include <fmt/format.h>

#include <memory>
#include <sstream>

#include "mc/commands/command.hpp"
#include "src/input/input_error.hpp"
#include "src/input/key_table.hpp"
#include "src/quantities/operating_point.hpp"
#include "src/quantities/quantity_table.hpp"

namespace cagetol {
namespace {

struct Entry {
  std::string name, unit, definition, needs, over, use;
};

std::vector<Entry> entries() {
  std::vector<Entry> all;
  for (const Quantity& quantity : quantity_table()) {
    all.push_back({quantity.key, quantity.unit, quantity.definition, quantity.need.text,
                   is_extreme(quantity.kind) ? "window.peak_revolutions" : "the whole window",
                   quantity.use});
  }
  for (const OperatingRow& row : operating_rows())
    all.push_back({row.key, row.unit, row.definition, "any model", "no run",
                   "operating point: cagetol check, simulate, study.h5; no limits"});
  return all;
}

/// The one called so, else those whose names hold it. Throws InputError where there is none.
std::vector<Entry> matching(const std::string& name) {
  const std::vector<Entry> all = entries();
  std::vector<Entry> found;
  std::vector<std::string> names;
  for (const Entry& entry : all) {
    if (entry.name == name) return {entry};
    if (entry.name.find(name) != std::string::npos) found.push_back(entry);
    names.push_back(entry.name);
  }
  if (found.empty())
    throw InputError({}, "NAME", name, "no quantity is called so",
                     suggestion(name, names, "cagetol quantities lists every one"));
  return found;
}

/// Lines of up to 100 characters, indented; the first one begins with `label`.
std::string paragraph(const std::string& label, const std::string& text) {
  constexpr std::size_t kWidth = 100;
  const std::string indent(14, ' ');
  std::string lines, line = fmt::format("    {:<10}", label), word;
  for (std::istringstream words(text); words >> word; line += word + " ")
    if (line.size() + word.size() > kWidth) {
      line.back() = '\n';
      lines += line;
      line = indent;
    }
  line.back() = '\n';
  return lines + line;
}

std::string text_of(const Entry& entry) {
  return fmt::format("{}{}\n", entry.name, entry.unit == "-" ? "" : " [" + entry.unit + "]") +
         paragraph("is", entry.definition) + paragraph("needs", entry.needs) +
         paragraph("over", entry.over) + paragraph("use", entry.use);
}

nlohmann::ordered_json json_of(const Entry& entry) {
  return {{"name", entry.name},   {"unit", entry.unit}, {"definition", entry.definition},
          {"needs", entry.needs}, {"over", entry.over}, {"use", entry.use}};
}

std::string listing(const std::string& name, bool json) {
  auto list = nlohmann::ordered_json::array();
  std::string text;
  for (const Entry& entry : matching(name)) {
    list.push_back(json_of(entry));
    text += text_of(entry);
  }
  return json ? list.dump(2) + "\n" : text;
}

}  // namespace

Chosen quantities_command(CLI::App& command) {
  struct Options {
    std::string name;
    bool json = false;
  };
  command.footer(
      "Examples:\n  cagetol quantities\n  cagetol quantities driving_slip_ratio --json\n"
      "  cagetol quantities pocket_force");
  auto options = std::make_shared<Options>();
  command.add_option("NAME", options->name, "A quantity, or a part of names");
  command.add_flag("--json", options->json, "Print a list as JSON");
  return [options] {
    print(listing(options->name, options->json));
    return kDone;
  };
}

}  // namespace cagetol
