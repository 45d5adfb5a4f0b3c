// same_study A.h5 B.h5: exit code 0 where two study files are equal to the bit, timing apart; else
// 1 and what differs. For the scripts of this directory.
#include <cstdio>

#include "tests/support/study_compare.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const auto differences = cagetol::study_file_differences(argv[1], argv[2]);
  for (const std::string& difference : differences)
    std::fprintf(stderr, "%s\n", difference.c_str());
  return differences.empty() ? 0 : 1;
}
