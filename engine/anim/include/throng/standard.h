#pragma once

// What the door uses of the standard library. It is read without the macros min and max, which systems define that a
// host may have included before, and which stand again afterwards.
#pragma push_macro("max")
#pragma push_macro("min")
#undef max
#undef min

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#pragma pop_macro("min")
#pragma pop_macro("max")
