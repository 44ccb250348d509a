#include "app/show/show.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/character/cast_files.h"
#include "app/character/files.h"
#include "app/files/exit_status.h"
#include "app/files/nearest_names.h"
#include "app/files/start_line.h"
#include "app/show/camera/fly_camera.h"
#include "app/show/lod/mesh_lods.h"
#include "app/show/opened_crowd.h"
#include "app/show/opened_trajectories.h"
#include "app/show/placed_anew.h"
#include "app/show/stage/memory_needs.h"
#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

// A recording does not hold the rows of a file, nor the moves of its clock.
constexpr const char* no_recording_of_tracks =
    "the scene tracks is not recorded: its file shows the same each time, from any --start at any --track-rate";

// So much of a start is done, by and large, when characters are there and when the crowd is.
constexpr double share_of_characters = 0.6, share_of_crowd = 0.9;

double milliseconds_since(RunFigures::Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(RunFigures::Clock::now() - start).count();
}

Tuning with_savings(Tuning tuning, const Spared& spared) {
  if (spared.agents > 0) tuning.agents = spared.agents;
  if (spared.shadows) tuning.shadows = tuning.crowd_shade = false;
  if (spared.error_px == 0.0F) return tuning;
  tuning.triangle_budget = spared.triangles;
  tuning.error_px = spared.error_px;
  tuning.mesh_error_px = spared.error_px * mesh_share_of_error;
  return tuning;
}

}  // namespace

std::unique_ptr<Show> Show::create(const DemoOptions& options, StartError& error, std::unique_ptr<LiveTracks> live) {
  std::unique_ptr<Show> show(new Show());
  show->width = options.width;
  show->height = options.height;
  show->load_options_ = app::load_options(options);
  show->data_ = options.data;
  StartTimes& times = show->figures_.start();
  auto start = RunFigures::Clock::now();
  const auto lap = [&start] { return milliseconds_since(std::exchange(start, RunFigures::Clock::now())); };
  StartLine line;
  line.tell(0, "reading characters");
  auto cast = load_starting_characters(
      options, error, [&line](double share, const std::string& what) { line.tell(share_of_characters * share, what); });
  if (!cast) return nullptr;
  line.tell(share_of_characters, "opening the device");
  times.characters_ms = lap();
  show->left_out_ = std::move(cast->left_out);
  if (!options.trace.empty()) show->figures_.keep_timeline();
  auto painter = Painter::create(options);
  if (!painter) return fail(error, exit_job_failed, painter.error().message), nullptr;
  show->painter_ = std::move(*painter);
  times.device_ms = lap();
  line.tell(share_of_characters, "");  // trajectories have lines of their own
  if (live != nullptr && !show->open_live(options, std::move(live), error)) return nullptr;
  if (!show->open_stage(std::move(cast->characters), options, line, error)) return nullptr;
  start = RunFigures::Clock::now();
  line.tell(share_of_crowd, "making meshes");
  if (const anim::Status loaded = show->painter_->load_meshes(*show->stage_); !loaded) {
    return fail(error, exit_job_failed, loaded.error().message), nullptr;
  }
  times.meshes_ms = lap();
  if (!show->place_camera(options, error)) return nullptr;
  if (options.view && !show->begin_viewing(*options.view, error)) return nullptr;
  show->update_notice();
  return show;
}

bool Show::open_stage(std::vector<CharacterSource> characters, const DemoOptions& options, StartLine& line,
                      StartError& error) {
  Tuning tuning = with_savings(options.tuning, painter_->spared());
  std::shared_ptr<const Trajectories> trajectories = live_ != nullptr ? live_->trajectories() : nullptr;
  if (live_ == nullptr && !options.trajectories.file.empty()) {
    trajectories = open_trajectories(options.trajectories, error);
    if (trajectories == nullptr) return false;
  }
  if (trajectories != nullptr) tuning.agents = static_cast<int>(trajectories->persons.size());
  if (const anim::Status fits = check_memory(tuning, characters, nullptr); !fits) {
    return fail(error, exit_job_failed, fits.error().message);
  }
  line.tell(share_of_characters, "placing " + counted(static_cast<std::size_t>(tuning.agents), "agent"));
  const auto start = RunFigures::Clock::now();
  auto stage = Stage::create(std::move(characters), tuning, painter_->palette_pages(), 0, std::move(trajectories));
  figures_.start().spawn_ms = milliseconds_since(start);
  if (!stage) return fail(error, exit_usage, stage.error().message);
  stage_ = std::move(*stage);
  if (!begin_tracks(options, error)) return false;
  if (options.events) stage_->animated().sum_up_events();
  if (!options.output.labels.empty()) {
    if (const anim::Status kept = stage_->posed().keep_joints(stage_->animated().system()); !kept)
      return fail(error, exit_job_failed, kept.error().message);
  }
  const int agents = tuning.agents;
  if (!options.selected || *options.selected < agents) return true;
  return fail(
      error, exit_usage,
      "--select " + std::to_string(*options.selected) + ": the crowd has agents 0 to " + std::to_string(agents - 1));
}

