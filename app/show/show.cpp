#include "app/show/show.h"

#include <algorithm>
#include <utility>

#include "app/character/files.h"
#include "app/character/role_table.h"
#include "app/files/data_folder.h"
#include "app/files/exit_status.h"
#include "app/view/fly_camera.h"
#include "app/view/scenes.h"

namespace throng::app {
namespace {

constexpr int software_window_agents = 300;
constexpr std::size_t heap_page_bytes = std::size_t{16} << 20U;

bool fail(StartError& error, int status, std::string message) {
  error = {{std::move(message)}, status};
  return false;
}

anim::Result<std::vector<CharacterSource>> load(const DemoOptions& options) {
  if (!options.models.empty()) return load_characters(options.models);
  auto character = load_built_in(options.data);
  if (!character) return character.error();
  std::vector<CharacterSource> characters;
  characters.push_back(std::move(*character));
  return characters;
}

// What the command line says goes for every character that has such a clip.
bool take_chosen_role(const RoleChoice& choice, std::span<CharacterSource> characters, StartError& error) {
  std::string refusal;
  bool taken = false;
  for (CharacterSource& character : characters) {
    RoleClips clips = character.roles.clips;
    const auto chosen = choose_clips({&choice, 1}, character.clip_names, clips);
    if (chosen) assign_roles(character, clips);
    if (!chosen && refusal.empty()) refusal = chosen.error().message;
    taken |= chosen.has_value();
  }
  return taken || fail(error, exit_usage, "--clips " + refusal);
}

bool choose_roles(const DemoOptions& options, std::span<CharacterSource> characters, StartError& error) {
  const auto kept = [&](CharacterSource& character) {
    const anim::Status taken = take_kept_roles(character);
    return taken || fail(error, exit_job_failed, taken.error().message);
  };
  const auto chosen = [&](const RoleChoice& choice) { return take_chosen_role(choice, characters, error); };
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

bool Show::open_context(const DemoOptions& options, StartError& error) {
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
  if (!context) return fail(error, exit_job_failed, context.error().message);
  context_ = std::move(*context);
  return true;
}

bool Show::open_renderer(const DemoOptions& options, StartError& error) {
  if (context_ == nullptr) return true;
  const auto data = find_data(data_folders(options.data), "shaders");
  if (!data) return fail(error, exit_job_failed, data.error().message);
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
  if (!renderer) return fail(error, exit_job_failed, renderer.error().message);
  renderer_ = std::move(*renderer);
  return true;
}

bool Show::open_stage(std::vector<CharacterSource> characters, const DemoOptions& options, StartError& error) {
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
  if (!stage) return fail(error, exit_usage, stage.error().message);
  stage_ = std::move(*stage);
  if (options.events) stage_->animated().sum_up_events();
  const int agents = tuning.agents;
  if (!options.selected || *options.selected < agents) return true;
  return fail(
      error, exit_usage,
      "--select " + std::to_string(*options.selected) + ": the crowd has agents 0 to " + std::to_string(agents - 1));
}

bool Show::place_camera(const DemoOptions& options, StartError& error) {
  const Tuning& tuning = stage_->tuning();
  const auto agents = static_cast<std::size_t>(tuning.agents);
  const auto cameras = scene_cameras(tuning.scene, agents, stage_->common_roles());
  const NamedCamera* named = find_camera(cameras, options.camera_name);
  if (named == nullptr) {
    std::string names;
    for (const NamedCamera& each : cameras) names += (names.empty() ? "" : ", ") + std::string(each.name);
    return fail(error, exit_usage,
                "--camera " + options.camera_name + ": this scene has no such camera; it has " + names);
  }
  camera = camera_at(options.camera.value_or(named->place));
  path_ = options.camera_path;
  path_start_ = camera;
  films = path_ != CameraPath::none || (!options.camera && options.camera_name.empty());
  return true;
}

std::unique_ptr<Show> Show::create(const DemoOptions& options, StartError& error) {
  std::unique_ptr<Show> show(new Show());
  show->width = options.width;
  show->height = options.height;
  auto characters = load(options);
  if (!characters) return fail(error, exit_job_failed, characters.error().message), nullptr;
  if (!choose_roles(options, *characters, error)) return nullptr;
  if (!options.trace.empty()) show->timeline_.emplace();
  if (!show->open_context(options, error) || !show->open_renderer(options, error)) return nullptr;
  if (!show->open_stage(std::move(*characters), options, error)) return nullptr;
  if (const anim::Status loaded = show->load_meshes(*show->stage_); !loaded) {
    return fail(error, exit_job_failed, loaded.error().message), nullptr;
  }
  if (!show->place_camera(options, error)) return nullptr;
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

void Show::update_notice() {
  notice.clear();
  if (context_ != nullptr) add_line(notice, software_notice(context_->renderer(), spared_));
  add_line(notice, local_store_notice(stage_->system()));
  add_line(notice, palette_notice(stage_->shown()));
  add_line(notice, palette_format_notice(stage_->system(), stage_->people()));
}

}  // namespace throng::app
