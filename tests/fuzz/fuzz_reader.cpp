// libFuzzer's door to one reader: CAGETOL_READER names its probe. `fuzz_READER --seeds FOLDER`
// writes the inputs to start from.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "tests/support/reader_probes.hpp"

namespace {

const cagetol::ReaderProbe& probe() {
  static const cagetol::ReaderProbe& chosen = cagetol::reader_probe(CAGETOL_READER);
  return chosen;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  if (*count != 3 || std::strcmp((*arguments)[1], "--seeds") != 0) return 0;
  int number = 0;
  for (const std::string& seed : probe().seeds())
    std::ofstream((*arguments)[2] + ("/seed-" + std::to_string(number++)), std::ios::binary)
        << seed;
  std::exit(0);
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  probe().read({reinterpret_cast<const char*>(data), size});
  return 0;
}
