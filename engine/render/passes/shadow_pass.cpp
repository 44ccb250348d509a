#include "engine/render/passes/shadow_pass.h"

#include <algorithm>

#include "engine/render/frame/frame_data.h"
#include "engine/render/passes/crowd_runs.h"

namespace throng::render {
namespace {

/// Locations of uniforms, as in every program of the crowd, and the one of a shadow map.
enum ShadowLocation : GLint { shadow_color_location = 1, shadow_cutoff_location = 2, shadow_matrix_location = 20 };

constexpr float shadow_alpha = 0.5F;  // least of a blended surface that casts a shadow
constexpr int all_opaque = -1;        // a group's material

// Frames from one drawing of a cascade to the next, where they take turns, and the frame in which it begins.
constexpr std::array<std::uint32_t, cascade_count> turns{1, 1, 2, 4}, first_turns{0, 0, 0, 1};

gl::Texture create_maps() {
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &id);
  glTextureStorage3D(id, 1, GL_DEPTH_COMPONENT16, ShadowPass::map_side, ShadowPass::map_side, cascade_count);
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(id, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTextureParameteri(id, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return gl::Texture(id);
}

gl::Framebuffer create_target(const gl::Texture& maps, int layer) {
  gl::Framebuffer target = gl::create_framebuffer();
  glNamedFramebufferTextureLayer(target.id(), GL_DEPTH_ATTACHMENT, maps.id(), 0, layer);
  glNamedFramebufferDrawBuffer(target.id(), GL_NONE);
  return target;
}

void set_state() {
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glViewport(0, 0, ShadowPass::map_side, ShadowPass::map_side);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  // A thing between the sun and the beginning of the map still casts its shadow.
  glEnable(GL_DEPTH_CLAMP);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.5F, 2.0F);
}

/// Says whether a run has batches that stand in for its agents' pieces, and a texel hides the difference.
bool stand_ins_suffice(std::span<const CrowdBatch> run, const CrowdMesh& mesh, float texel) {
  bool has_any = false;
  for (const CrowdBatch& batch : run) {
    if (!batch.stands_in) continue;
    has_any = true;
    const MeshError& error = mesh.error(batch.piece, first_silhouette_lod);
    if (std::max(error.surface, error.face) > texel) return false;
  }
  return has_any;
}

/// Says whether a batch casts shadows, where stand-ins do or do not.
bool casts(const CrowdBatch& batch, bool stand_ins) {
  const bool is_near_piece = batch.piece != 0 && batch.mesh_lod < first_silhouette_lod;
  return !is_near_piece || batch.stands_in == stand_ins;
}

bool is_opaque(const CrowdMesh& mesh, int material) { return mesh.materials()[material].coverage == Coverage::opaque; }

}  // namespace

ShadowPass::Programs::Programs(ShaderLibrary& shaders, const std::vector<std::string>& switches)
    : opaque(shaders.load({.vertex = "shadow_map.vert", .fragment = "depth_only.frag", .switches = switches})),
      cut_out(
          shaders.load({.vertex = "shadow_map.vert", .fragment = "shadow_map_cut_out.frag", .switches = switches})) {}

ShadowPass::ShadowPass(ShaderLibrary& shaders) : shaders_(&shaders), plain_(shaders, {}) {}

void ShadowPass::prepare_morphs() {
  if (!morphed_) morphed_.emplace(*shaders_, std::vector<std::string>{"MORPHED"});
}

bool ShadowPass::is_due(int cascade, bool in_turns) const {
  const auto i = static_cast<std::size_t>(cascade);
  return !in_turns || turn_ % turns.at(i) == first_turns.at(i);
}

void ShadowPass::plan(const CrowdFrame& frame, const Light& light) {
  const SunAxes axes = sun_axes(light.to_sun);
  const bool other = light.depths != depths_ || axes.z != axes_.z;
  depths_ = light.depths;
  axes_ = axes;
  const auto planned = plan_cascades(frame.camera, axes_, depths_, map_side);
  ++turn_;
  for (int i = 0; i < cascade_count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    drawn_now_.at(at) = other || is_due(i, light.in_turns);
    if (drawn_now_.at(at)) cascades_.at(at) = planned.at(at);
  }
}

DrawCounts ShadowPass::draw_crowd(const CrowdFrame& frame, std::span<const CrowdMesh> meshes,
                                  const PaletteBuffer& palettes, const Light& light) {
  if (!maps_) {
    maps_ = create_maps();
    for (int i = 0; i < cascade_count; ++i) targets_.at(static_cast<std::size_t>(i)) = create_target(maps_, i);
  }
  morphs_ = morphed_.has_value() && !frame.morph_weights.empty();
  plan(frame, light);
  gather(frame, meshes);
  set_state();
  caster_buffer_.upload(casters_.all());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, drawn_binding, caster_buffer_.id());
  draws_.upload();
  for (int i = 0; i < cascade_count; ++i) {
    if (drawn_now_.at(static_cast<std::size_t>(i))) draw_cascade(i, meshes, palettes);
  }
  return draws_.counts();
}

void ShadowPass::end() {
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDisable(GL_DEPTH_CLAMP);
  glBindSampler(0, 0);
}

