#include "mc/study/sample.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "distributions/dependence.hpp"
#include "mc/study/cage_fit.hpp"
#include "mc/study/study_inputs.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {

/// Redraws at most, of a tolerance under which nothing fits: its run then jams.
constexpr std::uint64_t kMostRedraws = 500;
/// Rows of a design are fewer: the k-th redraw of a row has the address of row + k kRedraw.
constexpr std::uint64_t kRedraw = std::uint64_t{1} << 31;

// Where the columns of one input begin in the design; -1 where the scope is absent or a plain
// number.
struct InputPlaces {
  long lot = -1, pocket = -1;
};

struct SampleColumns {
  std::vector<InputPlaces> of_input;
  std::vector<DesignColumn> design;
};

namespace {

bool is_plain_number(const Law& law) {
  const auto range = support(law);
  return range.lower == range.upper;
}

bool is_varied(const std::optional<Law>& law) {
  return law && !is_plain_number(*law);
}

std::uint32_t pocket_count(const Study& study) {
  return static_cast<std::uint32_t>(study.scene.bearing.roller_count);
}

/// The first input that draws its cages from the same file: one column draws them for all, so that
/// what was measured of a cage stays together. `input` itself where it draws none.
std::size_t drawn_with(const Study& study, std::size_t input) {
  const auto file = [&](std::size_t i) -> std::string {
    const auto& of = study.inputs[i];
    return of.draws_cages() ? of.measured->hash + of.measured->group : "";
  };
  std::size_t first = 0;
  while (first < input && (file(input).empty() || file(first) != file(input))) ++first;
  return first;
}

SampleColumns make_columns(const Study& study) {
  SampleColumns columns;
  for (std::size_t i = 0; i < study.inputs.size(); ++i) {
    const auto& input = study.inputs[i];
    InputPlaces of_input;
    if (const std::size_t first = drawn_with(study, i); first < i) {
      of_input.lot = columns.of_input[first].lot;
    } else if (is_varied(input.lot)) {
      of_input.lot = static_cast<long>(columns.design.size());
      columns.design.push_back({Purpose::lot, stream_address(input.key), 0});
    }
    if (is_varied(input.pocket) && !input.draws_cages()) {
      of_input.pocket = static_cast<long>(columns.design.size());
      for (std::uint32_t j = 0; j < pocket_count(study); ++j)
        columns.design.push_back({Purpose::pocket, stream_address(input.key), j});
    }
    columns.of_input.push_back(of_input);
  }
  return columns;
}

/// Of redraws: independent, and each with a lot of its own.
DesignSpec redraw_spec(DesignSpec spec) {
  spec.kind = DesignKind::random;
  spec.cages_per_lot = 1;
  spec.rows = (kMostRedraws + 1) * kRedraw;
  return spec;
}

DesignSpec spec_of(const Study& study, const SampleColumns& columns) {
  DesignSpec spec;
  spec.kind = study.design;
  spec.seed = static_cast<std::uint64_t>(study.seed);
  spec.columns = columns.design;
  spec.cages_per_lot = static_cast<std::uint64_t>(study.cages_per_lot);
  spec.rows = static_cast<std::uint64_t>(study.samples);
  return spec;
}

std::string quoted_design(const Study& study) {
  return std::string("\"") + design_name(study.design) + "\"";
}

// Refusals of the distributions room name no file; the study's key is what the user can change.
template <class Make>
auto refused_as_input(const std::string& key, const std::string& value, const Make& make) {
  try {
    return make();
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    const auto cut = text.find("; ");
    throw InputError({}, key, value, text.substr(0, cut),
                     cut == std::string::npos ? "change the study's design" : text.substr(cut + 2));
  }
}

GaussianCopula make_copula(const Study& study, const SampleColumns& columns) {
  std::vector<CorrelatedPair> pairs;
  for (const auto& correlation : study.correlations) {
    const auto first = find_input_scope(study.inputs, correlation.first);
    const auto second = find_input_scope(study.inputs, correlation.second);
    const auto i = static_cast<std::size_t>(first.input),
               k = static_cast<std::size_t>(second.input);
    const auto& a = study.inputs[i];
    const auto& b = study.inputs[k];
    const auto column = [&](std::size_t input) {
      return first.pocket ? columns.of_input[input].pocket : columns.of_input[input].lot;
    };
    if (column(i) < 0 || column(k) < 0) continue;  // a plain number depends on nothing
    const double rho = refused_as_input("correlation.rho", number_text(correlation.rho), [&] {
      return first.pocket ? normal_correlation(*a.pocket, *b.pocket, correlation.rho)
                          : normal_correlation(*a.lot, *b.lot, correlation.rho);
    });
    const std::size_t draws = first.pocket ? pocket_count(study) : 1;
    for (std::size_t j = 0; j < draws; ++j)
      pairs.push_back(
          {static_cast<std::size_t>(column(i)) + j, static_cast<std::size_t>(column(k)) + j, rho});
  }
  return refused_as_input("correlation", "",
                          [&] { return GaussianCopula(columns.design.size(), pairs); });
}

double into_range(const KeyRange& range, double value) {
  const double lowest = range.open_minimum
                            ? std::nextafter(range.minimum, std::numeric_limits<double>::infinity())
                            : range.minimum;
  return std::clamp(value, lowest, range.maximum);
}

}  // namespace

