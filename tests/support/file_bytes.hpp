// Files as bytes, and bits flipped in them.
#pragma once

#include <fstream>
#include <sstream>
#include <string>

namespace cagetol {

inline std::string file_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline std::string with_flipped_bit(std::string bytes, std::size_t bit) {
  bytes.at(bit / 8) = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
  return bytes;
}

}  // namespace cagetol
