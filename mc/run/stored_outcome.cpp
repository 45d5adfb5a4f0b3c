#include "mc/run/stored_outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <string_view>

#include "mc/study/operating_points.hpp"
#include "src/quantities/quantity_labels.hpp"
#include "src/quantities/quantity_table.hpp"

namespace cagetol {
namespace {

bool depends_on_machine(const RunField& field) {
  return std::string_view(field.key) == "wall_s";
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

void compare(const std::string& name, const std::vector<double>& a, const std::vector<double>& b,
             std::vector<std::string>& differences) {
  if (a.size() != b.size()) {
    differences.push_back(fmt::format("{}: {} and {} values", name, a.size(), b.size()));
    return;
  }
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!same_bits(a[i], b[i]))
      differences.push_back(fmt::format("{}[{}]: {} and {}", name, i, a[i], b[i]));
}

}  // namespace

std::string first_bytes(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
  return text.substr(0, most);
}

std::vector<RunField> stored_run_fields() {
  std::vector<RunField> fields;
  for (const RunField& field : run_fields())
    if (!depends_on_machine(field)) fields.push_back(field);
  return fields;
}

StoredOutcome make_stored_outcome(std::uint64_t id, const Outcome& outcome, double wall_s,
                                  int rank) {
  StoredOutcome stored{.id = id,
                       .status = outcome.status,
                       .reason = first_bytes(outcome.reason, kLongestReason),
                       .pocket = outcome.pocket,
                       .interference_um = outcome.interference_um,
                       .quantities = outcome.quantities,
                       .run = {},
                       .wall_s = wall_s,
                       .rank = rank};
  if (stored.quantities.empty())
    stored.quantities.assign(quantity_table().size(), std::numeric_limits<double>::quiet_NaN());
  const std::vector<double> values = run_values(outcome.run);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!depends_on_machine(run_fields()[i])) stored.run.push_back(values[i]);
  return stored;
}

std::vector<std::string> outcome_differences(const StoredOutcome& a, const StoredOutcome& b) {
  std::vector<std::string> differences;
  if (a.status != b.status)
    differences.push_back(
        fmt::format("status: {} and {}", static_cast<int>(a.status), static_cast<int>(b.status)));
  if (a.reason != b.reason)
    differences.push_back(fmt::format("reason: \"{}\" and \"{}\"", a.reason, b.reason));
  if (a.pocket != b.pocket)
    differences.push_back(fmt::format("pocket: {} and {}", a.pocket, b.pocket));
  compare("interference_um", {a.interference_um}, {b.interference_um}, differences);
  compare("quantities", a.quantities, b.quantities, differences);
  compare("run", a.run, b.run, differences);
  return differences;
}

std::string to_bytes(const StoredOutcome& stored) {
  ByteWriter out;
  out.put(stored.id);
  out.put(static_cast<std::int32_t>(stored.status));
  out.put(std::string_view(stored.reason));
  out.put(static_cast<std::int32_t>(stored.pocket));
  out.put(stored.interference_um);
  out.put(stored.quantities);
  out.put(stored.run);
  out.put(stored.wall_s);
  out.put(static_cast<std::int32_t>(stored.rank));
  return out.bytes();
}

StoredOutcome outcome_from_bytes(ByteReader& in) {
  StoredOutcome stored;
  stored.id = in.get<std::uint64_t>();
  stored.status = static_cast<Status>(in.get<std::int32_t>());
  stored.reason = in.get_text();
  stored.pocket = in.get<std::int32_t>();
  stored.interference_um = in.get<double>();
  stored.quantities = in.get_reals();
  stored.run = in.get_reals();
  stored.wall_s = in.get<double>();
  stored.rank = in.get<std::int32_t>();
  return stored;
}

bool meets_limits(const Study& study, const StoredOutcome& stored) {
  const auto labels = quantity_labels(study);
  return stored.status == Status::ok &&
         std::all_of(study.limits.begin(), study.limits.end(), [&](const Limit& limit) {
           return meets(
               limit,
               stored.quantities[static_cast<std::size_t>(labelled_index(limit.quantity, labels))]);
         });
}

bool is_failure(Status status) {
  return status == Status::failed || status == Status::censored || status == Status::poisoned;
}

}  // namespace cagetol
