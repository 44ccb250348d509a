#include "app/window/window_input.h"

#define GLFW_INCLUDE_NONE
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <GLFW/glfw3.h>

namespace throng::app {
namespace {

constexpr std::array known_keys = std::to_array<std::pair<int, Key>>({
    {GLFW_KEY_TAB, Key::tab},
    {GLFW_KEY_LEFT, Key::left},
    {GLFW_KEY_RIGHT, Key::right},
    {GLFW_KEY_UP, Key::up},
    {GLFW_KEY_DOWN, Key::down},
    {GLFW_KEY_PAGE_UP, Key::page_up},
    {GLFW_KEY_PAGE_DOWN, Key::page_down},
    {GLFW_KEY_HOME, Key::home},
    {GLFW_KEY_END, Key::end},
    {GLFW_KEY_INSERT, Key::insert},
    {GLFW_KEY_DELETE, Key::del},
    {GLFW_KEY_BACKSPACE, Key::backspace},
    {GLFW_KEY_SPACE, Key::space},
    {GLFW_KEY_ENTER, Key::enter},
    {GLFW_KEY_ESCAPE, Key::escape},
    {GLFW_KEY_KP_ENTER, Key::keypad_enter},
    {GLFW_KEY_A, Key::a},
    {GLFW_KEY_B, Key::b},
    {GLFW_KEY_C, Key::c},
    {GLFW_KEY_D, Key::d},
    {GLFW_KEY_E, Key::e},
    {GLFW_KEY_F, Key::f},
    {GLFW_KEY_G, Key::g},
    {GLFW_KEY_L, Key::l},
    {GLFW_KEY_O, Key::o},
    {GLFW_KEY_P, Key::p},
    {GLFW_KEY_Q, Key::q},
    {GLFW_KEY_R, Key::r},
    {GLFW_KEY_S, Key::s},
    {GLFW_KEY_V, Key::v},
    {GLFW_KEY_W, Key::w},
    {GLFW_KEY_X, Key::x},
    {GLFW_KEY_Y, Key::y},
    {GLFW_KEY_Z, Key::z},
    {GLFW_KEY_0, Key::digit_0},
    {GLFW_KEY_KP_0, Key::digit_0},
    {GLFW_KEY_EQUAL, Key::plus},
    {GLFW_KEY_KP_ADD, Key::plus},
    {GLFW_KEY_MINUS, Key::minus},
    {GLFW_KEY_KP_SUBTRACT, Key::minus},
    {GLFW_KEY_F1, Key::f1},
    {GLFW_KEY_F5, Key::f5},
    {GLFW_KEY_F6, Key::f6},
    {GLFW_KEY_F11, Key::f11},
    {GLFW_KEY_F12, Key::f12},
    {GLFW_KEY_LEFT_SHIFT, Key::shift},
    {GLFW_KEY_RIGHT_SHIFT, Key::shift},
    {GLFW_KEY_LEFT_CONTROL, Key::control},
    {GLFW_KEY_RIGHT_CONTROL, Key::control},
    {GLFW_KEY_LEFT_ALT, Key::alt},
    {GLFW_KEY_RIGHT_ALT, Key::alt},
    {GLFW_KEY_LEFT_SUPER, Key::super},
    {GLFW_KEY_RIGHT_SUPER, Key::super},
});

std::optional<Key> key_of(int glfw_key) {
  const int digit = glfw_key - GLFW_KEY_1;
  if (digit >= 0 && digit < 9) return static_cast<Key>(static_cast<int>(Key::digit_1) + digit);
  const auto* const found = std::ranges::find(known_keys, glfw_key, &std::pair<int, Key>::first);
  if (found == known_keys.end()) return std::nullopt;
  return found->second;
}

// A window may outlive its input.
void send(GLFWwindow* window, const InputEvent& event) {
  auto* const input = static_cast<WindowInput*>(glfwGetWindowUserPointer(window));
  if (input != nullptr) input->push(event);
}

void on_key(GLFWwindow* window, int glfw_key, int /*scancode*/, int action, int /*modifiers*/) {
  const std::optional<Key> key = key_of(glfw_key);
  if (!key || action == GLFW_REPEAT) return;
  send(window, {.kind = InputEvent::Kind::key, .key = *key, .down = action == GLFW_PRESS});
}

void on_character(GLFWwindow* window, unsigned int code_point) {
  send(window, {.kind = InputEvent::Kind::character, .character = static_cast<char32_t>(code_point)});
}

void on_button(GLFWwindow* window, int button, int action, int /*modifiers*/) {
  if (button >= static_cast<int>(MouseButton::count)) return;
  send(window,
       {.kind = InputEvent::Kind::button, .button = static_cast<MouseButton>(button), .down = action == GLFW_PRESS});
}

/// GLFW speaks of screen coordinates; the overlay and the picture are in pixels of the framebuffer.
void on_pointer(GLFWwindow* window, double x, double y) {
  int window_width = 0, window_height = 0, width = 0, height = 0;
  glfwGetWindowSize(window, &window_width, &window_height);
  glfwGetFramebufferSize(window, &width, &height);
  if (window_width == 0 || window_height == 0) return;
  send(window, {.kind = InputEvent::Kind::pointer,
                .x = static_cast<float>(x * width / window_width),
                .y = static_cast<float>(y * height / window_height)});
}

void on_entered(GLFWwindow* window, int entered) {
  constexpr std::array buttons{GLFW_MOUSE_BUTTON_LEFT, GLFW_MOUSE_BUTTON_RIGHT, GLFW_MOUSE_BUTTON_MIDDLE};
  const bool buttons_held =
      std::ranges::any_of(buttons, [&](int button) { return glfwGetMouseButton(window, button) == GLFW_PRESS; });
  if (entered == GLFW_FALSE && !buttons_held) send(window, {.kind = InputEvent::Kind::pointer, .x = -1, .y = -1});
}

void on_wheel(GLFWwindow* window, double /*sideways*/, double steps) {
  send(window, {.kind = InputEvent::Kind::wheel, .wheel = static_cast<float>(steps)});
}

void on_drop(GLFWwindow* window, int count, const char** paths) {
  for (int i = 0; i < count; ++i) send(window, {.kind = InputEvent::Kind::file, .path = paths[i]});
}

void on_focus(GLFWwindow* window, int focused) {
  if (focused == GLFW_FALSE) send(window, {.kind = InputEvent::Kind::focus_lost});
}

}  // namespace

WindowInput::WindowInput(GLFWwindow* window) : window_(window) {
  glfwSetWindowUserPointer(window, this);
  glfwSetKeyCallback(window, on_key);
  glfwSetCharCallback(window, on_character);
  glfwSetMouseButtonCallback(window, on_button);
  glfwSetCursorPosCallback(window, on_pointer);
  glfwSetCursorEnterCallback(window, on_entered);
  glfwSetScrollCallback(window, on_wheel);
  glfwSetDropCallback(window, on_drop);
  glfwSetWindowFocusCallback(window, on_focus);
}

WindowInput::~WindowInput() { glfwSetWindowUserPointer(window_, nullptr); }

const InputFrame& WindowInput::next_frame() {
  glfwPollEvents();
  return queue_.next_frame();
}

void WindowInput::wait(double seconds) { glfwWaitEventsTimeout(seconds); }

bool WindowInput::is_out_of_sight() const {
  return glfwGetWindowAttrib(window_, GLFW_ICONIFIED) != GLFW_FALSE ||
         glfwGetWindowAttrib(window_, GLFW_VISIBLE) == GLFW_FALSE;
}

bool WindowInput::takes_close() {
  const bool asked = glfwWindowShouldClose(window_) != GLFW_FALSE;
  glfwSetWindowShouldClose(window_, GLFW_FALSE);
  return asked;
}

float WindowInput::content_scale() const {
  float across = 1, along = 1;
  glfwGetWindowContentScale(window_, &across, &along);
  return across;
}

Clipboard WindowInput::clipboard() const {
  GLFWwindow* const window = window_;
  return {.get =
              [window] {
                const char* const text = glfwGetClipboardString(window);
                return std::string(text == nullptr ? "" : text);
              },
          .set = [window](const std::string& text) { glfwSetClipboardString(window, text.c_str()); }};
}

}  // namespace throng::app
