// These members of Show set the clock of a recorded crowd.
#include <string>

#include "app/files/exit_status.h"
#include "app/show/show.h"

namespace throng::app {

bool Show::begin_tracks(const DemoOptions& options, StartError& error) {
  const Trajectories* const all = trajectories_of(*stage_).get();
  if (all == nullptr) return true;
  TrackClock clock = track_clock_of(stage_->crowd());
  const TrajectoryOptions& asked = options.trajectories;
  const auto has = [clock](double seconds) { return seconds >= clock.first && seconds <= clock.last; };
  const auto refuse = [&](const std::string& option) {
    return fail(error, exit_usage,
                option + ": " + all->file + " has rows from " + std::to_string(clock.first) + " to " +
                    std::to_string(clock.last) + " s of its clock");
  };
  if (asked.part && !(has(asked.part->first) && has(asked.part->second))) return refuse("--track-part");
  if (asked.start && !has(*asked.start)) return refuse("--start");
  clock.repeats = asked.repeats || options.context == ContextKind::window;
  clock.rate = asked.rate.value_or(1.0);
  if (asked.part) clock = with_part(clock, asked.part->first, asked.part->second);
  if (asked.start && (*asked.start < clock.first || *asked.start > clock.last)) {
    return fail(error, exit_usage, "--start: lies outside of the part that --track-part names");
  }
  clock.seconds = asked.start.value_or(clock.rate < 0.0 ? clock.last : clock.first);
  set_track_clock(*stage_, clock);
  return true;
}

void set_track_clock(Show& show, const TrackClock& clock) {
  const bool is_there = followers_of(show.stage_->crowd()) != nullptr;
  if (is_there && clock != track_clock_of(show.stage_->crowd())) set_track_clock(*show.stage_, clock);
}

}  // namespace throng::app
