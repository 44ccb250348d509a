#include "app/window/dropped_tracks.h"

#include <algorithm>
#include <utility>

#include "app/show/camera/fly_camera.h"
#include "app/show/request/openable_files.h"
#include "app/show/show.h"
#include "app/show/show_view.h"
#include "app/show/stage/stage.h"
#include "engine/base/text/joined.h"
#include "engine/tracks/read.h"
#include "engine/tracks/trajectories.h"

namespace throng::app {
namespace {

/// Files that came together, by their kinds.
struct Sorted {
  explicit Sorted(std::span<const std::string> files) {
    for (const std::string& file : files) {
      (are_walls(file) ? walls : looks_like_trajectories(file) ? tracks : others).push_back(file);
    }
  }
  std::vector<std::string> tracks, walls, others;
};

// No crowd file has it yet, and nothing of it is the person's yet.
void begin_work(WindowSession& session) {
  session.reporter.report().crowd.clear();
  session.unsaved.keep(session.editor.tuning());
  session.unsaved.keep(session.crowd_work());
}

}  // namespace

Result<std::optional<TracksToRead>> tracks_to_read(std::span<const std::string> files, const std::string& shown) {
  const Sorted all(files);
  if (all.tracks.empty() && all.walls.empty()) return std::optional<TracksToRead>();
  if (!all.others.empty()) {
    const std::string& tracks = all.tracks.empty() ? all.walls.front() : all.tracks.front();
    return Error{all.others.front() + ": is no file of trajectories; drop it before or after " + tracks};
  }
  if (all.tracks.size() > 1) {
    return Error{all.tracks[1] + ": one recorded crowd is shown at a time; drop one of the files"};
  }
  if (all.walls.size() > 1) {
    return Error{all.walls[1] + ": one file of walls goes with a recorded crowd; drop one of them"};
  }
  const std::string& file = all.tracks.empty() ? shown : all.tracks.front();
  if (file.empty()) {
    return Error{all.walls.front() + ": walls go with a recorded crowd; drop its file together with them"};
  }
  return std::optional<TracksToRead>({file, all.walls.empty() ? std::string() : all.walls.front()});
}

bool open_tracks(const std::vector<std::string>& files, WindowSession& session) {
  const Stage& stage = session.show.stage();
  const Trajectories* const shown = stage.trajectories().get();
  const auto asked = tracks_to_read(files, stage.tuning().scene == Scene::tracks ? shown->file : std::string());
  if (!asked) return session.messages().say(asked.error().message, Message::Kind::refused), true;
  if (!*asked) return false;
  const std::string file = (*asked)->file;
  const bool is_same_file = shown != nullptr && shown->file == file;
  LoadPlan plan = session.show.plan_for({});
  plan.tracks = file;
  plan.reading = is_same_file ? shown->reading : session.options.trajectories.reading;
  plan.reading.walls = (*asked)->walls;
  const bool begins_anew = std::ranges::any_of(files, [](const std::string& each) { return is_crowd(each); });
  session.loading.begin(std::move(plan), [&session, file, begins_anew](const ShownTracks& tracks) {
    if (!session.editor.take(tracks)) return;
    session.camera.put(place_of(session.show.view().camera), session.show);
    if (begins_anew) begin_work(session);
    session.note_recent(file);
    session.messages().say("Opened " + file + ": " + counted_people(tracks->persons.size()));
  });
  return true;
}

}  // namespace throng::app
