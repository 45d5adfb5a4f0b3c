#include "mc/host/processor.hpp"

// A macro that the compiler defines is 1, any other its own name.
#define TEXT(macro) #macro
#define NEEDED(name, macro) TEXT(macro)[0] == '1',

constinit const bool cagetol_processor_needs[] = {CAGETOL_PROCESSOR_FEATURES(NEEDED)};
