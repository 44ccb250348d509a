#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/tracks/live/live_tracks.h"
#include "engine/tracks/track_clock.h"
#include "engine/tracks/trajectories.h"

namespace throng {

/// Says what a frame changes of a live crowd.
struct LiveStep {
  TrackClock clock;                          ///< before the frame, which moves it by the seconds that it takes
  double settled = 0.0;                      ///< poses shown up to this time stay
  std::span<const std::uint32_t> changed{};  ///< places that have other rows than before, until the next step
};

/// Returns seconds of the rows' clock that pass in a second, for a clock that lags `behind` seconds more than `delay`,
/// below 0 if less. Rows come every `row_seconds`, `delay` seconds before they are shown.
double live_rate(double behind, double row_seconds, double delay, bool catches_up);

/// A crowd whose rows still come. It has a fixed number of places. A new person takes a free one, and leaves it once
/// the clock is past the person's last row. The clock runs behind the newest row by two rows, at least half a second,
/// so that ways and steps are as from a file: the next rows are known. Rows of the last seconds are kept.
class LiveCrowd {
 public:
  /// Says what the clock goes by. A run without a window waits for its rows and goes on at its own rate. A window shows
  /// the rows that are there: it goes slower where rows fail to come, and faster where it is late.
  enum class Pace : std::uint8_t { of_the_run, of_the_rows };

  static constexpr int usual_places = 1000;
  static constexpr double kept_seconds = 10.0;

  /// `tracks` have a head. `plan` is about its origin.
  LiveCrowd(std::unique_ptr<LiveTracks> tracks, std::size_t places, GroundPlan plan, Pace pace);

  /// Returns the people in their places. They change in advance() alone.
  std::shared_ptr<const Trajectories> trajectories() const { return all_; }

  /// Returns whether the rows are there that a frame of `seconds` shows. Waits for more at most `most`.
  bool can_go_on(double seconds, std::chrono::milliseconds most);
  /// Waits for more rows, at most `most`.
  void wait(std::chrono::milliseconds most) const { tracks_->wait(most); }
  /// Takes the rows that came, and moves the clock on by a frame. Allocates only what new rows need.
  LiveStep advance(double seconds);

  double seconds() const { return seconds_; }  ///< of the rows' clock
  /// Returns whether the input has ended and its last row is shown.
  bool has_ended() const { return has_read_all_ && next_ == waiting_.size() && seconds_ >= newest_; }
  /// Returns the fault of the input: what ended it, or that most of its rows came too late to be shown.
  Status status() const;
  /// Returns sentences on what people would not expect.
  std::vector<std::string> remarks() const;
  /// Returns a number that is another one whenever remarks() is.
  std::size_t news() const;

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFF;

  void fetch();
  double delay() const;
  double rate(double seconds);
  void let_stand(double seconds, bool goes_on);
  void free_places();
  void hand_out(double until);
  void take(const LiveRow& row);
  std::uint32_t free_place(std::uint32_t before);
  void begin_track(std::uint32_t place, const LiveRow& row);
  void go_on(std::vector<TrackRow>& rows, const TrackRow& row);
  void forget_old_rows(std::vector<TrackRow>& rows) const;
  void mark(std::uint32_t place);

  std::unique_ptr<LiveTracks> tracks_;
  std::shared_ptr<Trajectories> all_;
  Pace pace_;
  std::vector<LiveRow> waiting_;  // rows from next_ on are not handed out yet
  std::size_t next_ = 0;
  bool has_read_all_ = false, has_begun_ = false;
  double seconds_ = 0.0, newest_ = 0.0, newest_before_ = 0.0;
  double row_seconds_ = 0.0;  // between two rows of a person; 0: not known yet
  float stands_ = 0.0F;
  double input_rate_ = 1.0;                 // seconds of rows that came in a second, lately
  std::vector<double> last_seconds_;        // [person] of the newest row that came, until row_seconds_ is known
  std::vector<std::uint32_t> place_of_;     // [person] also of people who are gone
  std::vector<std::uint32_t> person_at_;    // [place]
  std::deque<std::uint32_t> free_;          // the place that is free for longest is taken first
  std::vector<std::uint32_t> changed_;      // places
  std::vector<std::uint8_t> is_changed_;    // [place]
  std::vector<std::uint8_t> had_no_place_;  // [person]
  std::size_t without_place_ = 0, late_rows_ = 0;
};

}  // namespace throng
