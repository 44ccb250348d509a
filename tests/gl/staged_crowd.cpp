#include "tests/gl/staged_crowd.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/show/camera/fly_camera.h"
#include "app/show/camera/scenes.h"
#include "engine/anim/import/import.h"

namespace throng::app::test {
namespace {

constexpr int width = 64, height = 36;
constexpr const char* model_file = THRONG_SOURCE_DIR "/assets/mannequin.glb";

template <typename Value>
Value value_of(Result<Value> result) {
  if (!result) throw std::runtime_error(result.error().message);
  return std::move(*result);
}

std::unique_ptr<render::Renderer> create_renderer(render::gl::Context& context, const CharacterSource& character) {
  auto renderer = render::Renderer::create(context, {.data = THRONG_SOURCE_DIR, .size = {width, height}, .samples = 0});
  if (!renderer) throw std::runtime_error(renderer.error().message);
  const render::CrowdMeshData mesh = mesh_data(character);
  const Status loaded = (*renderer)->load_characters({&mesh, 1});
  if (!loaded) throw std::runtime_error(loaded.error().message);
  return std::move(*renderer);
}

/// Blends each bone's rotation along the shorter arc and its joint along a straight line.
std::vector<glm::dmat4> between(const anim::Skeleton& skeleton, const std::vector<glm::dmat4>& from,
                                const std::vector<glm::dmat4>& to, double blend) {
  std::vector<glm::dmat4> palette;
  for (std::size_t bone = 0; bone < from.size(); ++bone) {
    const glm::dquat a = glm::quat_cast(glm::dmat3(from[bone])), b = glm::quat_cast(glm::dmat3(to[bone]));
    const double side = glm::dot(a, b) < 0.0 ? -1.0 : 1.0;
    const glm::dmat3 turn = glm::mat3_cast(glm::normalize(a * (1.0 - blend) + b * (side * blend)));
    const glm::dvec4 pivot(skeleton.references[bone].origin, 1.0);
    const glm::dvec3 joint = glm::mix(glm::dvec3(from[bone] * pivot), glm::dvec3(to[bone] * pivot), blend);
    glm::dmat4& matrix = palette.emplace_back(turn);
    matrix[3] = glm::dvec4(joint - turn * glm::dvec3(pivot), 1.0);
  }
  return palette;
}

}  // namespace

anim::PaletteMatrix rows_of(const glm::dmat4& matrix) {
  anim::PaletteMatrix rows{};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) rows.rows[row][column] = static_cast<float>(matrix[column][row]);
  }
  return rows;
}

StagedCrowd::StagedCrowd(render::gl::Context& context, const Tuning& tuning) {
  std::vector<CharacterSource> characters;
  characters.push_back(value_of(load_character(model_file, "mannequin")));
  renderer_ = create_renderer(context, characters.front());
  read_back_ = std::make_unique<render::test::SkinningReadBack>(*renderer_);
  pages_ = std::make_unique<RememberedPages>(renderer_->palette_pages());
  stage_ = value_of(Stage::create(std::move(characters), tuning, *pages_));
  anim::Model as_imported = value_of(import::import_file(model_file)).models.front();
  reference_ = std::make_unique<ReferenceCrowd>(stage_->characters().front(), std::move(as_imported.clips), tuning);
  // Everybody gets the coarsest mesh, which is the quickest to draw.
  stage_->posed().mesh_lods().set(0, std::vector<render::MeshError>(renderer_->mesh_lods(0).errors.size()), {});
  moments_.resize(stage_->crowd().size());
  // The reference knows poses, but no builds of bodies.
  looks_.resize(stage_->crowd().size(), render::plain_look());
  camera_ = camera_at({.x = 0, .y = 15.5F, .z = 8.5F, .yaw = 0, .pitch = -64, .field_of_view = 50});
}

void StagedCrowd::retune(const Tuning& tuning) {
  const Status applied = stage_->apply(tuning);
  if (!applied) throw std::runtime_error(applied.error().message);
}

void StagedCrowd::pass_frame() {
  if (stage_->posed().frame() > 0) renderer_->end_frame(stage_->posed().frame());
  stage_->move(frame_step);
  reference_->advance(frame_step);
  stage_->pose(camera_, width, height, frame_step, renderer_->completed_frame(stage_->posed().frame()));
  note_moments();
  picture_.compose(*stage_);
  instances_.assign(picture_.instances().begin(), picture_.instances().end());
}

// With smooth skipping an update computes a pose ahead; the blend starts at the pose that was reached until now.
void StagedCrowd::note_moments() {
  const Ticks now = reference_->clock();
  for (const PoseRequest& update : stage_->posed().level_of_detail().updates()) {
    const std::uint32_t agent = update.agent.number;
    const ShownPose& pose = stage_->posed().shown().pose(agent);
    const bool looks_ahead = pose.from_time != pose.to_time;
    Slots& slots = moments_[agent];
    const PoseMoment to{.evaluated = now,
                        .time = now + update.look_ahead,
                        .fade_level = update.fade_level,
                        .faded = update.fade_halves / 2.0};
    slots = {looks_ahead ? slots.to : to, to};
  }
}

render::CrowdFrame StagedCrowd::frame() const {
  return {.camera = render::view_of(camera_, static_cast<float>(width) / height),
          .instances = instances_,
          .batches = picture_.batches(),
          .now = stage_->now(),
          .bones_as_lines = false,
          .shadows = false,
          .crowd_shade = false,
          .looks = looks_,
          .looks_number = looks_number_};
}

