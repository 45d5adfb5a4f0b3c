// The right-hand side allocates nothing. Counted at malloc itself, which operator new and Eigen
// both end in.
#include <gtest/gtest.h>
#include <atomic>
#include <cstdlib>

#include "src/integration/system.hpp"
#include "src/newton/newton_matrix.hpp"
#include "tests/support/random_bearing.hpp"

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {
std::atomic<long> allocations{0};
}

extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* malloc(std::size_t size) {
  ++allocations;
  return __libc_malloc(size);
}

namespace cagetol {
namespace {

TEST(NoAllocation, TheCounterCounts) {
  const long before = allocations;
  std::vector<double>* const kept = new std::vector<double>(100);
  EXPECT_GE(allocations - before, 2);
  delete kept;
}

TEST(NoAllocation, InRightHandSideDerivativesAndSolution) {
  for (unsigned seed = 0; seed < 24; ++seed) {
    const bool wavy = seed % 3 == 1;
    const RandomBearing b = random_bearing(seed, {.modes = seed % 2 == 0 ? 0 : 5,
                                                  .freedom = static_cast<Freedom>(seed / 2 % 2),
                                                  .wavy = wavy});
    System system(b.model);
    NewtonMatrix newton(b.model);
    std::vector<double> rates(b.y.size());
    long before = allocations;
    evaluate_rates(b.model, b.t, b.y.data(), rates.data());
    EXPECT_EQ(allocations - before, 0) << "rates, seed " << seed;
    before = allocations;
    system.linearise_at(b.t, b.y.data());
    EXPECT_EQ(allocations - before, 0) << "derivatives, seed " << seed;
    ASSERT_TRUE(newton.factor(system.linear, 1e-6));
    before = allocations;
    newton.solve(rates.data(), rates.data());
    EXPECT_EQ(allocations - before, 0) << "solution, seed " << seed;
  }
}

}  // namespace
}  // namespace cagetol

#endif
