#include "engine/render/renderer.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace throng::render {
namespace {

void add(DrawCounts& sum, const DrawCounts& more) {
  sum.draw_calls += more.draw_calls;
  sum.triangles += more.triangles;
}

}  // namespace

Result<std::unique_ptr<Renderer>> Renderer::create(gl::Context& context, const RendererOptions& options) {
  std::unique_ptr<Renderer> renderer(new Renderer(context, options));
  if (const Status& built = renderer->shaders_.status(); !built) return built.error();
  return renderer;
}

Renderer::Renderer(gl::Context& context, const RendererOptions& options)
    : context_(&context),
      shaders_(options.data / "shaders"),
      target_(options.size, options.samples),
      shadows_(options.shadows) {}

Status Renderer::load_characters(std::span<const CrowdMeshData> characters) {
  assert(!characters.empty() && characters.size() <= most_characters);
  std::vector<CrowdMesh> meshes;
  for (const CrowdMeshData& data : characters) {
    Result<CrowdMesh> mesh = CrowdMesh::create(data);
    if (!mesh) return mesh.error();
    meshes.push_back(std::move(*mesh));
  }
  if (std::ranges::any_of(meshes, &CrowdMesh::has_morphs)) {
    crowd_.prepare_morphs();
    if (!shaders_.status()) return shaders_.status().error();
  }
  meshes_ = std::move(meshes);
  return Done{};
}

void Renderer::reset_palette_pages() {
  finish();
  palettes_ = PaletteBuffer();
}

void Renderer::upload(const CrowdFrame& frame) { frame_data_.upload(frame); }

DrawCounts Renderer::draw(const CrowdFrame& frame) {
  upload(frame);
  return draw_uploaded(frame);
}

DrawCounts Renderer::draw_split(const CrowdFrame& left, const CrowdFrame& right, const SplitView& split) {
  DrawCounts counts = draw(right);
  split_.keep_right(target_);
  add(counts, draw(left));
  split_.keep_left(target_);
  add(counts, split_.draw(target_, split));
  return counts;
}

DrawCounts Renderer::draw_uploaded(const CrowdFrame& frame) {
  assert(!meshes_.empty());
  target_.bind_scene();
  target_.clear_scene();
  if (!frame.fill_pixels) glEnable(GL_RASTERIZER_DISCARD);
  crowd_.begin(frame);
  DrawCounts counts = ground_.draw();
  if (shadows_) add(counts, crowd_.draw_shadows(frame, meshes_, palettes_));
  add(counts, ground_.draw_spots(static_cast<std::uint32_t>(frame.instances.size()), !shadows_));
  add(counts, crowd_.draw(frame, meshes_, palettes_));
  if (crowd_.has_blended()) {
    blend_.begin(target_);
    add(counts, crowd_.draw_blended(meshes_, palettes_));
    add(counts, blend_.finish(target_));
  }
  add(counts, lines_.draw(frame.lines, target_.size()));
  glDisable(GL_RASTERIZER_DISCARD);
  target_.resolve();
  return counts;
}

Status Renderer::prepare_overlay() {
  if (!overlay_) overlay_.emplace(shaders_);
  overlay_->upload_fonts();
  return shaders_.status();
}

void Renderer::draw_overlay(const ImDrawData& data) {
  assert(overlay_.has_value());
  target_.bind_overlay();
  overlay_->draw(data);
}

void Renderer::present() {
  target_.copy_to_window(context_->framebuffer_size());
  context_->swap_buffers();
}

void Renderer::finish() { glFinish(); }

void Renderer::set_size(glm::ivec2 size) {
  if (size != target_.size()) target_ = ImageTarget(size, target_.samples());
}

}  // namespace throng::render
