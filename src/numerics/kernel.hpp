// Marks what others call of a kernel: all else that its source has is its own (src/room.cmake).
// Forgotten, the program does not link.
#pragma once

#ifdef __clang__
#define CAGETOL_KERNEL
#else
#define CAGETOL_KERNEL [[gnu::externally_visible]]
#endif
