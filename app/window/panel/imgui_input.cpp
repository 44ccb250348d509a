#include "app/window/panel/imgui_input.h"

#include <array>
#include <cfloat>
#include <cstddef>
#include <utility>

#include "engine/render/passes/imgui_versions.h"

namespace throng::app {
namespace {

namespace imgui = render::imgui;

/// Maps our keys to the ImGui keys that its text fields and the panel use.
constexpr std::array edit_keys = std::to_array<std::pair<ImGuiKey, Key>>({{ImGuiKey_LeftArrow, Key::left},
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
                                                                          {imgui::keypad_enter, Key::keypad_enter},
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
  imgui::set_up_keys(io);
}

void feed(ImGuiIO& io, const InputFrame& input) {
  io.MousePos = input.pointer_x < 0 ? ImVec2(-FLT_MAX, -FLT_MAX) : ImVec2(input.pointer_x, input.pointer_y);
  for (std::size_t i = 0; i < input.buttons_down.size(); ++i) io.MouseDown[i] = input.buttons_down[i];
  io.MouseWheel = input.wheel;
  for (const auto& [theirs, ours] : edit_keys) imgui::set_key(io, theirs, input.down(ours));
  imgui::set_modifiers(io, input.down(Key::control), input.down(Key::shift), input.down(Key::alt),
                       input.down(Key::super));
  for (const char32_t character : input.characters) io.AddInputCharacter(character);
}

}  // namespace throng::app
