// These parts of Show are about recorded crowds.
#include <string>
#include <utility>
#include <vector>

#include "app/files/exit_status.h"
#include "app/show/show.h"
#include "app/stage/memory_needs.h"

namespace throng::app {

// A recorded crowd begins where it was asked to.
bool Show::begin_tracks(const DemoOptions& options, StartError& error) {
  const Trajectories* const all = trajectories_of(*stage_).get();
  if (all == nullptr) return true;
  TrackClock clock = track_clock_of(stage_->crowd());
  clock.repeats = options.context == ContextKind::window;
  if (options.trajectories.start) {
    clock.seconds = *options.trajectories.start;
    if (clock.seconds < clock.first || clock.seconds > clock.last) {
      return fail(error, exit_usage,
                  "--start: " + all->file + " has rows from " + std::to_string(clock.first) + " to " +
                      std::to_string(clock.last) + " s of its clock");
    }
  }
  set_track_clock(*stage_, clock);
  return true;
}

anim::Status replace_trajectories(Show& show, std::shared_ptr<const Trajectories> trajectories) {
  if (show.recorder_.is_recording()) {
    return anim::Error{trajectories->file + ": a recording has no recorded crowd; end it with R, then drop the file"};
  }
  Tuning tuning = show.stage_->tuning();
  tuning.scene = Scene::tracks;
  tuning.agents = static_cast<int>(trajectories->persons.size());
  std::vector<CharacterSource> characters(show.stage_->people().begin(), show.stage_->people().end());
  if (anim::Status fits = check_memory(tuning, characters, nullptr); !fits) return fits;
  if (anim::Status exchanged = show.exchange(std::move(characters), tuning, std::move(trajectories)); !exchanged) {
    return exchanged;
  }
  TrackClock clock = track_clock_of(show.stage_->crowd());
  clock.repeats = true;
  set_track_clock(*show.stage_, clock);
  show.camera = show.guide.begin_scene(*show.stage_);
  show.films = true;
  show.update_notice();
  return anim::Done{};
}

}  // namespace throng::app
