#include "distributions/design.hpp"

#include <algorithm>
#include <tuple>
#include <utility>
#include <variant>

#include "distributions/basics/require.hpp"
#include "distributions/designs/latin_hypercube.hpp"
#include "distributions/designs/random_design.hpp"

namespace cagetol {

namespace {

using AnyDesign = std::variant<RandomDesign, LatinHypercube>;

void check_numbers(const DesignSpec& spec) {
  require(spec.rows >= 1, "a design needs at least one row");
  require(spec.rows <= most_rows, spec.rows, " rows are more than 2^40; ask for fewer");
  require(spec.cages_per_lot >= 1, "a lot holds at least one cage");
  require(spec.cages_per_lot == 1 || spec.kind == DesignKind::random,
          "cages_per_lot = ", spec.cages_per_lot, " needs design random: ", design_name(spec.kind),
          " spreads each column over all rows");
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
  if (spec.kind == DesignKind::lhs) return LatinHypercube(spec);
  return RandomDesign(spec);
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

  explicit Implementation(DesignSpec given) : spec(std::move(given)), design(make_design(spec)) {}
};

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

void Design::point(std::uint64_t row, std::span<double> u) const {
  require(row < rows(), "row ", row, " lies beyond the ", rows(), " rows of the design");
  require(u.size() == dimensions(), "a point of ", dimensions(), " coordinates does not fit into ",
          u.size());
  std::visit([&](const auto& of) { of.point(row, u); }, implementation_->design);
}

std::uint64_t Design::lot_of(std::uint64_t row) const {
  return row / spec().cages_per_lot;
}

}  // namespace cagetol
