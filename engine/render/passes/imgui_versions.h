#pragma once

#include <bit>
#include <cstdint>

#include <imgui.h>
#include <imgui_internal.h>

/// The differences between the versions of Dear ImGui that systems have, 1.86 to 1.92. Nothing else asks for one.
namespace throng::render::imgui {

#if IMGUI_VERSION_NUM >= 18700

inline constexpr ImGuiKey keypad_enter = ImGuiKey_KeypadEnter;

/// Lets set_key() say which keys are down. All of a frame is known at once, so ImGui spreads nothing over later frames.
inline void set_up_keys(ImGuiIO& io) { io.ConfigInputTrickleEventQueue = false; }

inline void set_key(ImGuiIO& io, ImGuiKey key, bool down) { io.AddKeyEvent(key, down); }

inline void set_modifiers(ImGuiIO& io, bool control, bool shift, bool alt, bool super) {
  io.AddKeyEvent(ImGuiMod_Ctrl, control);
  io.AddKeyEvent(ImGuiMod_Shift, shift);
  io.AddKeyEvent(ImGuiMod_Alt, alt);
  io.AddKeyEvent(ImGuiMod_Super, super);
}

/// Keeps the wheel over the last item from scrolling its window.
inline void take_wheel() { ImGui::SetItemKeyOwner(ImGuiKey_MouseWheelY); }

#else

inline constexpr ImGuiKey keypad_enter = ImGuiKey_KeyPadEnter;

/// Lets set_key() say which keys are down: every key has its own number in the table of keys.
inline void set_up_keys(ImGuiIO& io) {
  for (int key = 0; key < ImGuiKey_COUNT; ++key) io.KeyMap[key] = key;
}

inline void set_key(ImGuiIO& io, ImGuiKey key, bool down) { io.KeysDown[key] = down; }

inline void set_modifiers(ImGuiIO& io, bool control, bool shift, bool alt, bool super) {
  io.KeyCtrl = control;
  io.KeyShift = shift;
  io.KeyAlt = alt;
  io.KeySuper = super;
}

/// Keeps the wheel over the last item from scrolling its window.
inline void take_wheel() { ImGui::SetItemUsingMouseWheel(); }

#endif

/// Gives the keyboard to the next widget.
inline void focus_next_item() {
#if IMGUI_VERSION_NUM >= 19000 && IMGUI_VERSION_NUM < 19020
  ImGuiContext& context = *ImGui::GetCurrentContext();
  context.NavFocusScopeId = context.CurrentFocusScopeId;  // ImGui looks in the scope of the last focus alone
#endif
  ImGui::SetKeyboardFocusHere();
}

/// Returns the inner spacing with which a window has `gap` pixels between its arrow and its title.
inline float spacing_of_title(float gap) {
#if IMGUI_VERSION_NUM >= 19000
  return gap / 2.0F;  // ImGui leaves it twice
#else
  return gap;
#endif
}

/// Returns the height in pixels that a font was loaded with.
inline float font_height(const ImFont* font) {
#if IMGUI_VERSION_NUM >= 19200
  return font->LegacySize;
#else
  return font->FontSize;
#endif
}

/// Sets the font of the next windows and texts. It puts nothing on the stack of fonts, which belongs to a window.
inline void set_font(ImFont* font) {
#if IMGUI_VERSION_NUM >= 19200
  ImGui::SetCurrentFont(font, font_height(font), font_height(font));
#else
  ImGui::SetCurrentFont(font);
#endif
}

/// Sets the font of the next texts, until ImGui::PopFont().
inline void push_font(ImFont* font) {
#if IMGUI_VERSION_NUM >= 19200
  ImGui::PushFont(font, font_height(font));
#else
  ImGui::PushFont(font);
#endif
}

// A texture's id is a pointer in some versions and a number in others.
inline ImTextureID texture_id(std::uintptr_t name) { return std::bit_cast<ImTextureID>(name); }
inline std::uintptr_t texture_name(ImTextureID id) { return std::bit_cast<std::uintptr_t>(id); }

}  // namespace throng::render::imgui
