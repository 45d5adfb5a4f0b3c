#include "mc/host/processor.hpp"

#ifdef __AVX512F__
constinit const bool cagetol_needs_avx512 = true;
#else
constinit const bool cagetol_needs_avx512 = false;
#endif
