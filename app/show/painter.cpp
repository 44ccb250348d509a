#include "app/show/painter.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/files/data_folder.h"
#include "app/people/crowd/cast.h"
#include "app/people/place/plan_mesh.h"
#include "app/people/place/props.h"
#include "app/show/contexts.h"
#include "app/show/lod/tuned_view.h"
#include "app/show/stage/stage.h"
#include "app/show/worn_pieces.h"

namespace throng::app {
namespace {

// The pattern and the fabric of a smaller person are too small to be seen.
constexpr float least_dressed_pixels = 45.0F;

constexpr int software_window_agents = 300;
constexpr float software_error_px = 3.0F;
constexpr int software_triangles = 120'000;
constexpr float card_frame_rate = 60.0F;
constexpr std::size_t heap_page_bytes = std::size_t{16} << 20U;
constexpr float frustum_reach = 120.0F;  // metres

// A single last picture can afford its full quality anywhere, and a picture that is kept deserves it.
bool draws_live(const DemoOptions& options) {
  return options.context == ContextKind::window || (options.draw == DrawWhich::all && !options.output.any());
}

DeviceChoices choices_of_device(const DemoOptions& options, bool is_software) {
  const bool in_window = options.context == ContextKind::window, live = is_software && draws_live(options);
  const auto is_free = [&](const auto&... keys) { return !(options.values_given.has(keys) || ...); };
  DeviceChoices choices{.no_multisampling = live && options.msaa < 0,
                        .no_shadows = live && is_free("shadows", "crowd_shade"),
                        .holds_rate = in_window && is_free("holds_rate")};
  if (!in_window) return choices;
  if (!is_software && is_free("frame_rate")) choices.frame_rate = card_frame_rate;
  if (!is_software) return choices;
  if (is_free("agents")) choices.agents = software_window_agents;
  if (is_free("error_px", "mesh_error_px", "budget_ms", "lod", "mesh_lod")) choices.error_px = software_error_px;
  if (is_free("triangle_budget")) choices.triangles = software_triangles;
  return choices;
}

void light_as_tuned(const Tuning& tuning, render::CrowdFrame& frame) {
  frame.light = tuning.light;
  frame.shadows = tuning.shadows;
  frame.crowd_shade = tuning.crowd_shade;
}

double time_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// A part of the frame is taken away of the usual picture alone, so that a person sees its cost.
bool splits(const Tuning& tuning) { return tuning.inspection.split != Split::off && tuning.taken_away == TakenAway{}; }

/// Returns whether a scene may show a character. Only some scenes have things, and simplifying the balloon takes longer
/// than all else that a start does.
bool may_show(const Stage& stage, std::size_t character) {
  return !stage.characters()[character].roles.is_prop ||
         std::ranges::find(stage.crowd().characters(), character) != stage.crowd().characters().end();
}

// A character that was made anew, or whose bones are in another order, is another one. A cast may have one twice.
std::vector<render::CharacterToLoad> meshes_to_load(const Stage& stage,
                                                    std::vector<std::weak_ptr<const anim::Character>> loaded) {
  std::vector<render::CharacterToLoad> meshes;
  for (std::size_t character = 0; character < stage.characters().size(); ++character) {
    const CharacterSource& source = stage.characters()[character];
    const auto same = std::ranges::find_if(loaded, [&](const auto& each) { return each.lock() == source.character; });
    if (same == loaded.end()) {
      render::CrowdMeshData data = mesh_data(source);
      if (!may_show(stage, character)) data.parts.clear(), data.baked_lods.clear();
      meshes.emplace_back(std::move(data));
    } else {
      same->reset();
      meshes.emplace_back(static_cast<std::size_t>(same - loaded.begin()));
    }
  }
  return meshes;
}

std::optional<render::Lens> lens_of(const DemoOptions& options) {
  if (!options.focus) return {};
  return render::Lens{.focus = *options.focus, .aperture = options.aperture};
}

}  // namespace

Result<std::unique_ptr<Painter>> Painter::create(const DemoOptions& options) {
  std::unique_ptr<Painter> painter(new Painter());
  if (const Status opened = painter->open_context(options); !opened) return opened.error();
  if (const Status opened = painter->open_renderer(options); !opened) return opened.error();
  return painter;
}

Status Painter::open_context(const DemoOptions& options) {
  if (options.context == ContextKind::none) return Done{};
  auto context = app::open_context(options, context_makers(options));
  if (!context) return context.error();
  context_ = std::move(*context);
  return Done{};
}

Status Painter::open_renderer(const DemoOptions& options) {
  if (context_ == nullptr) {
    heap_pages_ = std::make_unique<HeapPageSource>(heap_page_bytes);
    return Done{};
  }
  const auto data = find_data(data_folders(options.data), "shaders");
  if (!data) return data.error();
  const bool modest = is_on_software() && draws_live(options);
  device_choices_ = choices_of_device(options, is_on_software());
  if (options.msaa >= 0) samples_of_still_ = options.msaa;
  auto renderer =
      render::Renderer::create(*context_, {.data = data->parent_path(),
                                           .size = {options.width, options.height},
                                           .samples = device_choices_.no_multisampling ? 0 : samples_of_still_,
                                           .longest_tile = options.longest_tile,
                                           .lights_at_vertices = modest,
                                           .lens = lens_of(options)});
  if (!renderer) return Error{renderer.error().message};
  renderer_ = std::move(*renderer);
  return load_scenery(options.data);
}

Status Painter::load_scenery(const std::string& data_option) {
  auto props = load_props(data_option);
  if (!props) return props.error();
  return scenery_.load(std::move(*props), *renderer_);
}

DrawnBy Painter::drawn_by() const {
  if (context_ == nullptr) return {};
  return {.context = context_->kind(), .gl_version = context_->version(), .gl_renderer = context_->renderer()};
}

std::string Painter::notice() const {
  if (context_ == nullptr) return {};
  std::string notice = software_notice(context_->renderer(), device_choices_);
  if (lines_left_out() > 0) add_line(notice, plan_notice(lines_left_out(), most_plan_lines));
  return notice;
}

render::PalettePageSource& Painter::palette_pages() {
  if (renderer_ != nullptr) return renderer_->palette_pages();
  return *heap_pages_;
}

void Painter::reset_palette_pages() {
  if (renderer_ != nullptr) return renderer_->reset_palette_pages();
  heap_pages_->drop_pages();
}

Status Painter::load_meshes(Stage& stage) {
  if (renderer_ == nullptr) return Done{};
  const std::vector<render::CharacterToLoad> meshes = meshes_to_load(stage, loaded_);
  if (Status loaded = renderer_->load_characters(meshes); !loaded) return loaded;
  loaded_.clear();
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const bool has_mesh = std::holds_alternative<std::size_t>(meshes[i]) || may_show(stage, i);
    loaded_.push_back(has_mesh ? stage.characters()[i].character : nullptr);
  }
  const CharacterRoles common = common_roles(roles_of(stage.characters()));
  distance_scale_ = std::max(1.0F, static_cast<float>(common.spacing()));
  looks_number_ = 0;
  follow_outfits(stage);
  return Done{};
}

