#include "app/window/dropped_tracks.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "app/show/camera/fly_camera.h"
#include "app/show/request/openable_files.h"
#include "app/show/show.h"
#include "app/show/show_view.h"
#include "app/show/stage/stage.h"
#include "engine/base/text/joined.h"
#include "engine/tracks/read.h"

namespace throng::app {
namespace {

constexpr int frames_to_say_it = 2;  // one in which it is asked for, one in which the words are drawn

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

bool DroppedTracks::takes(const std::vector<std::string>& files, WindowSession& session) {
  const Stage& stage = session.show.stage();
  const auto asked =
      tracks_to_read(files, stage.tuning().scene == Scene::tracks ? stage.trajectories()->file : std::string());
  if (!asked) return session.messages().say(asked.error().message, Message::Kind::refused), true;
  if (!*asked) return false;
  next_ = **asked;
  begins_anew_ = std::ranges::any_of(files, [](const std::string& file) { return is_crowd(file); });
  frames_until_read_ = frames_to_say_it;
  session.messages().say("Reads " + next_.file + (next_.walls.empty() ? "" : " and " + next_.walls) + " ...");
  return true;
}

void DroppedTracks::read_when_said(WindowSession& session) {
  if (frames_until_read_ > 0 && --frames_until_read_ == 0) read(session);
}

void DroppedTracks::read(WindowSession& session) const {
  const Trajectories* const shown_now = session.show.stage().trajectories().get();
  const bool is_same_file = shown_now != nullptr && shown_now->file == next_.file;
  TrackReading reading = is_same_file ? shown_now->reading : session.options.trajectories.reading;
  reading.walls = next_.walls;
  auto tracks = read_trajectories(next_.file, reading);
  if (!tracks) return session.messages().say(tracks.error().message, Message::Kind::refused);
  const std::size_t people = tracks->persons.size();
  Show& show = session.show;
  if (!session.editor.take(std::make_shared<const Trajectories>(std::move(*tracks)))) return;
  session.camera.put(place_of(show.view().camera), show);
  if (begins_anew_) begin_work(session);
  session.note_recent(next_.file);
  session.messages().say("Opened " + next_.file + ": " + counted_people(people));
}

}  // namespace throng::app
