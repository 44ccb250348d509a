#pragma once

#include <mutex>
#include <string>
#include <vector>

namespace throng::render::gl {

/// What the driver complained about (KHR_debug, severities above notification), in order. A message in it is a failure
/// in tests. Filled on whichever thread the driver calls from.
class MessageLog {
 public:
  /// Beyond this many, messages are counted and not kept.
  static constexpr std::size_t kept_messages = 64;

  void add(std::string message);
  std::vector<std::string> messages() const;
  std::size_t count() const;
  void clear();

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> messages_;
  std::size_t count_ = 0;
};

/// Routes KHR_debug messages of the current context into `log`, synchronously, until the context is gone.
void collect_messages(MessageLog& log);

}  // namespace throng::render::gl
