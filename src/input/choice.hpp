// Closed sets: an enum, and beside it how input files spell each of its values.
//
//   enum class CageKind { rigid, flexible };
//   constexpr auto spellings(CageKind) {
//     using enum CageKind;
//     return std::array{Spelling{rigid, "rigid"}, Spelling{flexible, "flexible"}};
//   }
//
// A key of such a type (key_table.hpp) reads, checks and writes these texts; everything after the
// reader compares values of the enum.
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace cagetol {

/// One value of a closed set, as input files spell it.
template <class E>
struct Spelling {
  E value;
  const char* text;
};
template <class E>  // clang deduces nothing of an aggregate before version 17
Spelling(E, const char*)->Spelling<E>;

/// An enum with spellings(); their order is the one in which choices are listed.
template <class E>
concept Choice = std::is_enum_v<E> && requires {
  spellings(E{});
};

/// The text of a value. Throws std::logic_error for a value without one.
template <Choice E>
constexpr const char* spelled(E value) {
  for (const auto& spelling : spellings(E{}))
    if (spelling.value == value) return spelling.text;
  throw std::logic_error("a value of a closed set has no spelling");
}

/// The value that a text spells. Throws std::logic_error for any other text, which readers refuse
/// before.
template <Choice E>
constexpr E choice_of(std::string_view text) {
  for (const auto& spelling : spellings(E{}))
    if (spelling.text == text) return spelling.value;
  throw std::logic_error("no value of a closed set is spelled '" + std::string(text) + "'");
}

/// All texts, in their order.
template <Choice E>
std::vector<std::string> choice_texts() {
  std::vector<std::string> texts;
  for (const auto& spelling : spellings(E{})) texts.emplace_back(spelling.text);
  return texts;
}

}  // namespace cagetol
