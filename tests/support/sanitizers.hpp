// Builds of the preset asan-ubsan: their times, instruction counts and memory are not the program's
// own.
#pragma once

namespace cagetol {

#ifdef __SANITIZE_ADDRESS__
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif
/// For GTEST_SKIP.
inline constexpr const char* kNotItsOwnCost =
    "sanitizers cost time, instructions and memory of their own";

}  // namespace cagetol
