#pragma once

#include <string>

#include "app/show/camera/input.h"

struct ImGuiIO;

namespace throng::app {

/// The clipboard, with the text that ImGui reads after it was asked for.
struct ClipboardText {
  Clipboard clipboard;
  std::string last;
};

/// Tells ImGui that feed() has its keys, and to use the clipboard, which must outlive it.
void connect(ImGuiIO& io, ClipboardText& clipboard);

/// Gives ImGui the mouse and the keyboard of a frame.
void feed(ImGuiIO& io, const InputFrame& input);

}  // namespace throng::app
