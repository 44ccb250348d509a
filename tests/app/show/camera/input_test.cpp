#include "app/show/camera/input.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::app::input_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

InputEvent key(Key which, bool down) { return {.kind = InputEvent::Kind::key, .key = which, .down = down}; }
InputEvent button(bool down) { return {.kind = InputEvent::Kind::button, .down = down}; }
InputEvent pointer(float x, float y) { return {.kind = InputEvent::Kind::pointer, .x = x, .y = y}; }

TEST(InputQueue, AKeyShorterThanAFrameIsHeldForOne) {
  InputQueue queue;
  queue.push(key(Key::space, true));
  queue.push(key(Key::space, false));
  const InputFrame first = queue.next_frame();
  EXPECT_TRUE(first.down(Key::space));
  EXPECT_THAT(first.pressed, ElementsAre(Key::space));
  const InputFrame second = queue.next_frame();
  EXPECT_FALSE(second.down(Key::space));
  EXPECT_THAT(second.pressed, IsEmpty());
}

TEST(InputQueue, TwoPressesInAFrameAreTwoPresses) {
  InputQueue queue;
  for (const bool down : {true, false, true, false}) queue.push(key(Key::space, down));
  int presses = 0;
  for (int frame = 0; frame < 4; ++frame) presses += static_cast<int>(queue.next_frame().pressed.size());
  EXPECT_EQ(presses, 2);
}

TEST(InputQueue, DifferentKeysShareAFrame) {
  InputQueue queue;
  queue.push(key(Key::w, true));
  queue.push(key(Key::d, true));
  const InputFrame& frame = queue.next_frame();
  EXPECT_TRUE(frame.down(Key::w) && frame.down(Key::d));
}

TEST(InputQueue, AKeyOfACombinationStaysOneUntilItIsLetGo) {
  InputQueue queue;
  queue.push(key(Key::control, true));
  queue.push(key(Key::s, true));
  EXPECT_FALSE(queue.next_frame().down_alone(Key::s));
  queue.push(key(Key::control, false));
  const InputFrame rest = queue.next_frame();
  EXPECT_TRUE(rest.down(Key::s));
  EXPECT_FALSE(rest.down_alone(Key::s)) << "Ctrl is let go first";
  queue.push(key(Key::s, false));
  queue.next_frame();
  queue.push(key(Key::s, true));
  EXPECT_TRUE(queue.next_frame().down_alone(Key::s));
}

TEST(InputQueue, ACombinationKeepsItsKeysThoughCtrlIsLetGoInTheSameFrame) {
  InputQueue queue;
  queue.push(key(Key::control, true));
  queue.next_frame();
  queue.push(key(Key::s, true));
  queue.push(key(Key::control, false));
  const InputFrame frame = queue.next_frame();
  EXPECT_THAT(frame.pressed, ElementsAre(Key::s));
  EXPECT_TRUE(frame.down(Key::control));
  EXPECT_FALSE(queue.next_frame().down(Key::control));
}

TEST(InputQueue, AClickHappensWhereThePointerWas) {
  InputQueue queue;
  queue.push(pointer(10, 20));
  queue.push(button(true));
  queue.push(pointer(300, 20));
  queue.push(button(false));
  const InputFrame first = queue.next_frame();
  EXPECT_TRUE(first.down(MouseButton::left));
  EXPECT_EQ(first.pointer_x, 10);
  const InputFrame second = queue.next_frame();
  EXPECT_FALSE(second.down(MouseButton::left));
  EXPECT_EQ(second.pointer_x, 300);
}

TEST(InputQueue, MovesAndWheelAddUpWithinAFrameAndStartAnewInTheNext) {
  InputQueue queue;
  queue.push(pointer(10, 10));
  queue.next_frame();
  queue.push(pointer(15, 10));
  queue.push(pointer(18, 4));
  queue.push({.kind = InputEvent::Kind::wheel, .wheel = 1});
  queue.push({.kind = InputEvent::Kind::wheel, .wheel = 2});
  const InputFrame moved = queue.next_frame();
  EXPECT_EQ(moved.moved_x, 8);
  EXPECT_EQ(moved.moved_y, -6);
  EXPECT_EQ(moved.wheel, 3);
  const InputFrame still = queue.next_frame();
  EXPECT_EQ(still.moved_x, 0);
  EXPECT_EQ(still.wheel, 0);
}

TEST(InputQueue, EnteringTheWindowIsNoMove) {
  InputQueue queue;
  queue.push(pointer(640, 360));
  EXPECT_EQ(queue.next_frame().moved_x, 0);
}

TEST(InputQueue, WhoLosesTheFocusHoldsNothing) {
  InputQueue queue;
  queue.push(key(Key::w, true));
  queue.push(button(true));
  queue.next_frame();
  queue.push({.kind = InputEvent::Kind::focus_lost});
  const InputFrame& frame = queue.next_frame();
  EXPECT_TRUE(frame.keys_down.none());
  EXPECT_TRUE(frame.buttons_down.none());
}

TEST(InputQueue, LettersArriveInOrder) {
  InputQueue queue;
  for (const char32_t letter : U"a\u00e9") {
    if (letter != 0) queue.push({.kind = InputEvent::Kind::character, .character = letter});
  }
  EXPECT_EQ(queue.next_frame().characters, U"a\u00e9");
  EXPECT_TRUE(queue.next_frame().characters.empty());
}

}  // namespace
}  // namespace throng::app::input_test
