#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace throng {

/// A program that reads what we write, found in PATH and started without a shell. Its output is kept. Signals of the
/// terminal do not reach it, so that Ctrl+C lets it finish its work. It is ended with the object. This program
/// ignores SIGPIPE (ignore_signals_of_writers).
class PipedProgram {
 public:
  /// Errors: there is no such program, or the system does not start it; the error says why: "there is none in PATH".
  /// On Windows none is started.
  static Result<PipedProgram> start(const std::vector<std::string>& words);
  PipedProgram(PipedProgram&& other) noexcept;
  PipedProgram& operator=(PipedProgram&&) = delete;
  ~PipedProgram();

  /// Writes all of it, and waits while the program reads more slowly. Returns whether it has read all.
  bool write(std::span<const std::byte> bytes);
  /// Tells the program that there is no more, and waits for its end. Returns its exit status; 128 and more: a signal.
  int finish();
  /// Takes what it has said so far, and waits for nothing. Returns how it ended, as finish() does; nothing while it
  /// runs.
  std::optional<int> look();
  /// Asks it to end, as Ctrl+C does at a terminal.
  void ask_to_end() const;
  /// Lets other programs go before it where they want the same processor.
  void give_way() const;
  /// Returns the text of its output and its errors, no more than the last megabyte.
  const std::string& answer() const { return answer_; }

 private:
  PipedProgram() = default;
  void listen();

  int process_ = -1;  // -1: none that is to be waited for
  int input_ = -1;    // the program reads it
  int output_ = -1;   // the program writes it
  std::string answer_;
};

}  // namespace throng