bool Show::begin_viewing(const std::string& clip, StartError& error) {
  ViewRequest request;
  const std::vector<std::string>& names = stage_->people().front().clip_names;
  if (!clip.empty()) {
    const auto found = std::ranges::find(names, clip);
    if (found == names.end()) {
      return fail(error, exit_usage,
                  "--view=" + clip + ": the model has no such clip; nearest are " + nearest_names(clip, names));
    }
    request.clip = static_cast<int>(found - names.begin());
  }
  const anim::Status viewed = view(request);
  return viewed ? true : fail(error, exit_job_failed, viewed.error().message);
}

anim::Status Show::take(const CrowdRequest& request) {
  anim::Status taken = std::visit([this](const auto& asked) { return carry_out(asked); }, request);
  if (!taken) return taken;
  if (recorder_.is_recording()) recorder_.add(as_recorded(request));
  update_notice();
  return taken;
}

// A replay has the characters that came of files, whatever lies beside these by then.
CrowdRequest Show::as_recorded(const CrowdRequest& request) const {
  const bool is_cast = std::holds_alternative<LoadModels>(request) || std::holds_alternative<SetCast>(request);
  return is_cast ? SetCast{exactly(stage_->people())} : request;
}

anim::Status Show::carry_out(const Apply& values) {
  const Tuning& tuning = values.tuning;
  if (tuning.scene == Scene::tracks && recorder_.is_recording()) return anim::Error{no_recording_of_tracks};
  const bool another_scene = tuning.scene != stage_->tuning().scene;
  anim::Status applied = stage_->apply(tuning);
  if (applied && another_scene) applied = painter_->load_meshes(*stage_);
  if (applied && another_scene) camera = guide.begin_scene(*stage_), films = true;
  return applied;
}

anim::Status Show::carry_out(const SetBody& body) {
  if (anim::Status there = has_character(*stage_, body.character); !there) return there;
  viewer_.reset();
  anim::Status set = stage_->set_rig(body.character, body.parts);
  if (set) rewind_.forget();
  return set;
}

anim::Status Show::carry_out(const SetBones& bones) {
  if (anim::Status there = has_character(*stage_, bones.character); !there) return there;
  viewer_.reset();
  anim::Status set = stage_->set_bone_lod(bones.character, bones.choice);
  return set ? painter_->load_meshes(*stage_) : set;
}

anim::Status Show::carry_out(const SetPlacement& placement) {
  if (anim::Status there = has_character(*stage_, placement.character); !there) return there;
  auto placed = placed_anew(stage_->people()[placement.character], placement.choice, load_options_, data_);
  if (!placed) return placed.error();
  std::vector<CharacterSource> characters(stage_->people().begin(), stage_->people().end());
  characters[placement.character] = std::move(*placed);
  return exchange(std::move(characters), stage_->tuning(), stage_->trajectories());
}

anim::Status Show::carry_out(const LoadModels& models) {
  auto loaded = load_dropped(models.files, load_options_);
  if (!loaded) return loaded.error();
  for (CharacterSource& character : loaded->characters) {
    if (const anim::Status kept = take_kept_roles(character); !kept) return kept.error();
  }
  return cast(std::move(loaded));
}

anim::Status Show::carry_out(const SetCast& others) {
  const std::size_t count = others.characters.size();
  if (count >= 1 && count <= most_models) return cast(load_crowd(others.characters, data_, load_options_));
  return anim::Error{"a crowd has 1 to " + std::to_string(most_models) + " characters, not " + std::to_string(count)};
}

anim::Status Show::carry_out(const GoBack& back) { return rewind_.go_back(*stage_, back.moment); }

anim::Status Show::cast(anim::Result<LoadedCast> loaded) {
  if (!loaded) return loaded.error();
  if (anim::Status replaced = replace_characters(std::move(loaded->characters)); !replaced) return replaced;
  left_out_ = std::move(loaded->left_out);
  return anim::Done{};
}

anim::Status Show::replace_characters(std::vector<CharacterSource> characters) {
  const bool viewed = viewer_ != nullptr;
  if (anim::Status exchanged = exchange(std::move(characters), stage_->tuning(), stage_->trajectories()); !exchanged)
    return exchanged;
  left_out_.clear();
  update_notice();
  return viewed ? view({}) : anim::Status(anim::Done{});  // a person who looks at models goes on
}

// A recorded crowd goes on at the same moment with other characters.
anim::Status Show::exchange(std::vector<CharacterSource> characters, const Tuning& tuning,
                            std::shared_ptr<const Trajectories> trajectories) {
  const bool same_tracks = tuning.scene == Scene::tracks && trajectories == stage_->trajectories();
  auto stage = Stage::create(std::move(characters), tuning, painter_->palette_pages(), stage_->posed().frame(),
                             std::move(trajectories));
  if (!stage) return stage.error();
  if (same_tracks) (*stage)->set_track_clock(stage_->crowd().tracks()->clock());
  if (const anim::Status loaded = painter_->load_meshes(**stage); !loaded) return loaded.error();
  if (stage_->animated().event_sums()) (*stage)->animated().sum_up_events();
  viewer_.reset();
  painter_->reset_palette_pages();  // the new stage has asked for none yet
  stage_ = std::move(*stage);
  rewind_.forget();
  return anim::Done{};
}

