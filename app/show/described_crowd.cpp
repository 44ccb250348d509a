#include "app/show/described_crowd.h"

#include "app/show/camera/fly_camera.h"
#include "app/show/show.h"
#include "app/show/show_view.h"
#include "app/show/stage/stage.h"

namespace throng::app {
namespace {

TrajectoryOptions described_tracks(const Stage& stage) {
  const Trajectories* const all = stage.trajectories().get();
  if (all == nullptr) return {};
  TrajectoryOptions tracks{.file = all->file, .reading = all->reading};
  const auto& clock = stage.track_clock();
  if (all->is_live || !clock) return tracks;
  tracks.start = clock->seconds;
  if (clock->rate != 1.0) tracks.rate = clock->rate;
  if (clock->first != all->first_seconds || clock->last != all->last_seconds) {
    tracks.part.emplace(clock->first, clock->last);
  }
  tracks.repeats = clock->repeats;
  return tracks;
}

void describe_camera(const Show& show, CrowdSetup& setup) {
  const ShowView& view = show.view();
  const bool films = view.films && view.guide.can_film(show.stage());
  setup.camera_name = view.guide.camera_text(show.stage(), films);
  if (!setup.camera_name.empty()) setup.preset.camera.reset();
  if (!films) return;
  setup.camera_path = view.guide.path_text();
  setup.preset.camera = setup.camera_path.empty() || setup.camera_path.ends_with(".csv")
                            ? std::nullopt
                            : std::optional(place_of(view.guide.home(show.stage())));
}

}  // namespace

CrowdSetup described(const Show& show, const Preset& seen) {
  CrowdSetup setup = crowd_setup(show.stage().people(), seen);
  setup.trajectories = described_tracks(show.stage());
  describe_camera(show, setup);
  return setup;
}

}  // namespace throng::app
