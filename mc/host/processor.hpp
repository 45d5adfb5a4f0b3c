// A build is for processors that have all instructions of its compiler flags. On another one it
// would end with SIGILL and no word; this says what is missing, before any other code runs.
#pragma once

namespace cagetol {

/// Bits of what the compiler may use, from its own macros; see processor.cpp for their names.
enum ProcessorFeature : unsigned {
  kSse42 = 1u << 0,
  kPopcnt = 1u << 1,
  kAvx = 1u << 2,
  kAvx2 = 1u << 3,
  kFma = 1u << 4,
  kBmi2 = 1u << 5,
  kF16c = 1u << 6,
  kAvx512 = 1u << 7,  ///< F, CD, BW, DQ and VL
  kAvx512Vbmi2 = 1u << 8,
  kAvx512Vnni = 1u << 9,
  kAvx512Bf16 = 1u << 10,
  kAvx512Fp16 = 1u << 11,
  kAvxVnni = 1u << 12,
  kGfni = 1u << 13,
  kVaes = 1u << 14,
};

}  // namespace cagetol

/// What this program is compiled for (processor_needs.cpp, with the program's flags). Data alone:
/// reading it takes no instruction that a processor may lack.
extern "C" const unsigned cagetol_processor_needs;
