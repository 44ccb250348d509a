// These parts of Show are about recorded crowds.
#include <string>
#include <utility>
#include <vector>

#include "app/files/exit_status.h"
#include "app/show/show.h"
#include "app/show/stage/memory_needs.h"
#include "engine/tracks/file_plan.h"

namespace throng::app {

bool Show::open_live(const DemoOptions& options, std::unique_ptr<LiveTracks> live, StartError& error) {
  GroundPlan plan;
  const std::string& walls = options.trajectories.reading.walls;
  if (!walls.empty()) {
    auto read = read_ground_plan(walls, live->head()->origin);
    if (!read) return fail(error, exit_job_failed, read.error().message);
    plan = std::move(*read);
  }
  const auto pace = options.context == ContextKind::window ? LiveCrowd::Pace::of_the_rows : LiveCrowd::Pace::of_the_run;
  live_ = std::make_unique<LiveCrowd>(std::move(live), static_cast<std::size_t>(options.tuning.agents), std::move(plan),
                                      pace);
  return true;
}

void Show::take_live_rows(anim::Ticks step) {
  stage_->take_live_step(live_->advance(anim::to_seconds(step)));
  if (std::exchange(live_news_, live_->news()) != live_news_) update_notice();
}

bool Show::has_rows_for(anim::Ticks step, std::chrono::milliseconds most) {
  return live_ == nullptr || live_->can_go_on(anim::to_seconds(step), most);
}

bool Show::begin_tracks(const DemoOptions& options, StartError& error) {
  const Trajectories* const all = stage_->trajectories().get();
  if (all == nullptr || all->is_live) return true;
  TrackClock clock = stage_->crowd().tracks()->clock();
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
  stage_->set_track_clock(clock);
  return true;
}

anim::Status Show::replace_trajectories(std::shared_ptr<const Trajectories> trajectories) {
  if (recorder_.is_recording()) {
    return anim::Error{trajectories->file +
                       ": a recording goes on, and cannot hold the crowd of a file; end it with R, then drop the file"};
  }
  Tuning tuning = stage_->tuning();
  tuning.scene = Scene::tracks;
  tuning.agents = static_cast<int>(trajectories->persons.size());
  std::vector<CharacterSource> characters(stage_->people().begin(), stage_->people().end());
  if (anim::Status fits = check_memory(tuning, characters, nullptr); !fits) return fits;
  if (anim::Status exchanged = exchange(std::move(characters), tuning, std::move(trajectories)); !exchanged) {
    return exchanged;
  }
  live_.reset();
  TrackClock clock = stage_->crowd().tracks()->clock();
  clock.repeats = true;
  stage_->set_track_clock(clock);
  camera = guide.begin_scene(*stage_);
  films = true;
  update_notice();
  return anim::Done{};
}

}  // namespace throng::app