struct Sampler::Implementation {
  Study study;
  SampleColumns columns;
  Design design, redraws;
  GaussianCopula copula;
  std::vector<const Key<Scene>*> keys;                  ///< of the inputs
  std::vector<std::vector<std::vector<double>>> cages;  ///< of inputs that draw measured ones
  std::vector<long> dimension;  ///< position of an input among the tolerance dimensions, or -1

  explicit Implementation(const Study& given)
      : study(given),
        columns(make_columns(study)),
        design(refused_as_input("design", quoted_design(study),
                                [&] { return Design(spec_of(study, columns)); })),
        redraws(redraw_spec(design.spec())),
        copula(make_copula(study, columns)) {
    study.resolved_toml.clear();
    study.resolved_json.clear();
    for (const auto& input : study.inputs) {
      keys.push_back(find_key(scene_keys(), input.key));
      cages.emplace_back();
      if (input.draws_cages()) cages.back() = input.measured->by_cage();
      const auto& dimensions = study.tolerance.dimensions;
      const auto found = std::find_if(dimensions.begin(), dimensions.end(),
                                      [&](const auto& d) { return d.key == input.key; });
      dimension.push_back(found == dimensions.end() ? -1 : found - dimensions.begin());
    }
  }

  double noise(const UncertainInput& input, const Sample& sample) const {
    return quantile(*input.noise, uniform(design.spec().seed, Purpose::noise, sample.id,
                                          stream_address(input.key), 0));
  }

  /// Deviations of the pockets of a sample's measured cage.
  std::vector<double> measured_cage(std::size_t i, const std::vector<double>& u,
                                    const Sample& sample) const {
    const long column = columns.of_input[i].lot;
    return cage_at(cages[i],
                   study.measured_in_turn ? static_cast<double>(sample.lot)
                   : column < 0
                       ? 0
                       : static_cast<double>(cages[i].size()) * u[static_cast<std::size_t>(column)],
                   pocket_count(study));
  }

