#pragma once

#include <initializer_list>
#include <string>

#include "app/window/panel/controls/theme.h"

namespace throng::app {

/// Returns a text that begins with a capital letter.
std::string capitalised(std::string text);
/// Returns the last part of a path.
std::string file_name(const std::string& path);

float text_width(ImFont* font, const std::string& text);
/// Returns the beginning of a text that fits into a width (text_lines.h).
std::string fitted(ImFont* font, float width, const std::string& text);
/// Draws text with its left, middle (0.5) or right edge (1) at `at`.
void draw_text(ImFont* font, ImVec2 at, ImU32 colour, const std::string& text, float align = 0);

/// Breaks a text into lines of at most that width (text_lines.h).
std::string wrapped(ImFont* font, float width, const std::string& text);
/// Returns the size of text in such lines.
ImVec2 wrapped_size(ImFont* font, float width, const std::string& text);
/// Draws text in such lines with its upper left corner at `at`.
void draw_wrapped(ImFont* font, ImVec2 at, ImU32 colour, float width, const std::string& text);
/// Shows a tooltip at the pointer. Empty lines are left out.
void show_lines(std::initializer_list<std::string> lines);

}  // namespace throng::app
