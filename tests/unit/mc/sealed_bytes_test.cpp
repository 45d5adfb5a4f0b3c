#include "mc/host/sealed_bytes.hpp"

#include <gtest/gtest.h>

namespace cagetol {
namespace {

const std::string kHead = "a table\nof this build\n";
const std::string kContent("numbers\0and more of them", 24);

SealedState state_of(const std::string& bytes) {
  return unsealed_bytes(bytes, kHead).state;
}

TEST(SealedBytes, ContentComesBackUnderItsOwnHead) {
  const std::string sealed = sealed_bytes(kHead, kContent);
  const Unsealed found = unsealed_bytes(sealed, kHead);
  EXPECT_EQ(found.state, SealedState::whole);
  EXPECT_EQ(found.content, kContent);
  EXPECT_EQ(unsealed_bytes(sealed_bytes("", ""), "").state, SealedState::whole);
}

TEST(SealedBytes, AnotherHeadIsNoDamage) {
  for (const std::string other :
       {"", "a table\nof that build\n", "a table\nof this build\nnumbers"})
    EXPECT_EQ(unsealed_bytes(sealed_bytes(kHead, kContent), other).state, SealedState::other_head);
}

TEST(SealedBytes, EveryFlippedBitIsFound) {
  std::string sealed = sealed_bytes(kHead, kContent);
  for (std::size_t bit = 0; bit < 8 * sealed.size(); ++bit) {
    sealed[bit / 8] ^= static_cast<char>(1 << bit % 8);
    EXPECT_EQ(state_of(sealed), SealedState::damaged) << bit;
    sealed[bit / 8] ^= static_cast<char>(1 << bit % 8);
  }
  EXPECT_EQ(state_of(sealed), SealedState::whole);
}

TEST(SealedBytes, EveryOtherLengthIsFound) {
  const std::string sealed = sealed_bytes(kHead, kContent);
  for (std::size_t size = 0; size < sealed.size(); ++size)
    EXPECT_EQ(state_of(sealed.substr(0, size)), SealedState::damaged) << size;
  for (const std::string& more : {std::string(1, '\0'), std::string("x"), sealed})
    EXPECT_EQ(state_of(sealed + more), SealedState::damaged);
}

TEST(SealedBytes, LengthsThatOverflowAreFound) {
  std::string sealed = sealed_bytes(kHead, kContent);
  for (std::size_t byte = 8; byte < 24; ++byte) sealed[byte] = '\xff';
  EXPECT_EQ(state_of(sealed), SealedState::damaged);
}

}  // namespace
}  // namespace cagetol
