#include "mc/host/processor.hpp"

namespace {
using namespace cagetol;
constexpr unsigned needs = 0
#ifdef __SSE4_2__
                           | kSse42
#endif
#ifdef __POPCNT__
                           | kPopcnt
#endif
#ifdef __AVX__
                           | kAvx
#endif
#ifdef __AVX2__
                           | kAvx2
#endif
#ifdef __FMA__
                           | kFma
#endif
#ifdef __BMI2__
                           | kBmi2
#endif
#ifdef __F16C__
                           | kF16c
#endif
#if defined(__AVX512F__) || defined(__AVX512CD__) || defined(__AVX512BW__) || \
    defined(__AVX512DQ__) || defined(__AVX512VL__)
                           | kAvx512
#endif
#ifdef __AVX512VBMI2__
                           | kAvx512Vbmi2
#endif
#ifdef __AVX512VNNI__
                           | kAvx512Vnni
#endif
#ifdef __AVX512BF16__
                           | kAvx512Bf16
#endif
#ifdef __AVX512FP16__
                           | kAvx512Fp16
#endif
#ifdef __AVXVNNI__
                           | kAvxVnni
#endif
#ifdef __GFNI__
                           | kGfni
#endif
#ifdef __VAES__
                           | kVaes
#endif
    ;
}  // namespace

const unsigned cagetol_processor_needs = needs;