void ShadowPass::gather(const CrowdFrame& frame, std::span<const CrowdMesh> meshes) {
  reaches_.clear();
  for (const CrowdMesh& mesh : meshes) reaches_.push_back(mesh.reach(!frame.drawn.empty()));
  casters_.choose(frame, reaches_, axes_, cast_limits(cascades_, axes_, drawn_now_));
  draws_.clear();
  std::uint32_t first_caster = 0;
  for (std::size_t cascade = 0; cascade < cascade_count; ++cascade) {
    first_group_.at(cascade) = static_cast<std::uint32_t>(draws_.groups().size());
    std::size_t first_batch = 0;
    for_each_run(frame.batches, [&](std::span<const CrowdBatch> run) {
      gather_run(run, {cascade, first_batch}, meshes[run[0].character], first_caster);
      first_batch += run.size();
    });
  }
  first_group_.back() = static_cast<std::uint32_t>(draws_.groups().size());
}

// Makes one group of all opaque materials, and one of each other.
void ShadowPass::gather_run(std::span<const CrowdBatch> run, CastersOfRun of, const CrowdMesh& mesh,
                            std::uint32_t& first_caster) {
  const float texel = cascades_.at(of.cascade).texel / std::max(casters_.largest_scale(), 1e-6F);
  const bool stand_ins = stand_ins_suffice(run, mesh, texel);
  caster_batches_.clear();
  for (CrowdBatch batch : run) {
    const bool is_caster = casts(batch, stand_ins);
    batch.mesh_lod = static_cast<std::uint8_t>(std::max<int>(batch.mesh_lod, mesh.coarsest_lod(batch.piece, texel)));
    batch.first = first_caster;
    batch.count = casters_.count(of.cascade, of.first_batch++);
    first_caster += batch.count;
    if (is_caster && batch.count > 0) caster_batches_.push_back(batch);
  }
  const auto add_group = [&](int group, const auto& is_wanted) {
    draws_.begin_group(run[0].page, run[0].character, group);
    for (const CrowdBatch& batch : caster_batches_) {
      for (const MaterialRun& triangles : mesh.runs(batch.piece, batch.mesh_lod)) {
        if (is_wanted(triangles.material)) draws_.add(triangles, batch);
      }
    }
  };
  if (caster_batches_.empty()) return;
  add_group(all_opaque, [&](int material) { return is_opaque(mesh, material); });
  for (int material = 0; material < mesh.materials().size(); ++material) {
    if (!is_opaque(mesh, material)) add_group(material, [material](int of_run) { return of_run == material; });
  }
}

void ShadowPass::draw_cascade(int cascade, std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes) {
  const auto at = static_cast<std::size_t>(cascade);
  glBindFramebuffer(GL_FRAMEBUFFER, targets_.at(at).id());
  constexpr GLfloat farthest = 1.0F;
  glClearNamedFramebufferfv(targets_.at(at).id(), GL_DEPTH, 0, &farthest);
  const std::span<const IndirectDraws::Group> groups = draws_.groups();
  for (std::uint32_t i = first_group_.at(at); i < first_group_.at(at + 1); ++i) {
    const CrowdMesh& mesh = meshes[groups[i].character];
    use_program(mesh, groups[i].material, cascade);
    mesh.bind();
    palettes.bind(groups[i].page, palette_binding);
    draws_.draw(groups[i]);
  }
}

void ShadowPass::use_program(const CrowdMesh& mesh, int material, int cascade) const {
  const Programs& programs = morphs_ && mesh.has_morphs() ? *morphed_ : plain_;
  glUseProgram(material == all_opaque ? programs.opaque.id() : programs.cut_out.id());
  const glm::mat4& matrix = cascades_.at(static_cast<std::size_t>(cascade)).to_clip;
  glUniformMatrix4fv(shadow_matrix_location, 1, GL_FALSE, &matrix[0][0]);
  if (material == all_opaque) return;
  const CrowdMaterial& cut_out = mesh.materials()[material];
  const bool blended = cut_out.coverage == Coverage::blended;
  glUniform1f(shadow_cutoff_location, blended ? shadow_alpha : cut_out.alpha_cutoff);
  glUniform4fv(shadow_color_location, 1, cut_out.base_color);
  glBindTextureUnit(0, cut_out.base_color_texture.image);
  glBindSampler(0, cut_out.base_color_texture.sampler);
}

void ShadowPass::describe(const CrowdFrame& frame, ShadowUniforms& uniforms) const {
  const glm::mat4 to_map(glm::vec4(0.5F, 0.0F, 0.0F, 0.0F), glm::vec4(0.0F, 0.5F, 0.0F, 0.0F),
                         glm::vec4(0.0F, 0.0F, 1.0F, 0.0F), glm::vec4(0.5F, 0.5F, 0.0F, 1.0F));
  for (int i = 0; i < cascade_count; ++i) {
    const Cascade& cascade = cascades_.at(static_cast<std::size_t>(i));
    uniforms.to_map[i] = to_map * cascade.to_clip;
    uniforms.reach[i] = cascade.reach;
    uniforms.texel[i] = cascade.texel;
  }
  const glm::mat4& view = frame.camera.view;
  uniforms.depth = -glm::vec4(view[0][2], view[1][2], view[2][2], view[3][2]);
  glBindTextureUnit(shadow_maps_unit, maps_.id());
}

}  // namespace throng::render
