#include "app/show.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/camera_path.h"
#include "app/character_files.h"
#include "app/data_folder.h"
#include "app/exit_status.h"
#include "app/fly_camera.h"
#include "app/lod_export.h"
#include "app/role_table.h"
#include "app/scenes.h"

namespace throng::app {
namespace {

constexpr int software_window_agents = 300;
constexpr std::size_t heap_page_bytes = std::size_t{16} << 20U;

double milliseconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

bool fail(Failure& failure, int status, std::string message) {
  failure = {status, std::move(message)};
  return false;
}

anim::Result<std::vector<CharacterSource>> load(const DemoOptions& options) {
  if (!options.models.empty()) return load_characters(options.models);
  const auto built_in = find_data(data_folders(options.data), "assets/mannequin.glb");
  if (!built_in) return built_in.error();
  const BoneLodFile kept{{}};
  auto character = load_character(built_in->string(), "mannequin (built in)", &kept);
  if (!character) return character.error();
  std::vector<CharacterSource> characters;
  characters.push_back(std::move(*character));
  return characters;
}

// What the command line says goes for every character that has such a clip.
bool take_chosen_role(const RoleChoice& choice, std::span<CharacterSource> characters, Failure& failure) {
  std::string refusal;
  bool taken = false;
  for (CharacterSource& character : characters) {
    RoleClips clips = character.roles.clips;
    const auto chosen = choose_clips({&choice, 1}, character.clip_names, clips);
    if (chosen) assign_roles(character, clips);
    if (!chosen && refusal.empty()) refusal = chosen.error().message;
    taken |= chosen.has_value();
  }
  return taken || fail(failure, exit_usage, "--clips " + refusal);
}

bool choose_roles(const DemoOptions& options, std::span<CharacterSource> characters, Failure& failure) {
  const auto kept = [&](CharacterSource& character) {
    const anim::Status taken = take_kept_roles(character);
    return taken || fail(failure, exit_job_failed, taken.error().message);
  };
  const auto chosen = [&](const RoleChoice& choice) { return take_chosen_role(choice, characters, failure); };
  return std::ranges::all_of(characters, kept) && std::ranges::all_of(options.clips, chosen);
}

// A crowd drawn live; a single last picture can afford its full quality anywhere.
bool draws_live(const DemoOptions& options) {
  return options.context == ContextKind::window || options.draw == DrawWhich::all;
}

}  // namespace

Show::~Show() {
  stage_.reset();
  renderer_.reset();
}

bool Show::open_context(const DemoOptions& options, Failure& failure) {
  using render::gl::make_egl_context;
  using render::gl::make_osmesa_context;
  if (options.context == ContextKind::none) return true;
  auto context = [&] {
    switch (options.context) {
      case ContextKind::osmesa:
        return make_osmesa_context();
      case ContextKind::window:
        return render::gl::make_window_context({.width = options.width, .height = options.height});
      default:
        return make_egl_context({.force_software = options.force_software});
    }
  }();
  if (!context && options.context == ContextKind::headless_default) context = make_osmesa_context();
  if (!context) return fail(failure, exit_job_failed, context.error().message);
  context_ = std::move(*context);
  return true;
}

bool Show::open_renderer(const DemoOptions& options, Failure& failure) {
  if (context_ == nullptr) return true;
  const auto data = find_data(data_folders(options.data), "shaders");
  if (!data) return fail(failure, exit_job_failed, data.error().message);
  const bool modest = on_software() && draws_live(options);
  mesh_detail_ = modest ? 0.1F : 1.0F;
  spared_ = {.multisampling = modest && options.msaa < 0,
             .shadows = modest && options.shadows && !options.shadows_given,
             .mesh_detail = modest && options.tuning.mesh_lod < 0};
  auto renderer = render::Renderer::create(
      *context_, {.data = data->parent_path(),
                  .size = {options.width, options.height},
                  .samples = options.msaa >= 0 ? options.msaa : (spared_.multisampling ? 0 : 4),
                  .shadows = options.shadows && !spared_.shadows});
  if (!renderer) return fail(failure, exit_job_failed, renderer.error().message);
  renderer_ = std::move(*renderer);
  return true;
}

bool Show::open_stage(std::vector<CharacterSource> characters, const DemoOptions& options, Failure& failure) {
  Tuning tuning = options.tuning;
  if (options.context == ContextKind::window && on_software() && !options.agents_given) {
    tuning.agents = software_window_agents;
    spared_.agents = software_window_agents;
  }
  if (renderer_ == nullptr) heap_pages_ = std::make_unique<render::HeapPageSource>(heap_page_bytes);
  render::PalettePageSource& pages = renderer_ != nullptr ? renderer_->palette_pages() : *heap_pages_;
  const auto start = TimelineLog::Clock::now();
  auto stage = Stage::create(std::move(characters), tuning, pages);
  statistics_.set_spawn(std::chrono::duration<double, std::milli>(TimelineLog::Clock::now() - start).count());
  if (!stage) return fail(failure, exit_usage, stage.error().message);
  stage_ = std::move(*stage);
  return true;
}

bool Show::place_camera(const DemoOptions& options, Failure& failure) {
  const Tuning& tuning = stage_->tuning();
  const auto agents = static_cast<std::size_t>(tuning.agents);
  const auto cameras = scene_cameras(tuning.scene, agents, stage_->common_roles());
  const NamedCamera* named = find_camera(cameras, options.camera_name);
  if (named == nullptr) {
    std::string names;
    for (const NamedCamera& each : cameras) names += (names.empty() ? "" : ", ") + std::string(each.name);
    return fail(failure, exit_usage,
                "--camera " + options.camera_name + ": this scene has no such camera; it has " + names);
  }
  camera = camera_at(options.camera.value_or(named->place));
  path_ = options.camera_path;
  path_start_ = camera;
  films = path_ != CameraPath::none || (!options.camera && options.camera_name.empty());
  return true;
}

std::unique_ptr<Show> Show::create(const DemoOptions& options, Failure& failure) {
  std::unique_ptr<Show> show(new Show());
  show->width = options.width;
  show->height = options.height;
  auto characters = load(options);
  if (!characters) return fail(failure, exit_job_failed, characters.error().message), nullptr;
  if (!choose_roles(options, *characters, failure)) return nullptr;
  if (!options.trace.empty()) show->timeline_.emplace();
  if (!show->open_context(options, failure) || !show->open_renderer(options, failure)) return nullptr;
  if (!show->open_stage(std::move(*characters), options, failure)) return nullptr;
  if (const anim::Status loaded = show->load_meshes(*show->stage_); !loaded) {
    return fail(failure, exit_job_failed, loaded.error().message), nullptr;
  }
  if (!show->place_camera(options, failure)) return nullptr;
  show->update_notice();
  return show;
}

anim::Status Show::apply(const Tuning& tuning) {
  const bool another_scene = tuning.scene != stage_->tuning().scene;
  const anim::Status applied = stage_->apply(tuning);
  if (applied && another_scene) films = true;
  if (applied) update_notice();
  if (applied && recorder_) recorder_->add(tuning);
  return applied;
}

void Show::set_roles(std::size_t character, const RoleClips& clips) {
  stage_->set_roles(character, clips);
  if (recorder_) recorder_->add(RecordedRoles{static_cast<std::uint32_t>(character), clips});
}

anim::Result<std::filesystem::path> Show::save_roles(std::size_t index) const {
  const CharacterSource& character = stage_->characters()[index];
  return RoleFile(character.file).write(all_choices(character.roles.clips, character.clip_names));
}

anim::Status Show::set_bone_lod(std::size_t character, const BoneLodChoice& choice) {
  const anim::Status set = stage_->set_bone_lod(character, choice);
  return set ? load_meshes(*stage_) : set;
}

anim::Result<std::filesystem::path> Show::save_bone_lod(std::size_t index) const {
  const CharacterSource& character = stage_->characters()[index];
  return BoneLodFile(character.file).write(character.character->skeleton);
}

anim::Result<std::filesystem::path> Show::export_lod(std::size_t index) const {
  const CharacterSource& character = stage_->characters()[index];
  std::span<const std::uint32_t> triangles;
  if (renderer_ != nullptr) triangles = renderer_->meshes()[index].triangles_by_lod();
  const double pixels_per_unit = static_cast<double>(render::pixels_tall(camera, static_cast<float>(height), 1, 1));
  return KeptFile(character.file, ".lod.export.json", "The level of detail")
      .write(lod_as_json(character, lod_levels(character, triangles), lod_rules(stage_->tuning()), pixels_per_unit));
}

void Show::select_at(float x, float y) {
  const auto size = glm::vec2(glm::ivec2(width, height));
  const auto picked = pick(ray_through(camera, {x, y}, size), stage_->bodies_in_view());
  select(picked ? std::optional(picked->agent) : std::nullopt);
}

void Show::select(std::optional<std::uint32_t> agent) {
  stage_->select(agent);
  if (recorder_) recorder_->add(RecordedSelection{agent});
}

anim::Status Show::push_selected() {
  const auto selected = stage_->selected();
  return selected ? push(*selected, render::forward(camera)) : anim::Done{};
}

anim::Status Show::push(std::uint32_t agent, const glm::vec3& direction) {
  anim::Status pushed = stage_->push_over(agent, direction);
  if (pushed && recorder_) recorder_->add(RecordedPush{agent, direction});
  return pushed;
}

anim::Status Show::start_recording(const std::filesystem::path& file) {
  RecordingHeader header{.characters = {}, .tuning = stage_->tuning(), .width = width, .height = height};
  for (const CharacterSource& character : stage_->people()) header.characters.push_back(recorded(character));
  auto recorder = RecordingWriter::create(file, header);
  if (!recorder) return recorder.error();
  if (stage_->frame() > 0) stage_->restart();
  recorder_ = std::move(*recorder);
  return anim::Done{};
}

anim::Status Show::stop_recording() {
  if (recorder_ == nullptr) return anim::Done{};
  return std::exchange(recorder_, nullptr)->finish();
}

void Show::update_notice() {
  notice.clear();
  if (context_ != nullptr) add_line(notice, software_notice(context_->renderer(), spared_));
  add_line(notice, local_store_notice(stage_->system()));
  add_line(notice, palette_notice(stage_->shown()));
  add_line(notice, palette_format_notice(stage_->system(), stage_->people()));
}

std::uint64_t Show::completed_frame() {
  if (renderer_ == nullptr) return stage_->frame();
  const std::uint64_t drawn = renderer_->fences().poll();
  return renderer_->fences().frames_in_flight() == 0 ? stage_->frame() : drawn;
}

void Show::film() {
  if (!films) return;
  if (path_ != CameraPath::none) {
    camera = along(path_, path_start_, anim::to_seconds(stage_->system().clock()));
  } else if (stage_->cut_scene() != nullptr) {
    camera = stage_->cut_scene()->film(camera);
  }
}

void Show::animate(anim::Ticks delta) { update(delta, nullptr); }

void Show::animate_as(const RecordedFrame& frame) {
  camera = frame.view.camera;
  films = false;
  update(frame.delta, &frame.view);
}

void Show::update(anim::Ticks delta, const LodView* as_recorded) {
  const anim::Ticks step = stage_->tuning().taken_away.animation ? 0 : delta;
  LodView view;
  const std::uint64_t completed = completed_frame();
  const bool had_memory = !stage_->shown().out_of_memory();
  const auto start = TimelineLog::Clock::now();
  update_ms_ = milliseconds_of([&] {
    stage_->move(step);
    film();
    freeze_lod_camera();
    view = as_recorded != nullptr ? *as_recorded : LodView{lod_camera(), width, height};
    stage_->pose(view.camera, view.width, view.height, step, completed);
  });
  times_.animation_ms = update_ms_;
  if (recorder_) recorder_->add({step, view, stage_->system().pose_hash()}, stage_->system().agent_hashes());
  if (had_memory && stage_->shown().out_of_memory()) update_notice();
  if (timeline_) timeline_->add_update(stage_->system(), start);
  statistics_.add_update(update_ms_);
  statistics_.add_report(*stage_);
}

int Show::pick_mesh_lod(std::uint8_t character, float pixels_tall, int at_least) const {
  const render::CrowdMesh& mesh = renderer_->meshes()[character];
  const int fixed = stage_->tuning().mesh_lod;
  if (fixed < 0) return render::pick_mesh_lod(mesh, pixels_tall, at_least, mesh_detail_);
  return std::min(fixed, static_cast<int>(mesh.lod_count()) - 1);
}

render::CrowdFrame Show::crowd_frame() const {
  return {.camera = render::view_of(camera, static_cast<float>(width) / static_cast<float>(height)),
          .instances = picture_.instances(),
          .batches = picture_.batches(),
          .now = stage_->now(),
          .bones_as_lines = stage_->tuning().bones_as_lines,
          .fill_pixels = !stage_->tuning().taken_away.pixels,
          .lines = lines_};
}

void Show::draw() {
  const auto start = TimelineLog::Clock::now();
  const TakenAway& taken_away = stage_->tuning().taken_away;
  times_.upload_ms = taken_away.upload ? 0.0 : milliseconds_of([&] {
    picture_.compose(*stage_, [this](std::uint8_t character, float pixels, int at_least) {
      return pick_mesh_lod(character, pixels, at_least);
    });
    gather_lines();
    renderer_->upload(crowd_frame());
  });
  times_.submission_ms = taken_away.drawing ? 0.0 : milliseconds_of([&] {
    draw_counts_ = renderer_->draw_uploaded(crowd_frame());
    renderer_->fences().insert(stage_->frame());
  });
  times_.wait_ms = milliseconds_of([&] { renderer_->finish(); });
  draw_ms_ = times_.upload_ms + times_.submission_ms + times_.wait_ms;
  if (timeline_) timeline_->add_part("draw", start, TimelineLog::Clock::now());
  statistics_.set_draw(draw_counts_.draw_calls, draw_counts_.triangles);
  statistics_.add_drawn_frame(update_ms_ + draw_ms_);
}

DrawnBy Show::drawn_by() const {
  if (context_ == nullptr) return {};
  return {.context = context_->kind(), .gl_version = context_->version(), .gl_renderer = context_->renderer()};
}

}  // namespace throng::app
