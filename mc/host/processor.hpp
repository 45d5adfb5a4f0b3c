// A build is for processors that have all instructions of its compiler flags. On another one it
// would end with SIGILL and no word; this says what is missing, before any other code runs.
#pragma once

/// What a build may need: FEATURE(name in the C library, the compiler's macro).
#define CAGETOL_PROCESSOR_FEATURES(FEATURE) \
  FEATURE(SSE4_2, __SSE4_2__)               \
  FEATURE(POPCNT, __POPCNT__)               \
  FEATURE(AVX, __AVX__)                     \
  FEATURE(AVX2, __AVX2__)                   \
  FEATURE(FMA, __FMA__)                     \
  FEATURE(BMI2, __BMI2__)                   \
  FEATURE(F16C, __F16C__)                   \
  FEATURE(AVX512F, __AVX512F__)             \
  FEATURE(AVX512CD, __AVX512CD__)           \
  FEATURE(AVX512BW, __AVX512BW__)           \
  FEATURE(AVX512DQ, __AVX512DQ__)           \
  FEATURE(AVX512VL, __AVX512VL__)           \
  FEATURE(AVX512_VBMI2, __AVX512VBMI2__)    \
  FEATURE(AVX512_VNNI, __AVX512VNNI__)      \
  FEATURE(AVX512_BF16, __AVX512BF16__)      \
  FEATURE(AVX512_FP16, __AVX512FP16__)      \
  FEATURE(AVX_VNNI, __AVXVNNI__)            \
  FEATURE(GFNI, __GFNI__)                   \
  FEATURE(VAES, __VAES__)

/// Which of these this program is compiled for (processor_needs.cpp, with the program's flags).
/// Data alone: reading it takes no instruction that a processor may lack.
extern "C" const bool cagetol_processor_needs[];
