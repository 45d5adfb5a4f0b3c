#include "mc/host/page_faults.hpp"

#include <malloc.h>
#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

extern char __executable_start, etext;  // the linker's: where the program's code begins and ends

namespace cagetol {
namespace {

constexpr std::size_t kPage = 4096;

/// Gives `advice` of madvise for whole pages within [from, from + size).
void advise(void* from, std::size_t size, int advice) {
  if (std::align(kPage, kPage, from, size)) madvise(from, size - size % kPage, advice);
}

/// Maps pages at once, with `advice` of madvise, and touches each: a virtual machine may have page
/// tables of its own below the system's, which only a touch fills.
void map_pages(void* from, std::size_t size, int advice) {
  advise(from, size, advice);
  const volatile char* const bytes = static_cast<const char*>(from);
  for (std::size_t k = 0; k < size; k += kPage) static_cast<void>(bytes[k]);
}

void map_heap() {
  constexpr std::size_t size = 16 << 20;
  // HDF5, which faults where it lacks memory, takes this much for itself.
  ::operator delete(::operator new(size / 16));
  if (void* const memory = std::malloc(size)) {
    advise(memory, size, MADV_HUGEPAGE);
    map_pages(memory, size, MADV_POPULATE_WRITE);
    std::free(memory);
  }
}

void map_code() {
  map_pages(&__executable_start, static_cast<std::size_t>(&etext - &__executable_start),
            MADV_POPULATE_READ);
}

[[gnu::noinline]] void map_stack() {
  volatile char room[128 << 10];
  for (std::size_t k = 0; k < sizeof room; k += 1024) room[k] = 0;
}

void keep_freed_memory() {
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 256 << 20);
}

}  // namespace

void avoid_page_faults() {
  keep_freed_memory();
  map_heap();
  map_code();
  map_stack();
}

}  // namespace cagetol
