#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace throng::app {

/// Returns the width of a text of one line.
using TextWidth = std::function<float(std::string_view)>;

/// Returns the beginning of a text that fits into a width, with three dots behind it where something is left out.
std::string cut_to(const TextWidth& width_of, float width, const std::string& text);

/// Breaks a text into lines of at most that width. A line ends at a blank, so that a number or a file name stays whole;
/// a word longer than a line ends behind a slash, or anywhere.
std::string in_lines(const TextWidth& width_of, float width, const std::string& text);

/// Returns where things of that size begin, in their order: as near to the wanted places as none lies over another, and
/// all between `from` and `to`, as long as there is room.
std::vector<float> apart(std::span<const float> wanted, float size, float from, float to);

}  // namespace throng::app
