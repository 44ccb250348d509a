#pragma once

// The headers of the standard library that public headers use. They are read without the macros min and max,
// which headers of Windows define, and which stand again afterwards.
#pragma push_macro("max")
#pragma push_macro("min")
#undef max
#undef min

#include <array>
#include <cassert>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#pragma pop_macro("min")
#pragma pop_macro("max")
