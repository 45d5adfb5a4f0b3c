// The vector that SUNDIALS computes with: its serial vector with operations compiled by us. Debian
// builds SUNDIALS without optimisation; its own operations cost ten times more than a step
// deserves.
#pragma once

#include <nvector/nvector_serial.h>

namespace cagetol {

/// A serial vector of `size` numbers, not initialised. Clones inherit its operations; destroy it
/// with N_VDestroy. Sums are taken in a fixed order: same input, same bits.
N_Vector make_state_vector(int size, SUNContext context);

}  // namespace cagetol
