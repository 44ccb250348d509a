#include "app/show/report/messages.h"

#include <algorithm>
#include <utility>

namespace throng::app {
namespace {

// A person reads some twenty letters a second, once the message has caught the eye.
constexpr double seconds_at_least = 4, seconds_a_letter = 0.05, seconds_of_fading = 0.5;

double seconds_seen(const Message& message) {
  return seconds_at_least + seconds_a_letter * static_cast<double>(message.words.size());
}

}  // namespace

void Messages::say(std::string words, Message::Kind kind) {
  if (words.empty()) return;
  std::erase_if(messages_, [&](const Message& message) { return message.words == words && presence(message) > 0; });
  messages_.push_back({.words = std::move(words), .kind = kind, .said_at = clock_, .number = ++said_});
  if (messages_.size() > most_messages) messages_.pop_front();
}

bool Messages::report(const Status& outcome, const std::string& done) {
  if (outcome) {
    say(done);
  } else {
    say(outcome.error().message, Message::Kind::refused);
  }
  return static_cast<bool>(outcome);
}

float Messages::presence(const Message& message) const {
  const double left = seconds_seen(message) - age(message);
  return static_cast<float>(std::clamp(left / seconds_of_fading, 0.0, 1.0));
}

}  // namespace throng::app