anim::Status Show::view(const ViewRequest& request) {
  std::vector<ViewedMesh> meshes;
  if (request.character < stage_->people().size()) {
    for (const MeshLevel& level : painter_->mesh_levels(request.character)) {
      meshes.push_back({static_cast<std::size_t>(level.triangles), level.error.surface});
    }
  }
  auto viewer = Viewer::create(*stage_, request, std::move(meshes));
  if (!viewer) return viewer.error();
  viewer_ = std::move(*viewer);
  return anim::Done{};
}

anim::Status Show::draw() {
  const PaintedView view{camera, frozen_camera_, width, height};
  if (viewer_ == nullptr) {
    const std::size_t left_out_before = painter_->lines_left_out();
    anim::Status drawn = painter_->draw(*stage_, view, figures_);
    if (painter_->lines_left_out() != left_out_before) update_notice();
    return drawn;
  }
  const render::Camera round = viewer_->turntable().camera(view.aspect(), covered);
  return painter_->draw(viewer_->frame(render::view_of(round, view.aspect())), stage_->tuning());
}

anim::Status Show::draw_labels(bool is_drawn, render::LabelPicture& labels) {
  const PaintedView view{camera, {}, width, height};
  return painter_->draw_labels(*stage_, view, is_drawn, labels);
}

anim::Status Show::start_recording(const std::filesystem::path& file) {
  if (stage_->tuning().scene == Scene::tracks) return anim::Error{no_recording_of_tracks};
  const RecordingHeader header{exactly(stage_->people()), stage_->tuning(), width, height};
  if (anim::Status started = recorder_.start(file, header); !started) return started;
  if (stage_->posed().frame() > 0) stage_->restart();
  rewind_.forget();
  keep_moments();
  return anim::Done{};
}

anim::Status Show::begin_anew(const Tuning& tuning) {
  if (anim::Status applied = take(Apply{tuning}); !applied) return applied;
  stage_->restart();
  rewind_.forget();
  frozen_camera_.reset();
  if (stage_->animated().event_sums()) stage_->animated().sum_up_events();
  return anim::Done{};
}

void Show::animate_as(const RecordedFrame& frame) {
  camera = frame.view.camera;
  films = false;
  update(frame.delta, &frame.view);
}

void Show::update(anim::Ticks delta, const LodView* as_recorded) {
  if (viewer_ != nullptr) return viewer_->advance(delta);
  const anim::Ticks step = stage_->tuning().taken_away.animation ? anim::Ticks{} : delta;
  painter_->follow_outfits(*stage_);
  const std::uint64_t completed = painter_->completed_frame(*stage_);
  const bool had_memory = !stage_->posed().shown().out_of_memory();
  const auto start = RunFigures::Clock::now();
  if (live_ != nullptr) take_live_rows(step);
  stage_->move(step);
  camera = guide.moved(*stage_, camera, films);
  freeze_lod_camera();
  const LodView view = as_recorded != nullptr ? *as_recorded : LodView{frozen_camera_.value_or(camera), width, height};
  stage_->pose(view.camera, view.width, view.height, step, completed);
  const double milliseconds = milliseconds_since(start);
  if (recorder_.is_recording()) {
    recorder_.add(RecordedFrame{step, view, stage_->system().figures().pose_hash()}, stage_->animated().agent_hashes());
  }
  // Any moment of a recorded crowd is there at once, and the moments of a live crowd cannot be found again.
  const bool has_clock_of_its_own = stage_->crowd().tracks() != nullptr;
  if (keeps_moments_ && !stage_->tuning().paused && !has_clock_of_its_own) rewind_.watch(*stage_);
  if (had_memory && stage_->posed().shown().out_of_memory()) update_notice();
  figures_.add_update(*stage_, start, milliseconds);
}

void Show::freeze_lod_camera() {
  if (!stage_->tuning().inspection.freeze_camera) {
    frozen_camera_.reset();
  } else if (!frozen_camera_) {
    frozen_camera_ = camera;
  }
}

void Show::update_notice() {
  notice.clear();
  add_line(notice, painter_->notice());
  add_line(notice, pu_notice(on_this_machine(stage_->tuning().system).pus, stage_->system().options().pus));
  for (const std::string& sentence : left_out_) add_line(notice, sentence);
  if (stage_->trajectories() != nullptr) add_line(notice, tracks_notice(*stage_->trajectories()));
  if (live_ != nullptr) {
    for (const std::string& sentence : live_->said()) add_line(notice, sentence);
  }
  add_line(notice, import_notice(stage_->people()));
  add_line(notice, placement_notice(stage_->people()));
  if (stage_->tuning().wardrobe) add_line(notice, rules_notice(stage_->clothing()));
  add_line(notice, local_store_notice(stage_->system()));
  add_line(notice, palette_notice(stage_->posed().shown()));
  add_line(notice, palette_format_notice(stage_->system(), stage_->people()));
}

}  // namespace throng::app
