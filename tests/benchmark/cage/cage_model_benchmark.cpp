// The cage of one sample, with and without its stress rows: the table of the default cage, pockets
// scattered.
#include <benchmark/benchmark.h>

#include "src/cage/table/cage_model.hpp"
#include "tests/support/flexible_cage.hpp"

namespace cagetol {
namespace {

void cage_model(benchmark::State& state) {
  static const CageTable table = make_cage_table({}, test::kCageSteel, {});
  const auto deviations = test::scattered_pockets(1);
  for (auto _ : state)
    benchmark::DoNotOptimize(make_cage_model(table, deviations, {.stress = state.range(0) != 0}));
}
BENCHMARK(cage_model)->Arg(0)->Arg(1)->ArgName("stress")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace cagetol

BENCHMARK_MAIN();