  DrawnInput drawn(std::size_t i, const std::vector<double>& u, const Sample& sample) const {
    const auto& input = study.inputs[i];
    const auto& of_input = columns.of_input[i];
    const Candidate* candidate =
        dimension[i] < 0 ? nullptr : &study.candidates[static_cast<std::size_t>(sample.candidate)];
    const auto d = static_cast<std::size_t>(std::max(dimension[i], 0L));
    const double scale = candidate ? candidate->scales[d] : 1;
    const double lot_scale = study.scale_lots ? scale : 1;
    // The centre moves the lot, or every pocket where there is no lot.
    const double shift = candidate ? candidate->shift(d) : 0;
    const auto deviation = [&](double by, const Law& law, long column, std::size_t draw) {
      return by * (column < 0 ? quantile(law, 0.5)
                              : quantile(law, u[static_cast<std::size_t>(column) + draw]));
    };
    DrawnInput drawn;
    drawn.value = input.nominal;
    if (input.per_pocket) drawn.value.resize(pocket_count(study), input.nominal[0]);
    if (input.draws_cages()) {
      drawn.pocket = measured_cage(i, u, sample);
      const double shared = mean(Empirical{drawn.pocket});
      drawn.lot = {lot_scale * shared + shift};
      for (double& pocket : drawn.pocket) pocket = scale * (pocket - shared);
    } else {
      if (input.lot) drawn.lot = {deviation(lot_scale, *input.lot, of_input.lot, 0) + shift};
      if (input.pocket)
        for (std::size_t j = 0; j < pocket_count(study); ++j)
          drawn.pocket.push_back(deviation(scale, *input.pocket, of_input.pocket, j) +
                                 (input.lot ? 0 : shift));
    }
    if (input.noise) drawn.noise = {noise(input, sample)};
    for (std::size_t j = 0; j < drawn.value.size(); ++j) {
      double& value = drawn.value[j];
      if (input.lot) value += drawn.lot[0];
      if (input.pocket) value += drawn.pocket[j];
      if (input.noise) value += drawn.noise[0];
      value = into_range(keys[i]->range, value);
    }
    return drawn;
  }

  void draw_deviations(std::uint64_t id, std::uint64_t redraw, Sample& sample) const {
    sample.id = id;
    sample.row = id % design.rows();
    sample.replicate = id / design.rows();
    const std::uint64_t redrawn = sample.row + redraw * kRedraw;
    sample.lot = redraw == 0 ? design.lot_of(sample.row) : redrawn;
    for (const auto& measured : cages)
      if (study.measured_in_turn && !measured.empty()) sample.lot = sample.row % measured.size();
    if (!study.candidates.empty())
      sample.candidate = static_cast<long>(sample.row % study.candidates.size());
    std::vector<double> u(design.dimensions());
    if (redraw == 0)
      design.point(sample.row, u);
    else
      redraws.point(redrawn, u);
    copula.correlate(u);
    sample.inputs.clear();
    for (std::size_t i = 0; i < study.inputs.size(); ++i)
      sample.inputs.push_back(drawn(i, u, sample));
  }

  Sample cage(std::uint64_t id, std::uint64_t redraw) const {
    Sample sample;
    draw_deviations(id, redraw, sample);
    sample.scene = study.scene;
    for (std::size_t i = 0; i < study.inputs.size(); ++i)
      set_key_numbers(*keys[i], sample.inputs[i].value, sample.scene);
    return sample;
  }
};

Sampler::Sampler(const Study& study)
    : implementation_(std::make_shared<const Implementation>(study)) {}

const Design& Sampler::design() const {
  return implementation_->design;
}

void Sampler::draw_deviations(std::uint64_t id, Sample& sample) const {
  implementation_->draw_deviations(id, 0, sample);
}

Sample Sampler::draw(std::uint64_t id) const {
  const auto& own = *implementation_;
  if (!own.study.redraw_jams) return own.cage(id, 0);
  // Repetitions of a row are of one cage.
  const std::uint64_t row = id % own.design.rows();
  for (std::uint64_t redraw = 0;; ++redraw) {
    Sample first = own.cage(row, redraw);
    if (redraw == kMostRedraws || cage_fits(own.study, first.scene))
      return id == row ? first : own.cage(id, redraw);
  }
}

Sample draw_sample(const Study& study, std::uint64_t id) {
  return Sampler(study).draw(id);
}

std::size_t design_columns(const Study& study) {
  return make_columns(study).design.size();
}

}  // namespace cagetol