void Painter::follow_outfits(Stage& stage) {
  if (renderer_ == nullptr || looks_number_ == stage.crowd().looks().number) return;
  looks_number_ = stage.crowd().looks().number;
  for (std::size_t i = 0; i < stage.characters().size(); ++i) {
    std::vector<render::MeshError> shares;
    std::vector<std::uint32_t> triangles;
    for (const MeshLevel& level : worn_levels(stage, i, renderer_->meshes()[i])) {
      shares.push_back(shares_of(level.error, stage.characters()[i].character->bounds.height));
      triangles.push_back(level.triangles);
    }
    stage.posed().mesh_lods().set(i, std::move(shares), std::move(triangles));
  }
}

std::vector<MeshLevel> Painter::mesh_levels(std::size_t character) const {
  if (renderer_ == nullptr) return {};
  const render::MeshLodList meshes = renderer_->mesh_lods(character);
  return app::mesh_levels(meshes.triangles, meshes.errors);
}

std::uint64_t Painter::completed_frame(const Stage& stage) {
  if (renderer_ == nullptr) return stage.posed().frame();
  return renderer_->completed_frame(stage.posed().frame());
}

render::CrowdFrame Painter::crowd_frame(const Stage& stage, const PaintedView& view, const Picture& picture) {
  render::CrowdFrame frame{
      .camera = render::view_of(view.camera, view.aspect()),
      .instances = picture.instances(),
      .batches = picture.batches(),
      .now = stage.now(),
      .bones_as_lines = stage.tuning().bones_as_lines,
      .fill_pixels = !stage.tuning().taken_away.pixels,
      .lines = lines_,
      .ground_lines = trail_lines_,
      .morph_weights = picture.morph_weights(),
      .distance_scale = distance_scale_,
      .ground = scenery_.ground(),
      .scenery_error_px = std::max(1.0F, 2.0F * stage.tuning().mesh_error_px),
      .scenery = stage.tuning().scenery,
      .looks = stage.crowd().looks().drawn,
      .looks_number = stage.crowd().looks().number,
      .drawn = picture.drawn(),
      .runs = picture.runs(),
      .first_plain_lod = stage.posed().mesh_lods().first_below(mesh_rules(stage.tuning()), stage.people().size(),
                                                               least_dressed_pixels, render::first_silhouette_lod),
      .jobs = {.executor = &stage.system().executor(), .at_once = stage.system().options().pus}};
  light_as_tuned(stage.tuning(), frame);
  return frame;
}

