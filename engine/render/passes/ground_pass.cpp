#include "engine/render/passes/ground_pass.h"

#include "engine/render/light/light_parts.h"

namespace throng::render {
namespace {

constexpr GLint sun_side_location = 0;
constexpr GLint pixels_location = 0, half_sides_location = 1, below_horizon_location = 2;
constexpr GLsizei corners_of_a_part = 4;

// Switches of ground.frag, after the light's.
constexpr std::uint32_t street_bit = 1U << light_part_count, pitch_bit = 2U << light_part_count,
                        fields_bit = 4U << light_part_count;

std::uint32_t bit_of(GroundStyle style) {
  return style == GroundStyle::street ? street_bit : style == GroundStyle::pitch ? pitch_bit : 0U;
}

/// Lets pixels be drawn where nothing has been, each of them once. The farthest depth is 0, ground.vert puts the town
/// before the fields and both before that, and nothing else is as far away.
void draw_each_pixel_once() {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  glDisable(GL_CULL_FACE);
}

}  // namespace

GroundPass::GroundPass(ShaderLibrary& shaders)
    : ground_(shaders, {"ground.vert", "ground.frag"}, light_switches({"STREET", "PITCH", "FIELDS"})),
      sky_(shaders.load({"whole_picture.vert", "sky.frag"})),
      spots_(shaders.load({"contact.vert", "contact.frag"})) {}

DrawCounts GroundPass::draw(const SceneGround& ground, glm::ivec2 pixels, std::uint32_t light) {
  draw_each_pixel_once();
  glBindVertexArray(no_vertices_.id());
  const bool has_fields = ground.paved > 0.0F;
  DrawCounts counts = draw_part(light | bit_of(ground.style), ground, pixels, !has_fields);
  if (has_fields) add(counts, draw_part(light | fields_bit, ground, pixels, true));
  glDepthFunc(GL_EQUAL);
  glDepthMask(GL_FALSE);
  glUseProgram(sky_.id());
  glUniform2f(pixels_location, static_cast<float>(pixels.x), static_cast<float>(pixels.y));
  glDrawArrays(GL_TRIANGLES, 0, 3);
  add(counts, {1, 1});
  return counts;
}

DrawCounts GroundPass::draw_part(std::uint32_t switches, const SceneGround& ground, glm::ivec2 pixels,
                                 bool to_horizon) {
  const glm::vec2 half_sides = ground.core + ground.radius + ground.paved;
  glUseProgram(ground_.with(switches).id());
  glUniform2f(pixels_location, static_cast<float>(pixels.x), static_cast<float>(pixels.y));
  glUniform2f(half_sides_location, half_sides.x, half_sides.y);
  glUniform1i(below_horizon_location, to_horizon ? 1 : 0);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, corners_of_a_part);
  return {1, 2};
}

DrawCounts GroundPass::draw_spots(std::uint32_t instance_count, bool with_sun_side) const {
  if (instance_count == 0) return {};
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);  // nearer things have no spots; depth is reversed
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ZERO, GL_SRC_COLOR);
  glUseProgram(spots_.id());
  glUniform1f(sun_side_location, with_sun_side ? 1.0F : 0.0F);
  glBindVertexArray(no_vertices_.id());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, corners_of_a_part, static_cast<GLsizei>(instance_count));
  glDisable(GL_BLEND);
  return {1, std::uint64_t{2} * instance_count};
}

}  // namespace throng::render
