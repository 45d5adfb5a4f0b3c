// The one place where toml++ itself is compiled: header-only it would be compiled again in every
// source, and the packaged library prints numbers with 17 digits. GCC has read and written
// floating-point <charconv> since version 11.
#define TOML_IMPLEMENTATION
#define TOML_FLOAT_CHARCONV 1
#include <toml++/toml.h>
