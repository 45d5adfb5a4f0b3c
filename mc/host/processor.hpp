// A build is for processors that have all instructions of its compiler flags. On another one it
// would end with SIGILL and no word; this says what is missing, before any other code runs.
#pragma once

/// Whether this program is compiled for AVX-512 (processor_needs.cpp, with the program's flags).
/// Data alone: reading it takes no instruction that a processor may lack.
extern "C" const bool cagetol_needs_avx512;
