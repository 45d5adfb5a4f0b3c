// Compiled for any x86-64 (mc/CMakeLists.txt), and with C functions alone, whose code comes from
// the system's libraries: a template of the C++ library could be the copy that another file
// compiled for a newer processor.
#include "mc/host/processor.hpp"

#include <unistd.h>

#include <cstring>

#include "mc/study_file/exit_code.hpp"

#if defined(__x86_64__) && defined(__GLIBC__)
#ifdef __clang__
#define _Bool bool  // which it knows in C alone
#endif
#include <sys/platform/x86.h>

namespace {

struct Feature {
  bool there;
  const char* name;
};

void print(const char* text) {
  if (::write(STDERR_FILENO, text, std::strlen(text)) < 0) return;
}

// Before the constructors of the program's globals, which may be vectorised like any code. What the
// C library calls active, the operating system supports as well.
[[gnu::constructor(101)]] void check_processor() {
#define FEATURE(name) \
  { CPU_FEATURE_ACTIVE(name), " " #name }
  // Levels 3 and, from AVX512F on, 4 of x86-64.
  const Feature features[] = {FEATURE(AVX2),     FEATURE(FMA),      FEATURE(BMI2),
                              FEATURE(F16C),     FEATURE(AVX512F),  FEATURE(AVX512CD),
                              FEATURE(AVX512BW), FEATURE(AVX512DQ), FEATURE(AVX512VL)};
  bool fits = true;
  for (const Feature& feature : features) {
    const bool needed = &feature < features + 4 || cagetol_needs_avx512;
    if (!needed || feature.there) continue;
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
