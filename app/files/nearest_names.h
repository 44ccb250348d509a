#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace throng::app {

/// Returns the three of `names` that come nearest to `wanted`, with commas between them. Case does not count.
std::string nearest_names(std::string_view wanted, std::span<const std::string> names);

/// Returns the name that was probably meant: the nearest, with at most one change for every three of its letters;
/// nothing if none is that near.
std::optional<std::string> name_meant(std::string_view wanted, std::span<const std::string> names);

}  // namespace throng::app
