// The one place where toml++ itself is compiled: header-only it would be compiled again in every
// source, and the packaged library prints numbers with 17 digits. GCC has read and written
// floating-point <charconv> since version 11.
//
// Its parser asserts where some malformed inline tables should be errors: asserting throws, so that
// parse_toml can say so.
#include <stdexcept>

namespace {
[[noreturn]] void refuse(const char* expression) {
  throw std::logic_error(expression);
}
}  // namespace

// Values nested deeper make no input of this program, and each level takes stack.
#define TOML_MAX_NESTED_VALUES 64
#define TOML_IMPLEMENTATION
#define TOML_FLOAT_CHARCONV 1
#define TOML_ASSERT(expr) ((expr) ? void() : refuse(#expr))
#include <toml++/toml.h>
