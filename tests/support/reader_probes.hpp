// One probe for each reader of the program: bytes in, and the reader either reads them or refuses
// them as it is meant to. Fuzz targets (tests/fuzz) and a short test by day share them.
//
// What is checked by a checksum gets a right one first, lest only the checksum be tested.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cagetol {

/// A reader to be fuzzed. `read` returns whether the bytes were read; a refusal that is not what
/// the reader documents leaves as an exception.
struct ReaderProbe {
  const char* name;
  bool (*read)(std::string_view bytes);
  std::vector<std::string> (*seeds)();  ///< inputs to start from, made of what ships
};
const std::vector<ReaderProbe>& reader_probes();

/// The probe of that name; throws std::out_of_range.
const ReaderProbe& reader_probe(const std::string& name);

}  // namespace cagetol
