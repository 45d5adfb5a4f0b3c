// Compiled for any x86-64 (mc/CMakeLists.txt), and with C functions alone, whose code comes from
// the system's libraries: a template of the C++ library could be the copy that another file
// compiled for a newer processor.
#include "mc/host/processor.hpp"

#include <unistd.h>

#include <cstring>

#include "mc/study_file/exit_code.hpp"

#if defined(__x86_64__) && defined(__GLIBC__)
#include <sys/platform/x86.h>

namespace {

using namespace cagetol;

struct Feature {
  unsigned bit;
  bool there;
  const char* name;
};

void print(const char* text) {
  if (::write(STDERR_FILENO, text, std::strlen(text)) < 0) return;
}

// Before the constructors of the program's globals, which may be vectorised like any code. What the
// C library calls active, the operating system supports as well.
[[gnu::constructor(101)]] void check_processor() {
  const bool avx512 = CPU_FEATURE_ACTIVE(AVX512F) && CPU_FEATURE_ACTIVE(AVX512CD) &&
                      CPU_FEATURE_ACTIVE(AVX512BW) && CPU_FEATURE_ACTIVE(AVX512DQ) &&
                      CPU_FEATURE_ACTIVE(AVX512VL);
  const Feature features[] = {
      {kSse42, CPU_FEATURE_ACTIVE(SSE4_2), " SSE4.2"},
      {kPopcnt, CPU_FEATURE_ACTIVE(POPCNT), " POPCNT"},
      {kAvx, CPU_FEATURE_ACTIVE(AVX), " AVX"},
      {kAvx2, CPU_FEATURE_ACTIVE(AVX2), " AVX2"},
      {kFma, CPU_FEATURE_ACTIVE(FMA), " FMA"},
      {kBmi2, CPU_FEATURE_ACTIVE(BMI2), " BMI2"},
      {kF16c, CPU_FEATURE_ACTIVE(F16C), " F16C"},
      {kAvx512, avx512, " AVX-512"},
      {kAvx512Vbmi2, CPU_FEATURE_ACTIVE(AVX512_VBMI2), " AVX-512-VBMI2"},
      {kAvx512Vnni, CPU_FEATURE_ACTIVE(AVX512_VNNI), " AVX-512-VNNI"},
      {kAvx512Bf16, CPU_FEATURE_ACTIVE(AVX512_BF16), " AVX-512-BF16"},
      {kAvx512Fp16, CPU_FEATURE_ACTIVE(AVX512_FP16), " AVX-512-FP16"},
      {kAvxVnni, CPU_FEATURE_ACTIVE(AVX_VNNI), " AVX-VNNI"},
      {kGfni, CPU_FEATURE_ACTIVE(GFNI), " GFNI"},
      {kVaes, CPU_FEATURE_ACTIVE(VAES), " VAES"},
  };
  bool fits = true;
  for (const Feature& feature : features) {
    if (feature.there || (cagetol_processor_needs & feature.bit) == 0) continue;
    if (fits) print("cagetol: this build is for another processor; this one lacks");
    fits = false;
    print(feature.name);
  }
  if (fits) return;
  print(
      "\n  remedy: build it on this machine, or for any x86-64 with AVX2: cmake -S . -B build "
      "-DCAGETOL_PORTABLE=ON\n");
  ::_exit(cagetol::kBadInput);
}

}  // namespace
#endif
