#include "app/overlay/imgui_input.h"

#include <array>
#include <cfloat>
#include <cstddef>
#include <utility>

#include <imgui.h>

namespace throng::app {
namespace {

/// Maps our keys to those of ImGui that its text fields use.
constexpr std::array edit_keys = std::to_array<std::pair<int, Key>>({{ImGuiKey_LeftArrow, Key::left},
                                                                     {ImGuiKey_RightArrow, Key::right},
                                                                     {ImGuiKey_UpArrow, Key::up},
                                                                     {ImGuiKey_DownArrow, Key::down},
                                                                     {ImGuiKey_PageUp, Key::page_up},
                                                                     {ImGuiKey_PageDown, Key::page_down},
                                                                     {ImGuiKey_Home, Key::home},
                                                                     {ImGuiKey_End, Key::end},
                                                                     {ImGuiKey_Insert, Key::insert},
                                                                     {ImGuiKey_Delete, Key::del},
                                                                     {ImGuiKey_Backspace, Key::backspace},
                                                                     {ImGuiKey_Space, Key::space},
                                                                     {ImGuiKey_Enter, Key::enter},
                                                                     {ImGuiKey_Escape, Key::escape},
                                                                     {ImGuiKey_KeyPadEnter, Key::keypad_enter},
                                                                     {ImGuiKey_A, Key::a},
                                                                     {ImGuiKey_C, Key::c},
                                                                     {ImGuiKey_V, Key::v},
                                                                     {ImGuiKey_X, Key::x},
                                                                     {ImGuiKey_Y, Key::y},
                                                                     {ImGuiKey_Z, Key::z}});

const char* read_clipboard(void* user) {
  auto& text = *static_cast<ClipboardText*>(user);
  if (text.clipboard.get) text.last = text.clipboard.get();
  return text.last.c_str();
}

void write_clipboard(void* user, const char* words) {
  auto& text = *static_cast<ClipboardText*>(user);
  text.last = words;
  if (text.clipboard.set) text.clipboard.set(text.last);
}

}  // namespace

void connect(ImGuiIO& io, ClipboardText& clipboard) {
  io.ClipboardUserData = &clipboard;
  io.GetClipboardTextFn = read_clipboard;
  io.SetClipboardTextFn = write_clipboard;
  for (const auto& [theirs, ours] : edit_keys) io.KeyMap[theirs] = static_cast<int>(ours);
}

void feed(ImGuiIO& io, const InputFrame& input) {
  io.MousePos = input.pointer_x < 0 ? ImVec2(-FLT_MAX, -FLT_MAX) : ImVec2(input.pointer_x, input.pointer_y);
  for (std::size_t i = 0; i < input.buttons_down.size(); ++i) io.MouseDown[i] = input.buttons_down[i];
  io.MouseWheel = input.wheel;
  for (std::size_t i = 0; i < input.keys_down.size(); ++i) io.KeysDown[i] = input.keys_down[i];
  io.KeyCtrl = input.down(Key::control);
  io.KeyShift = input.down(Key::shift);
  io.KeyAlt = input.down(Key::alt);
  io.KeySuper = input.down(Key::super);
  for (const char32_t character : input.characters) io.AddInputCharacter(character);
}

}  // namespace throng::app
