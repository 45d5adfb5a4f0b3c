// The cost of a piece of work that no busy machine changes: instructions executed.
#pragma once

#include <functional>
#include <optional>

namespace cagetol {

/// Instructions that `work` executes, counted one by one in a process of its own (some 20 us each;
/// what `work` changes is not seen here); none where this system does not let a process be traced.
std::optional<long> instructions_of(const std::function<void()>& work);

}  // namespace cagetol