void Painter::gather_lines(const Stage& stage, const PaintedView& view) {
  lines_.clear();
  path_.add(lines_, stage);
  if (view.frozen) add_frustum(lines_, *view.frozen, view.aspect(), frustum_reach);
  trail_lines_.clear();
  trails_.add(trail_lines_, stage, view.camera, {view.width, view.height});
  thresholds_.update(stage, view.lod_camera(), view.height);
  if (!stage.tuning().inspection.thresholds) return;
  const auto middle = static_cast<float>(stage.characters()[thresholds_.character()].character->bounds.height / 2);
  add_threshold_rings(lines_, thresholds_.thresholds(), view.lod_camera(), middle);
}

Status Painter::upload(Stage& stage, const PaintedView& view) {
  picture_.compose(stage);
  if (Status placed = scenery_.follow(stage, *renderer_); !placed) return placed;
  gather_lines(stage, view);
  if (!splits(stage.tuning())) {
    renderer_->upload(crowd_frame(stage, view, picture_));
    return Done{};
  }
  stage.posed().pose_exactly(stage.animated().system(), placed_agents(stage.crowd()));
  exact_picture_.compose(stage, Poses::exact);
  return Done{};
}

render::DrawCounts Painter::draw_pictures(const Stage& stage, const PaintedView& view) {
  const render::CrowdFrame usual = crowd_frame(stage, view, picture_);
  if (!splits(stage.tuning())) return renderer_->draw_uploaded(usual);
  const LodInspection& look = stage.tuning().inspection;
  return renderer_->draw_split(crowd_frame(stage, view, exact_picture_), usual,
                               {.divider = look.split_at, .difference = look.split == Split::difference});
}

void Painter::time_device() {
  if (draws() && !is_on_software()) device_timer_.emplace();
}

Status Painter::draw(Stage& stage, const PaintedView& view, RunFigures& figures) {
  const auto start = RunFigures::Clock::now();
  const TakenAway& taken_away = stage.tuning().taken_away;
  FrameTimes times;
  Status drawn = Done{};
  if (!taken_away.upload) times.upload_ms = time_of([&] { drawn = upload(stage, view); });
  if (!drawn) return drawn;
  if (!taken_away.drawing) {
    times.submission_ms = time_of([&] {
      if (device_timer_) device_timer_->begin();
      draw_counts_ = draw_pictures(stage, view);
      if (device_timer_) device_timer_->end();
      renderer_->end_frame(stage.posed().frame());
    });
  }
  times.wait_ms = time_of([&] { drawn = renderer_->finish(); });
  if (device_timer_ && !taken_away.drawing) times.device_ms = device_timer_->milliseconds();
  figures.add_drawing(start, times, draw_counts_);
  return drawn;
}

Status Painter::draw_labels(Stage& stage, const PaintedView& view, bool is_drawn, render::LabelPicture& labels) {
  if (!is_drawn) {
    if (Status uploaded = upload(stage, view); !uploaded) return uploaded;
  }
  return renderer_->draw_labels(crowd_frame(stage, view, picture_), labels);
}

Status Painter::measure_bodies(const Stage& stage, const PaintedView& view, std::span<const render::PixelBox> boxes,
                               std::span<render::BodyAlone> bodies) {
  return renderer_->measure_bodies(crowd_frame(stage, view, picture_), boxes, bodies);
}

Status Painter::draw(render::CrowdFrame frame, const Tuning& tuning) {
  light_as_tuned(tuning, frame);
  draw_counts_ = renderer_->draw(frame);
  return renderer_->finish();
}

}  // namespace throng::app
