#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>

#include "engine/base/result.h"

namespace throng::app {

/// A message that a person was told: that something was done, or why it was not.
struct Message {
  enum class Kind : std::uint8_t { done, refused };

  std::string words;
  Kind kind = Kind::done;
  double said_at = 0;        ///< seconds of the window's clock
  std::uint64_t number = 0;  ///< no other message has it
};

/// The messages of a window. Each is seen for some seconds, the longer the more words it has, and then fades; the
/// newest most_messages are kept to be looked up.
class Messages {
 public:
  static constexpr std::size_t most_messages = 200;

  /// Says something. A message that is still seen and has the same words appears again in its place.
  void say(std::string words, Message::Kind kind = Message::Kind::done);
  /// Says `done`, if it has words, where the outcome is a success; else says why it failed. Returns whether it is one.
  bool report(const Status& outcome, const std::string& done = {});
  /// Lets the window's clock go on.
  void pass(double seconds) { clock_ += seconds; }
  [[nodiscard]] double now() const { return clock_; }

  /// Returns how much is left of a message on the screen: 1 at first, less while it fades, then 0.
  [[nodiscard]] float presence(const Message& message) const;
  /// Returns the seconds since a message was said.
  [[nodiscard]] double age(const Message& message) const { return clock_ - message.said_at; }

  /// Returns the messages that are kept, the oldest first.
  [[nodiscard]] const std::deque<Message>& all() const { return messages_; }

 private:
  std::deque<Message> messages_;
  double clock_ = 0;
  std::uint64_t said_ = 0;
};

}  // namespace throng::app
