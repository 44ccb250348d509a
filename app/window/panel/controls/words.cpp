#include "app/window/panel/controls/words.h"

#include <cctype>
#include <cfloat>
#include <cmath>
#include <string_view>

#include "app/window/panel/controls/text_lines.h"

namespace throng::app {
namespace {

float width_of(ImFont* font, std::string_view text) {
  return font->CalcTextSizeA(font_height(font), FLT_MAX, 0, text.data(), text.data() + text.size()).x;
}

TextWidth measure(ImFont* font) {
  return [font](std::string_view text) { return width_of(font, text); };
}

}  // namespace

std::string capitalised(std::string text) {
  if (!text.empty()) text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

std::string file_name(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

float text_width(ImFont* font, const std::string& text) { return width_of(font, text); }

std::string fitted(ImFont* font, float width, const std::string& text) { return cut_to(measure(font), width, text); }

void draw_text(ImFont* font, ImVec2 at, ImU32 colour, const std::string& text, float align) {
  const float width = align == 0 ? 0 : text_width(font, text);
  const ImVec2 place(std::floor(at.x - align * width), std::floor(at.y));
  ImGui::GetWindowDrawList()->AddText(font, font_height(font), place, ImGui::GetColorU32(colour), text.c_str());
}

std::string wrapped(ImFont* font, float width, const std::string& text) { return in_lines(measure(font), width, text); }

ImVec2 wrapped_size(ImFont* font, float width, const std::string& text) {
  return font->CalcTextSizeA(font_height(font), FLT_MAX, 0, wrapped(font, width, text).c_str());
}

void draw_wrapped(ImFont* font, ImVec2 at, ImU32 colour, float width, const std::string& text) {
  ImGui::GetWindowDrawList()->AddText(font, font_height(font), at, colour, wrapped(font, width, text).c_str());
}

void show_lines(std::initializer_list<std::string> lines) {
  ImGui::BeginTooltip();
  for (const std::string& line : lines) {
    if (!line.empty()) ImGui::TextUnformatted(line.c_str());
  }
  ImGui::EndTooltip();
}

}  // namespace throng::app
