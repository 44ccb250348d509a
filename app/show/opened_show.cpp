#include "app/show/opened_show.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/character/source.h"
#include "app/files/exit_status.h"
#include "app/files/nearest_names.h"
#include "app/files/progress_bar.h"
#include "app/show/beginning.h"
#include "app/show/load_plan.h"
#include "app/show/lod/tuned_view.h"
#include "app/show/show_parts.h"
#include "app/show/stage/memory_needs.h"
#include "engine/base/text/joined.h"
#include "engine/tracks/file_plan.h"
#include "engine/tracks/read.h"

namespace throng::app {
namespace {

// The rough shares of a start that are over when the characters are loaded, when their surfaces are built, and when the
// crowd is placed.
constexpr double share_of_characters = 0.5, share_of_surfaces = 0.8, share_of_crowd = 0.9;

Tuning with_choices(Tuning tuning, const DeviceChoices& device) {
  if (device.agents > 0) tuning.agents = device.agents;
  if (device.no_shadows) tuning.shadows = tuning.crowd_shade = false;
  if (device.triangles > 0) tuning.triangle_budget = device.triangles;
  if (device.frame_rate > 0.0F) tuning.frame_rate = device.frame_rate;
  tuning.holds_rate |= device.holds_rate;
  if (device.error_px == 0.0F) return tuning;
  tuning.error_px = device.error_px;
  tuning.mesh_error_px = device.error_px * mesh_share_of_error;
  return tuning;
}

/// What a start reads from files.
struct FilesOfStart {
  LoadedCast cast;
  std::shared_ptr<const Trajectories> tracks;  // null: there are none
  bool are_read = false;
};

/// Reads the files that a start names; sets the error where one cannot be used.
FilesOfStart read_files(const DemoOptions& options, bool is_drawn, const LoadProgress& progress, StartError& error) {
  FilesOfStart files;
  auto cast = load_starting_characters(
      options, error, [&](double share, const std::string& what) { progress(share_of_characters * share, what); });
  if (!cast) return files;
  files.cast = std::move(*cast);
  const std::string& file = options.trajectories.file;
  if (is_drawn) {
    build_surfaces(files.cast.characters, [&](double share, const std::string& what) {
      progress(share_of_characters + (share_of_surfaces - share_of_characters) * share, what);
    });
  }
  files.are_read = true;
  if (file.empty() || file == "-") return files;
  auto read = read_trajectories(file, options.trajectories.reading, [&](double share) {
    progress(share_of_surfaces, "reading " + file + ": " + std::to_string(static_cast<int>(100.0 * share)) + "%");
  });
  if (!read) return fail(error, exit_job_failed, read.error().message), FilesOfStart();
  files.tracks = std::make_shared<const Trajectories>(std::move(*read));
  return files;
}

std::unique_ptr<LiveCrowd> open_live(const DemoOptions& options, std::unique_ptr<LiveTracks> live, StartError& error) {
  GroundPlan plan;
  const std::string& walls = options.trajectories.reading.walls;
  if (!walls.empty()) {
    auto read = read_ground_plan(walls, live->head()->origin);
    if (!read) return fail(error, exit_job_failed, read.error().message), nullptr;
    plan = std::move(*read);
  }
  const auto pace = options.context == ContextKind::window ? LiveCrowd::Pace::of_the_rows : LiveCrowd::Pace::of_the_run;
  return std::make_unique<LiveCrowd>(std::move(live), static_cast<std::size_t>(options.tuning.agents), std::move(plan),
                                     pace);
}

bool open_stage(ShowParts& show, FilesOfStart files, const DemoOptions& options, ProgressBar& line, StartError& error) {
  Tuning tuning = with_choices(options.tuning, show.painter->device_choices());
  std::shared_ptr<const Trajectories> trajectories =
      show.live != nullptr ? show.live->trajectories() : std::move(files.tracks);
  std::vector<CharacterSource> characters = std::move(files.cast.characters);
  if (trajectories != nullptr && tuning.scene == Scene::tracks) {
    tuning.agents = static_cast<int>(trajectories->persons.size());
  }
  if (const Status fits = check_memory(tuning, characters, nullptr); !fits) {
    return fail(error, exit_job_failed, fits.error().message);
  }
  line.show(share_of_surfaces, "placing " + counted(static_cast<std::size_t>(tuning.agents), "agent"));
  StopWatch watch;
  auto stage = Stage::create(std::move(characters), tuning, show.painter->palette_pages(), 0, std::move(trajectories));
  show.figures.start().spawn_ms = watch.lap();
  if (!stage) return fail(error, exit_usage, stage.error().message);
  show.stage = std::move(*stage);
  if (!begin_tracks(*show.stage, options, error)) return false;
  if (options.events) show.stage->animated().sum_up_events();
  if (!options.output.labels.empty()) {
    if (const Status kept = show.stage->posed().keep_joints(show.stage->animated().system()); !kept)
      return fail(error, exit_job_failed, kept.error().message);
  }
  const int agents = tuning.agents;
  if (!options.selected || *options.selected < agents) return true;
  return fail(
      error, exit_usage,
      "--select " + std::to_string(*options.selected) + ": the crowd has agents 0 to " + std::to_string(agents - 1));
}

bool begin_viewing(Show& show, const std::string& clip, StartError& error) {
  ViewRequest request;
  const std::vector<std::string>& names = show.stage().people().front().clip_names;
  if (!clip.empty()) {
    const auto found = std::ranges::find(names, clip);
    if (found == names.end()) {
      return fail(error, exit_usage,
                  "--view=" + clip + ": the model has no such clip; nearest are " + nearest_names(clip, names));
    }
    request.clip = static_cast<int>(found - names.begin());
  }
  const Status viewed = show.open_viewer(request);
  return viewed ? true : fail(error, exit_job_failed, viewed.error().message);
}

}  // namespace

Result<bool> start_at_once(Painter& /*painter*/, const LongWork& work) {
  work([](double, const std::string&) {});
  return true;
}

std::unique_ptr<Show> open_show(const DemoOptions& options, StartError& error, std::unique_ptr<LiveTracks> live,
                                const StartWork& do_work) {
  auto parts = std::make_unique<ShowParts>();
  parts->view.width = options.width;
  parts->view.height = options.height;
  parts->models.options = load_options(options);
  parts->models.data = options.data;
  StartTimes& times = parts->figures.start();
  StopWatch watch;
  ProgressBar line;
  line.show(0, "opening the device");
  if (!options.trace.empty()) parts->figures.keep_timeline();
  auto painter = Painter::create(options);
  if (!painter) return fail(error, exit_job_failed, painter.error().message), nullptr;
  parts->painter = std::move(*painter);
  times.device_ms = watch.lap();
  FilesOfStart files;
  const auto read = do_work(*parts->painter, [&](const LoadProgress& progress) {
    const auto tell = [&](double share, const std::string& what) {
      line.show(share, what);
      progress(share, what);
    };
    tell(0, "reading characters");
    files = read_files(options, parts->painter->draws(), tell, error);
  });
  if (!read) return fail(error, exit_job_failed, read.error().message), nullptr;
  if (!*read) return fail(error, exit_done, ""), nullptr;
  if (!files.are_read) return nullptr;
  times.characters_ms = watch.lap();
  parts->models.left_out = std::move(files.cast.left_out);
  if (live != nullptr) {
    parts->live = open_live(options, std::move(live), error);
    if (parts->live == nullptr) return nullptr;
  }
  if (!open_stage(*parts, std::move(files), options, line, error)) return nullptr;
  watch = {};
  line.show(share_of_crowd, "making meshes");
  if (const Status loaded = parts->painter->load_meshes(*parts->stage); !loaded) {
    return fail(error, exit_job_failed, loaded.error().message), nullptr;
  }
  times.meshes_ms = watch.lap();
  if (!place_camera(*parts, options, error)) return nullptr;
  auto show = std::make_unique<Show>(std::move(parts));
  if (options.view && !begin_viewing(*show, *options.view, error)) return nullptr;
  return show;
}

}  // namespace throng::app
