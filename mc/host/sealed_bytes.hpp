// Bytes that prove themselves: any flipped bit, cut-off or added byte is found.
//
// "CAGETOLT", length of the head (8 bytes), length of the content (8), head, content, checksum of
// all that (8). CRC-64 (mc/study_file/checksum.hpp) finds every single flipped bit and every
// burst of up to 64 bits; other damage passes it once in 2^64. Numbers are in the machine's own
// byte order.
#pragma once

#include <string>
#include <string_view>

namespace cagetol {

/// `head` says what the content is and for whom: format, key, build.
std::string sealed_bytes(std::string_view head, std::string_view content);

enum class SealedState {
  whole,       ///< the content is what was sealed under this head
  other_head,  ///< sealed under another head
  damaged      ///< not what was sealed
};

struct Unsealed {
  SealedState state = SealedState::damaged;
  std::string_view content;  ///< within the bytes; empty unless whole
};
Unsealed unsealed_bytes(std::string_view bytes, std::string_view head);

}  // namespace cagetol
