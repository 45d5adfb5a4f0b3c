#include "distributions/design.hpp"

#include <algorithm>
#include <tuple>
#include <utility>
#include <variant>

#include "distributions/basics/require.hpp"
#include "distributions/designs/grid.hpp"
#include "distributions/designs/latin_hypercube.hpp"
#include "distributions/designs/morris.hpp"
#include "distributions/designs/pick_freeze.hpp"
#include "distributions/designs/random_design.hpp"
#include "distributions/designs/scrambled_sobol.hpp"

namespace cagetol {

namespace {

using AnyDesign =
    std::variant<RandomDesign, LatinHypercube, ScrambledSobol, Grid, PickFreeze, Morris>;

template <class Kind>
struct Of {
  using Type = Kind;
};

/// Calls the action with Of<the class of the design> and returns its result.
template <class Action>
auto with_kind(DesignKind kind, const Action& action) {
  switch (kind) {
    case DesignKind::random:
      return action(Of<RandomDesign>{});
    case DesignKind::lhs:
      return action(Of<LatinHypercube>{});
    case DesignKind::sobol:
      return action(Of<ScrambledSobol>{});
    case DesignKind::grid:
      return action(Of<Grid>{});
    case DesignKind::pick_freeze:
      return action(Of<PickFreeze>{});
    case DesignKind::morris:
      break;
  }
  return action(Of<Morris>{});
}

void check_numbers(const DesignSpec& spec) {
  require(spec.rows >= 1, "a design needs at least one row");
  require(spec.rows <= most_rows, spec.rows, " rows are more than 2^40; ask for fewer");
  require(spec.cages_per_lot >= 1, "a lot holds at least one cage");
  require(spec.cages_per_lot == 1 || spec.kind == DesignKind::random,
          "cages_per_lot = ", spec.cages_per_lot, " needs design random: ", design_name(spec.kind),
          " spreads each column over all rows");
  require(spec.scrambles >= 1, "a sobol design needs at least one scramble; 8 to 16 are common");
  require(spec.classes >= 1, "rows fall into at least one class");
  require(spec.trim >= 0 && spec.trim < 0.5, "trim = ", spec.trim, " lies outside 0 <= trim < 0.5");
}

void check_addresses(const DesignSpec& spec) {
  using Address = std::tuple<Purpose, std::uint32_t, std::uint32_t>;
  std::vector<Address> addresses;
  for (const DesignColumn& column : spec.columns) {
    addresses.emplace_back(column.purpose, column.stream, column.draw);
  }
  std::sort(addresses.begin(), addresses.end());
  const auto twin = std::adjacent_find(addresses.begin(), addresses.end());
  if (twin == addresses.end()) return;
  const auto& [purpose, stream, draw] = *twin;
  require(false, "two columns have one address (purpose ", static_cast<unsigned>(purpose),
          ", stream ", stream, ", draw ", draw,
          ") and would always be equal; give every input a stream of its own");
}

AnyDesign make_design(const DesignSpec& spec) {
  check_numbers(spec);
  check_addresses(spec);
  return with_kind(spec.kind, [&]<class Kind>(Of<Kind>) -> AnyDesign {
    const std::uint64_t complete = Kind::complete_rows(spec);
    require(spec.rows == complete, "a ", design_name(spec.kind), " design of ", spec.rows,
            " rows is not complete: rows are ", Kind::row_rule(spec), "; use ", complete);
    return Kind(spec);
  });
}

}  // namespace

const char* design_name(DesignKind kind) {
  for (const DesignName& name : spellings(kind))
    if (name.value == kind) return name.text;
  return "";
}

struct Design::Implementation {
  DesignSpec spec;
  AnyDesign design;
  Layout layout;
  std::uint32_t groups;

  explicit Implementation(DesignSpec given)
      : spec(std::move(given)),
        design(make_design(spec)),
        layout(std::visit([](const auto& of) { return of.layout(); }, design)),
        groups(group_count(spec)) {}
};

std::uint64_t complete_rows(const DesignSpec& spec) {
  check_numbers(spec);
  return with_kind(spec.kind, [&]<class Kind>(Of<Kind>) { return Kind::complete_rows(spec); });
}

Design::Design(DesignSpec spec)
    : implementation_(std::make_shared<const Implementation>(std::move(spec))) {}

const DesignSpec& Design::spec() const {
  return implementation_->spec;
}

std::uint64_t Design::rows() const {
  return implementation_->spec.rows;
}

std::size_t Design::dimensions() const {
  return implementation_->spec.columns.size();
}

std::uint32_t Design::groups() const {
  return implementation_->groups;
}

void Design::point(std::uint64_t row, std::span<double> u) const {
  require(row < rows(), "row ", row, " lies beyond the ", rows(), " rows of the design");
  require(u.size() == dimensions(), "a point of ", dimensions(), " coordinates does not fit into ",
          u.size());
  std::visit([&](const auto& of) { of.point(row, u); }, implementation_->design);
}

std::uint64_t Design::blocks() const {
  return implementation_->layout.blocks;
}

std::uint64_t Design::block_of(std::uint64_t row) const {
  return implementation_->layout.block_of(row);
}

std::uint64_t Design::base_of(std::uint64_t row) const {
  return implementation_->layout.base_of(row);
}

std::uint64_t Design::row_of(std::uint64_t block, std::uint64_t base) const {
  return implementation_->layout.row_of(block, base);
}

std::uint64_t Design::lot_of(std::uint64_t row) const {
  return row / spec().cages_per_lot;
}

std::uint64_t Design::source_of(std::uint64_t row, std::uint32_t group) const {
  if (const auto* design = std::get_if<PickFreeze>(&implementation_->design)) {
    return design->source_of(row, group);
  }
  if (const auto* design = std::get_if<Morris>(&implementation_->design)) {
    return design->source_of(row, group);
  }
  return row;
}

std::optional<std::uint32_t> Design::moved_group(std::uint64_t row) const {
  const auto* design = std::get_if<Morris>(&implementation_->design);
  return design ? design->moved_group(row) : std::nullopt;
}

}  // namespace cagetol
