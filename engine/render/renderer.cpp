#include "engine/render/renderer.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

#include <glm/packing.hpp>

#include "engine/base/files/free_memory.h"
#include "engine/base/srgb.h"
#include "engine/render/gl/device_errors.h"
#include "engine/render/light/light_parts.h"

namespace throng::render {
namespace {

// Colours, depths, blended surfaces, and the two sides of a split view.
std::uint64_t bytes_a_pixel(int samples) {
  constexpr std::uint64_t bytes_a_sample = 4 + 8 + 10, bytes_of_sides = 8, bytes_of_finished = 4;
  return bytes_a_sample * static_cast<std::uint64_t>(std::max(samples, 1)) + bytes_of_sides + bytes_of_finished;
}

Result<TiledTarget> create_target(const gl::Context& context, const RendererOptions& options) {
  const gl::DeviceLimits& device = context.limits();
  if (options.samples > device.samples) {
    return Error{"the graphics device takes at most " + std::to_string(device.samples) + " samples a pixel, not " +
                 std::to_string(options.samples)};
  }
  const bool whole = context.window() != nullptr;
  const TileLimits limits{.longest = whole ? device.target : glm::min(device.target, glm::ivec2(options.longest_tile)),
                          .memory = free_memory(),
                          .bytes_a_pixel = context.is_software() ? bytes_a_pixel(options.samples) : 0,
                          .bytes_beside = options.lens ? AveragedPicture::bytes_a_pixel : 0,
                          .whole = whole};
  return TiledTarget::create(options.size, options.samples, limits);
}

CrowdFrame part_of(const CrowdFrame& frame, glm::ivec2 picture, const PixelRect& drawn) {
  CrowdFrame part = frame;
  part.camera = part_of(frame.camera, picture, drawn);
  return part;
}

// Returns the light of an sRGB colour, red in the lowest byte.
glm::vec3 light_of(std::uint32_t color) {
  const glm::vec4 srgb = glm::unpackUnorm4x8(color);
  return {light_of_srgb(srgb.r), light_of_srgb(srgb.g), light_of_srgb(srgb.b)};
}

}  // namespace

Result<std::unique_ptr<Renderer>> Renderer::create(gl::Context& context, const RendererOptions& options) {
  Result<TiledTarget> target = create_target(context, options);
  if (!target) return target.error();
  std::unique_ptr<Renderer> renderer(new Renderer(context, options, std::move(*target)));
  if (const Status& built = renderer->shaders_.status(); !built) return built.error();
  if (const Status made = gl::take_errors("the parts of a picture"); !made) return made.error();
  return renderer;
}

Renderer::Renderer(gl::Context& context, const RendererOptions& options, TiledTarget target)
    : context_(&context), shaders_(options.data / "shaders"), target_(std::move(target)), options_(options) {}

Status Renderer::load_characters(std::span<const CrowdMeshData> characters) {
  return load_characters(std::vector<CharacterToLoad>(characters.begin(), characters.end()));
}

Status Renderer::load_characters(std::span<const CharacterToLoad> characters) {
  assert(!characters.empty() && characters.size() <= most_characters);
  std::vector<CrowdMesh> made;
  for (const CharacterToLoad& character : characters) {
    const auto* const data = std::get_if<CrowdMeshData>(&character);
    if (data == nullptr) continue;
    Result<CrowdMesh> mesh = CrowdMesh::create(*data);
    if (!mesh) return mesh.error();
    made.push_back(std::move(*mesh));
  }
  if (std::ranges::any_of(made, &CrowdMesh::has_morphs)) {
    crowd_.prepare_morphs();
    shadows_.prepare_morphs();
    if (!shaders_.status()) return shaders_.status().error();
  }
  if (Status copied = gl::take_errors("the characters; ask for fewer or smaller models"); !copied) return copied;
  std::vector<CrowdMesh> meshes;
  auto next = made.begin();
  for (const CharacterToLoad& character : characters) {
    const auto* const before = std::get_if<std::size_t>(&character);
    meshes.push_back(std::move(before != nullptr ? meshes_[*before] : *next++));
  }
  meshes_ = std::move(meshes);
  return Done{};
}

void Renderer::reset_palette_pages() {
  glFinish();
  palettes_ = PaletteBuffer();
}

void Renderer::upload(const CrowdFrame& frame) {
  const std::size_t limit = context_->limits().storage_block;
  if (frame.instances.size_bytes() > limit || frame.looks.size_bytes() > limit ||
      frame.morph_weights.size_bytes() > limit) {
    trouble_ = Error{"the graphics device takes at most " + std::to_string(limit / sizeof(AgentLook)) +
                     " agents in a picture, or " + std::to_string(limit / sizeof(float)) + " weights of their morphs"};
  }
  frame_data_.upload(frame);
}

DrawCounts Renderer::draw(const CrowdFrame& frame) {
  upload(frame);
  return draw_uploaded(frame);
}

DrawCounts Renderer::draw_uploaded(const CrowdFrame& frame) {
  DrawCounts counts = draw_light(frame);
  add(counts, options_.lens ? draw_through_lens(frame, *options_.lens) : draw_tiles(frame));
  return counts;
}

DrawCounts Renderer::draw_tiles(const CrowdFrame& frame) {
  DrawCounts counts;
  target_.draw_tiles([&](const PixelRect& drawn) {
    const CrowdFrame tile = part_of(frame, size(), drawn);
    if (target_.is_tiled() || options_.lens) frame_data_.upload_view(tile);
    add(counts, draw_scene(tile));
  });
  return counts;
}

DrawCounts Renderer::draw_through_lens(const CrowdFrame& frame, const Lens& lens) {
  DrawCounts counts;
  AveragedPicture average;
  const float radius = radius_of(lens, frame.camera);
  for (int point = 0; point < lens.points; ++point) {
    CrowdFrame seen = frame;
    seen.camera = seen_through(frame.camera, radius * point_of_disc(point, lens.points), lens.focus);
    add(counts, draw_tiles(seen));
    average.add(target_.read());
  }
  target_.write(average.finish());
  return counts;
}

DrawCounts Renderer::draw_split(const CrowdFrame& left, const CrowdFrame& right, const SplitView& split) {
  DrawCounts counts;
  splits_ = true;
  const auto draw_side = [&](const CrowdFrame& side, const PixelRect& drawn) {
    const CrowdFrame tile = part_of(side, size(), drawn);
    upload(tile);
    add(counts, draw_light(side));
    add(counts, draw_scene(tile));
  };
  target_.draw_tiles([&](const PixelRect& drawn) {
    draw_side(right, drawn);
    split_.keep_right(target_.tile());
    draw_side(left, drawn);
    split_.keep_left(target_.tile());
    keep_to_part();
    add(counts, split_.draw(target_.tile(), part_of(split, size(), drawn)));
    glDisable(GL_SCISSOR_TEST);
  });
  splits_ = false;
  return counts;
}

DrawCounts Renderer::draw_light(const CrowdFrame& frame) {
  if (!frame.fill_pixels) glEnable(GL_RASTERIZER_DISCARD);
  sky_.bind(frame.light);
  ShadowUniforms uniforms{};
  DrawCounts counts;
  const DepthRange depths = frame.shadows || frame.crowd_shade ? depths_of(frame) : DepthRange{};
  const bool shadows = frame.shadows && casts_shadows(frame.light);
  if (shadows) {
    const bool in_turns = context_->window() != nullptr && !splits_;
    const auto draw_scenery = [&](const Cascade& cascade) {
      return frame.scenery ? scenery_.draw_depth(cascade.to_clip, cascade.texel) : DrawCounts{};
    };
    add(counts, shadows_.draw(frame, meshes_, palettes_, {sky_.uniforms().to_sun, depths, in_turns}, draw_scenery));
    shadows_.describe(frame, uniforms);
    frame_data_.bind_drawn();
  }
  if (frame.crowd_shade) {
    add(counts, crowd_shade_.draw(frame, depths.farthest));
    crowd_shade_.describe(uniforms);
  }
  if (frame.scenery) lamps_.describe(uniforms);
  const bool lamps = frame.scenery && lamps_.has_lamps() && sky_.uniforms().night > 0.0F;
  light_parts_ = (shadows ? shadow_part : 0U) | (frame.crowd_shade ? crowd_shade_part : 0U) | (lamps ? lamp_part : 0U);
  glNamedBufferSubData(shadow_uniforms_.id(), 0, sizeof uniforms, &uniforms);
  glBindBufferBase(GL_UNIFORM_BUFFER, shadow_uniforms_binding, shadow_uniforms_.id());
  glDisable(GL_RASTERIZER_DISCARD);
  return counts;
}

void Renderer::keep_to_part() const {
  if (!part_) return;
  const PixelRect& place = part_->place;
  glEnable(GL_SCISSOR_TEST);
  glScissor(place.corner.x, place.corner.y, place.size.x, place.size.y);
}

DrawCounts Renderer::draw_scene(const CrowdFrame& frame) {
  assert(!meshes_.empty());
  const ImageTarget& target = target_.tile();
  target.bind_scene();
  target.clear_scene(part_ ? light_of(part_->around) : glm::vec3(0.0F));
  keep_to_part();
  if (!frame.fill_pixels) glEnable(GL_RASTERIZER_DISCARD);
  crowd_.begin(frame, light_parts_);
  // From near to far, as a rule: hidden surfaces then cost little on a processor.
  DrawCounts counts = crowd_.draw(frame, meshes_, palettes_);
  if (frame.scenery) add(counts, draw_scenery(frame, target.size()));
  add(counts, ground_.draw(frame.ground, target.size(), light_parts_));
  const bool streaks = !frame.shadows && casts_shadows(frame.light);
  add(counts, ground_.draw_spots(static_cast<std::uint32_t>(frame.instances.size()), streaks));
  if (crowd_.has_blended()) {
    blend_.begin(target);
    add(counts, crowd_.draw_blended(meshes_, palettes_));
    add(counts, blend_.finish(target));
  }
  if (frame.bones_as_lines) add(counts, bones_.draw(frame, meshes_, palettes_, target.size()));
  add(counts, lines_.draw(frame.ground_lines, target.size(), false));
  add(counts, lines_.draw(frame.lines, target.size(), true));
  glDisable(GL_RASTERIZER_DISCARD);
  glDisable(GL_SCISSOR_TEST);
  if (!shaders_.status()) trouble_ = shaders_.status().error();
  target.resolve();
  return counts;
}

DrawCounts Renderer::draw_scenery(const CrowdFrame& frame, glm::ivec2 pixels) {
  const PixelRect seen = part_ ? part_->place : PixelRect{{0, 0}, pixels};
  const float height = static_cast<float>(seen.size.y) / frame.scenery_error_px;
  const bool at_vertices = options_.lights_at_vertices && (light_parts_ & (shadow_part | lamp_part)) == 0;
  return scenery_.draw(part_of(frame.camera, pixels, seen), height,
                       light_parts_ | (at_vertices ? scenery_lit_at_vertices : 0U));
}

Status Renderer::prepare_overlay() {
  if (!overlay_) overlay_.emplace(shaders_);
  if (Status uploaded = overlay_->upload_fonts(); !uploaded) return uploaded;
  return shaders_.status();
}

void Renderer::draw_overlay(const ImDrawData& data) {
  assert(overlay_.has_value());
  target_.draw_tiles_over([&](const PixelRect& drawn) {
    target_.tile().bind_overlay();
    overlay_->draw(data, drawn);
  });
}

void Renderer::present() {
  target_.tile().copy_to_window(context_->framebuffer_size());
  context_->swap_buffers();
}

Status Renderer::finish() {
  glFinish();
  Status drawn = gl::take_errors("this picture");
  if (const std::optional<Error> trouble = std::exchange(trouble_, {})) return *trouble;
  return drawn;
}

Status Renderer::set_size(glm::ivec2 size) {
  if (size == target_.size()) return Done{};
  RendererOptions changed = options_;
  changed.size = size;
  Result<TiledTarget> target = create_target(*context_, changed);
  if (!target) return target.error();
  target_ = std::move(*target);
  options_ = changed;
  return Done{};
}

}  // namespace throng::render
