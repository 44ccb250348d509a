#pragma once

#include <mutex>
#include <string>
#include <vector>

namespace throng::render::gl {

/// Collects the driver's messages in order (KHR_debug, severities above notification). A test fails if there is one.
/// The driver may call from any thread.
class MessageLog {
 public:
  /// Messages beyond this many are counted and not kept.
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

/// Sends KHR_debug messages of the current context to `log`, synchronously, as long as the context lives.
void collect_messages(MessageLog& log);

}  // namespace throng::render::gl