std::uint32_t StagedCrowd::instance_of(std::uint32_t agent) const {
  const auto found = std::ranges::find(instances_, agent, &render::InstanceRecord::agent);
  if (found == instances_.end()) throw std::runtime_error("agent " + std::to_string(agent) + " is not drawn");
  return static_cast<std::uint32_t>(found - instances_.begin());
}

double StagedCrowd::blend_of(std::uint32_t agent) const {
  const auto& [from, to] = moments_[agent];
  if (from.time == to.time) return 1.0;
  return to_seconds(reference_->clock() - from.time) / to_seconds(to.time - from.time);
}

bool StagedCrowd::blends(std::uint32_t agent) const { return blend_of(agent) > 0.0 && blend_of(agent) < 1.0; }

/// Blends two poses as the shader does. It mixes float palettes as matrices, which moves vertices along straight lines,
/// and packed ones bone by bone.
std::vector<glm::dvec3> StagedCrowd::reference_surface(std::uint32_t agent) const {
  const ShownPose& pose = stage_->posed().shown().pose(agent);
  const auto& [from, to] = moments_[agent];
  const double blend = blend_of(agent);
  if (pose.from_format == PaletteFormat::packed && pose.to_format == PaletteFormat::packed) {
    const auto palette = between(stage_->characters().front().model.skeleton, reference_->palette(agent, from),
                                 reference_->palette(agent, to), blend);
    return reference_->surface_of(palette, pose.level());
  }
  std::vector<glm::dvec3> surface = reference_->surface(agent, from, pose.level());
  const std::vector<glm::dvec3> later = reference_->surface(agent, to, pose.level());
  for (std::size_t vertex = 0; vertex < surface.size(); ++vertex) {
    surface[vertex] = glm::mix(surface[vertex], later[vertex], blend);
  }
  return surface;
}

std::vector<render::test::ReadBackVertex> StagedCrowd::surface_on_device(std::uint32_t agent) {
  const std::uint32_t instance = instance_of(agent);
  const auto batch = std::ranges::find_if(picture_.batches(), [instance](const render::CrowdBatch& candidate) {
    return instance - candidate.first < candidate.count;
  });
  return read_back_->read(frame(), {instance, batch->page});
}

double StagedCrowd::largest_error_on_screen(std::uint32_t agent) {
  const render::CameraView view = frame().camera;
  const glm::dmat4 to_clip = glm::dmat4(view.projection) * glm::dmat4(view.view);
  const auto pixels = [&](const glm::dvec4& clip) {
    return glm::dvec2(clip) / clip.w * glm::dvec2(width, height) * 0.5;
  };
  const std::vector<render::test::ReadBackVertex> drawn = surface_on_device(agent);
  const Ticks now = reference_->clock();
  const std::vector<glm::dvec3> exact = reference_->surface(agent, {.evaluated = now, .time = now}, 0);
  double largest = 0.0;
  for (std::size_t vertex = 0; vertex < drawn.size(); ++vertex) {
    const glm::dvec4 should_be = to_clip * glm::dvec4(reference_->to_world(agent, exact[vertex]), 1.0);
    if (glm::max(std::abs(should_be.x), std::abs(should_be.y)) > should_be.w) continue;
    const glm::dvec4 is = to_clip * glm::dvec4(glm::dvec3(drawn[vertex].position), 1.0);
    largest = std::max(largest, glm::distance(pixels(is), pixels(should_be)));
  }
  return largest;
}

double StagedCrowd::largest_error(std::uint32_t agent) {
  const std::vector<render::test::ReadBackVertex> drawn = surface_on_device(agent);
  const std::vector<glm::dvec3> meant = reference_surface(agent);
  if (drawn.size() != meant.size()) throw std::runtime_error("the device has another number of vertices");
  double largest = 0.0;
  for (std::size_t vertex = 0; vertex < drawn.size(); ++vertex) {
    const glm::dvec3 place = reference_->to_world(agent, meant[vertex]);
    const double distance = glm::distance(place, glm::dvec3(drawn[vertex].position));
    if (!std::isfinite(distance)) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, distance);
  }
  return largest;
}

void StagedCrowd::negate_rotations(std::uint32_t agent) {
  const PaletteSlot& slot = stage_->posed().shown().pose(agent).to;
  std::byte* memory = pages_->page(slot.page).memory + slot.first_line * render::palette_line_bytes;
  for (std::size_t bone = 0; bone < stage_->characters().front().model.skeleton.bones.size(); ++bone) {
    std::int16_t rotation[4];
    std::byte* const entry = memory + bone * sizeof(anim::PackedPaletteEntry);
    std::memcpy(rotation, entry, sizeof(rotation));
    for (std::int16_t& component : rotation) component = static_cast<std::int16_t>(-component);
    std::memcpy(entry, rotation, sizeof(rotation));
  }
}

void StagedCrowd::write(const PaletteSlot& slot, const std::vector<anim::PaletteMatrix>& palette) {
  std::byte* memory = pages_->page(slot.page).memory + slot.first_line * render::palette_line_bytes;
  const std::size_t entries =
      std::min(palette.size(), slot.lines * render::palette_line_bytes / sizeof(anim::PaletteMatrix));
  std::memcpy(memory, palette.data(), entries * sizeof(anim::PaletteMatrix));
}

}  // namespace throng::app::test
