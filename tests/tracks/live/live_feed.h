#pragma once

#include <memory>
#include <string>
#include <thread>

#include <unistd.h>

#include "engine/tracks/live/live_tracks.h"

namespace throng {

/// A pipe with a text that a LiveTracks reads.
class LiveFeed {
 public:
  LiveFeed() {
    if (pipe(ends_) != 0) ends_[0] = ends_[1] = -1;
  }
  ~LiveFeed() {
    if (sender_.joinable()) sender_.join();
    end();
    if (ends_[0] >= 0) close(ends_[0]);
  }
  LiveFeed(const LiveFeed&) = delete;
  LiveFeed& operator=(const LiveFeed&) = delete;

  /// Writes a text that fits into a pipe.
  void send(const std::string& text) const { write_all(text); }
  void end() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }
  /// Writes a text of any length, and then the end, while somebody reads.
  void send_all(std::string text) {
    sender_ = std::thread([this, text = std::move(text)] { write_all(text), end(); });
  }
  /// Begins to read, and waits for the first row or the end.
  std::unique_ptr<LiveTracks> read(const TrackReading& options = {}) const {
    auto tracks = std::make_unique<LiveTracks>(ends_[0], options);
    while (!tracks->head() && !tracks->has_ended()) tracks->wait(std::chrono::milliseconds(100));
    return tracks;
  }

 private:
  void write_all(const std::string& text) const {
    for (std::size_t at = 0; at < text.size();) {
      const ssize_t count = write(ends_[1], text.data() + at, text.size() - at);
      if (count <= 0) return;
      at += static_cast<std::size_t>(count);
    }
  }

  int ends_[2] = {-1, -1};
  std::thread sender_;
};

}  // namespace throng
