#include "app/window/panel/controls/theme.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

#include "app/settings/agent_colors.h"
#include "engine/base/files/input_file.h"

namespace throng::app {
namespace {

constexpr float body_size = 15, small_size = 13, large_size = 22;

/// Latin with its accents, Greek and Cyrillic: bones of real models are named in all of them.
constexpr ImWchar font_letters[] = {0x20, 0x24F, 0x370, 0x4FF, 0x2013, 0x2026, 0};

/// Returns the bytes of a TrueType font, or none: ImGui ends a program that gives it bytes that it cannot read.
std::vector<std::byte> read_font(const std::filesystem::path& file) {
  constexpr std::size_t most_bytes = 16U << 20U;
  constexpr std::array truetype{std::byte{0}, std::byte{1}, std::byte{0}, std::byte{0}};
  auto font = read_file(file, "a font", most_bytes);
  if (!font || font->size() < truetype.size() || !std::equal(truetype.begin(), truetype.end(), font->begin())) {
    return {};
  }
  return std::move(*font);
}

ImFont* add(const std::vector<std::byte>& font, float pixels) {
  ImFontConfig config;
  config.OversampleH = 3;
  config.OversampleV = 2;
  void* const copy = ImGui::MemAlloc(font.size());  // the atlas frees it
  std::memcpy(copy, font.data(), font.size());
  return ImGui::GetIO().Fonts->AddFontFromMemoryTTF(copy, static_cast<int>(font.size()), pixels, &config, font_letters);
}

ImFont* built_in(float scale) {
  ImFontConfig config;
  config.SizePixels = std::floor(13 * scale);
  return ImGui::GetIO().Fonts->AddFontDefault(&config);
}

void load_fonts(const std::filesystem::path& folder, Theme& theme) {
  const auto regular = read_font(folder / "Roboto-Regular.ttf"), strong = read_font(folder / "Roboto-Medium.ttf");
  if (!regular.empty() && !strong.empty()) {
    theme.regular = add(regular, theme.px(body_size));
    theme.strong = add(strong, theme.px(body_size));
    theme.small = add(regular, theme.px(small_size));
    theme.large = add(strong, theme.px(large_size));
    return;
  }
  theme.fonts_missing = true;
  theme.regular = theme.strong = theme.small = theme.large = built_in(theme.scale);
}

void set(ImGuiStyle& style, ImGuiCol which, ImU32 packed) {
  style.Colors[which] = ImGui::ColorConvertU32ToFloat4(packed);
}

void set_colours(ImGuiStyle& style) {
  set(style, ImGuiCol_Text, colour::text);
  set(style, ImGuiCol_TextDisabled, colour::faint);
  set(style, ImGuiCol_WindowBg, colour::panel);
  set(style, ImGuiCol_ChildBg, 0);
  set(style, ImGuiCol_PopupBg, IM_COL32(26, 30, 37, 248));
  set(style, ImGuiCol_Border, colour::panel_edge);
  for (const ImGuiCol title : {ImGuiCol_TitleBg, ImGuiCol_TitleBgActive, ImGuiCol_TitleBgCollapsed}) {
    set(style, title, colour::panel);
  }
  set(style, ImGuiCol_Button, 0);  // fold and close, in the title of a card
  set(style, ImGuiCol_ButtonHovered, colour::well_hovered);
  set(style, ImGuiCol_ButtonActive, colour::accent_soft);
  set(style, ImGuiCol_FrameBg, colour::well);
  set(style, ImGuiCol_FrameBgHovered, colour::well_hovered);
  set(style, ImGuiCol_FrameBgActive, colour::well_hovered);
  set(style, ImGuiCol_ScrollbarBg, colour::well);
  set(style, ImGuiCol_ScrollbarGrab, IM_COL32(255, 255, 255, 70));
  set(style, ImGuiCol_ScrollbarGrabHovered, IM_COL32(255, 255, 255, 110));
  set(style, ImGuiCol_ScrollbarGrabActive, IM_COL32(255, 255, 255, 150));
  set(style, ImGuiCol_Separator, colour::grid);
  set(style, ImGuiCol_TextSelectedBg, colour::accent_soft);
}

void set_shapes(ImGuiStyle& style, float scale) {
  style.WindowPadding = ImVec2(14, 10);
  style.FramePadding = ImVec2(6, 3);
  style.ItemSpacing = ImVec2(8, 6);
  style.WindowRounding = 6;
  style.ChildRounding = 4;
  style.FrameRounding = 4;
  style.PopupRounding = 6;
  style.WindowBorderSize = 0;
  style.PopupBorderSize = 1;
  style.ScrollbarSize = 9;
  style.ScrollbarRounding = 5;
  style.ScaleAllSizes(scale);
}

}  // namespace

ImU32 colour::interval(int frames) { return interval_color(frames) | IM_COL32_A_MASK; }
ImU32 colour::bone_level(int level) { return bone_level_color(level) | IM_COL32_A_MASK; }

ImU32 colour::ink_on(ImU32 ground) {
  constexpr float light = 0.45F;
  const ImVec4 part = ImGui::ColorConvertU32ToFloat4(ground);
  return 0.3F * part.x + 0.59F * part.y + 0.11F * part.z > light ? on_accent : text;
}

ImU32 colour::with_alpha(ImU32 colour, float alpha) {
  const auto scaled = static_cast<ImU32>(alpha * static_cast<float>(colour >> IM_COL32_A_SHIFT));
  return (colour & ~IM_COL32_A_MASK) | (scaled << IM_COL32_A_SHIFT);
}

Theme apply_theme(const std::filesystem::path& fonts, float scale) {
  Theme theme;
  theme.scale = scale;
  load_fonts(fonts, theme);
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  set_colours(style);
  set_shapes(style, scale);
  return theme;
}

}  // namespace throng::app
