#include "engine/render/renderer_parts.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

#include <glm/packing.hpp>

#include "engine/base/srgb.h"
#include "engine/render/gl/device_errors.h"
#include "engine/render/light/light_parts.h"

namespace throng::render {
namespace {

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

Status Renderer::Parts::load_characters(std::span<const CharacterToLoad> characters) {
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
    crowd.prepare_morphs();
    shadows.prepare_morphs();
    if (!shaders.status()) return shaders.status().error();
  }
  if (Status copied = gl::take_errors("the characters; ask for fewer or smaller models"); !copied) return copied;
  std::vector<CrowdMesh> loaded;
  auto next = made.begin();
  for (const CharacterToLoad& character : characters) {
    const auto* const before = std::get_if<std::size_t>(&character);
    loaded.push_back(std::move(before != nullptr ? meshes[*before] : *next++));
  }
  meshes = std::move(loaded);
  return Done{};
}

void Renderer::Parts::upload(const CrowdFrame& frame) {
  const std::size_t limit = context->limits().storage_block;
  if (frame.instances.size_bytes() > limit || frame.looks.size_bytes() > limit ||
      frame.morph_weights.size_bytes() > limit) {
    trouble = Error{"the graphics device takes at most " + std::to_string(limit / sizeof(AgentLook)) +
                    " agents in a picture, or " + std::to_string(limit / sizeof(float)) + " weights of their morphs"};
  }
  frame_data.upload(frame);
}

DrawCounts Renderer::Parts::draw_tiles(const CrowdFrame& frame) {
  DrawCounts counts;
  target.draw_tiles([&](const PixelRect& drawn) {
    const CrowdFrame tile = part_of(frame, target.size(), drawn);
    if (target.is_tiled() || options.lens) frame_data.upload_view(tile);
    add(counts, draw_scene(tile));
  });
  return counts;
}

DrawCounts Renderer::Parts::draw_through_lens(const CrowdFrame& frame, const Lens& lens) {
  DrawCounts counts;
  AveragedPicture average;
  const float radius = radius_of(lens, frame.camera);
  for (int point = 0; point < lens.points; ++point) {
    CrowdFrame seen = frame;
    seen.camera = seen_through(frame.camera, radius * point_of_disc(point, lens.points), lens.focus);
    add(counts, draw_tiles(seen));
    average.add(target.read());
  }
  target.write(average.finish());
  return counts;
}

DrawCounts Renderer::Parts::draw_split(const CrowdFrame& left, const CrowdFrame& right, const SplitView& view) {
  DrawCounts counts;
  splits = true;
  const auto draw_side = [&](const CrowdFrame& side, const PixelRect& drawn) {
    const CrowdFrame tile = part_of(side, target.size(), drawn);
    upload(tile);
    add(counts, draw_light(side));
    add(counts, draw_scene(tile));
  };
  target.draw_tiles([&](const PixelRect& drawn) {
    draw_side(right, drawn);
    split.keep_right(target.tile());
    draw_side(left, drawn);
    split.keep_left(target.tile());
    keep_to_part(target.size());
    add(counts, split.draw(target.tile(), part_of(view, target.size(), drawn)));
    glDisable(GL_SCISSOR_TEST);
  });
  splits = false;
  return counts;
}

DrawCounts Renderer::Parts::draw_light(const CrowdFrame& frame) {
  if (!frame.fill_pixels) glEnable(GL_RASTERIZER_DISCARD);
  sky.bind(frame.light);
  ShadowUniforms uniforms{};
  DrawCounts counts;
  const DepthRange depths = frame.shadows || frame.crowd_shade ? depths_of(frame) : DepthRange{};
  const bool has_shadows = frame.shadows && casts_shadows(frame.light);
  if (has_shadows) {
    const bool in_turns = context->window() != nullptr && !splits;
    const auto draw_scenery = [&](const Cascade& cascade) {
      return frame.scenery ? scenery.draw_depth(cascade.to_clip, cascade.texel) : DrawCounts{};
    };
    add(counts, shadows.draw(frame, meshes, palettes, {sky.uniforms().to_sun, depths, in_turns}, draw_scenery));
    shadows.describe(frame, uniforms);
    frame_data.bind_drawn();
  }
  if (frame.crowd_shade) {
    add(counts, crowd_shade.draw(frame, depths.farthest));
    crowd_shade.describe(uniforms);
  }
  if (frame.scenery) lamps.describe(uniforms);
  const bool has_lamps = frame.scenery && lamps.has_lamps() && sky.uniforms().night > 0.0F;
  light_parts =
      (has_shadows ? shadow_part : 0U) | (frame.crowd_shade ? crowd_shade_part : 0U) | (has_lamps ? lamp_part : 0U);
  glNamedBufferSubData(shadow_uniforms.id(), 0, sizeof uniforms, &uniforms);
  glBindBufferBase(GL_UNIFORM_BUFFER, shadow_uniforms_binding, shadow_uniforms.id());
  glDisable(GL_RASTERIZER_DISCARD);
  return counts;
}

// Where the picture is stretched, a pixel beyond the edge takes part in the pixels within it.
PixelRect Renderer::Parts::seen_part(glm::ivec2 size_of_target) const {
  if (!part) return {{0, 0}, size_of_target};
  const PixelRect& place = part->place;
  if (size_of_target == size()) return place;
  const glm::vec2 scale = glm::vec2(size_of_target) / glm::vec2(size());
  const glm::ivec2 first = glm::ivec2(glm::floor(glm::vec2(place.corner) * scale)) - 1;
  const glm::ivec2 end = glm::ivec2(glm::ceil(glm::vec2(place.corner + place.size) * scale)) + 1;
  const glm::ivec2 corner = glm::max(first, glm::ivec2(0));
  return {corner, glm::min(end, size_of_target) - corner};
}

void Renderer::Parts::keep_to_part(glm::ivec2 size_of_target) const {
  if (!part) return;
  const PixelRect place = seen_part(size_of_target);
  glEnable(GL_SCISSOR_TEST);
  glScissor(place.corner.x, place.corner.y, place.size.x, place.size.y);
}

void Renderer::Parts::stretch(bool keeps_around) const {
  if (!stretched) return;
  if (part && !keeps_around) stretched->fill(part->around);
  keep_to_part(stretched->size());
  stretched->stretch(target.tile());
  glDisable(GL_SCISSOR_TEST);
}

DrawCounts Renderer::Parts::draw_scene(const CrowdFrame& frame) {
  assert(!meshes.empty());
  const ImageTarget& image = target.tile();
  image.bind_scene();
  image.clear_scene(part ? light_of(part->around) : glm::vec3(0.0F));
  keep_to_part(image.size());
  if (!frame.fill_pixels) glEnable(GL_RASTERIZER_DISCARD);
  crowd.begin(frame, light_parts);
  // From near to far, as a rule: hidden surfaces then cost little on a processor.
  DrawCounts counts = crowd.draw(frame, meshes, palettes);
  if (frame.scenery) add(counts, draw_scenery(frame, image.size()));
  add(counts, ground.draw(frame.ground, image.size(), light_parts));
  const bool streaks = !frame.shadows && casts_shadows(frame.light);
  add(counts, ground.draw_spots(static_cast<std::uint32_t>(frame.instances.size()), streaks));
  if (crowd.has_blended()) {
    blend.begin(image);
    add(counts, crowd.draw_blended(meshes, palettes));
    add(counts, blend.finish(image));
  }
  if (frame.bones_as_lines) add(counts, bones.draw(frame, meshes, palettes, image.size()));
  add(counts, lines.draw(frame.ground_lines, image.size(), false));
  add(counts, lines.draw(frame.lines, image.size(), true));
  glDisable(GL_RASTERIZER_DISCARD);
  glDisable(GL_SCISSOR_TEST);
  if (!shaders.status()) trouble = shaders.status().error();
  image.resolve();
  return counts;
}

DrawCounts Renderer::Parts::draw_scenery(const CrowdFrame& frame, glm::ivec2 pixels) {
  const PixelRect seen = seen_part(pixels);
  const float height = static_cast<float>(seen.size.y) / frame.scenery_error_px;
  const bool at_vertices =
      options.lights_at_vertices && !draws_stills && (light_parts & (shadow_part | lamp_part)) == 0;
  return scenery.draw(part_of(frame.camera, pixels, seen), height,
                      light_parts | (at_vertices ? scenery_lit_at_vertices : 0U));
}

Status Renderer::Parts::finish() {
  glFinish();
  Status drawn = gl::take_errors("this picture");
  if (const std::optional<Error> seen = std::exchange(trouble, {})) return *seen;
  return drawn;
}

}  // namespace throng::render
