#include "engine/render/renderer.h"

#include <cassert>
#include <utility>

#include "engine/render/frame/frame_uniforms.h"

namespace throng::render {
namespace {

gl::Buffer create_frame_uniforms() {
  gl::Buffer buffer = gl::create_buffer();
  glNamedBufferStorage(buffer.id(), sizeof(FrameUniforms), nullptr, GL_DYNAMIC_STORAGE_BIT);
  return buffer;
}

void add(DrawCounts& sum, const DrawCounts& more) {
  sum.draw_calls += more.draw_calls;
  sum.triangles += more.triangles;
}

}  // namespace

Result<std::unique_ptr<Renderer>> Renderer::create(gl::Context& context, const RendererOptions& options) {
  auto shaders = std::make_unique<ShaderLibrary>(options.data / "shaders");
  Result<GroundPass> ground = GroundPass::create(*shaders);
  if (!ground) return ground.error();
  Result<ContactPass> contact = ContactPass::create(*shaders);
  if (!contact) return contact.error();
  Result<CrowdPass> crowd = CrowdPass::create(*shaders);
  if (!crowd) return crowd.error();
  Result<LinePass> lines = LinePass::create(*shaders);
  if (!lines) return lines.error();
  Result<SplitPass> split = SplitPass::create(*shaders);
  if (!split) return split.error();
  Result<SkinningReadBack> reader = SkinningReadBack::create(*shaders);
  if (!reader) return reader.error();
  return std::unique_ptr<Renderer>(new Renderer(context, options, std::move(shaders), std::move(*ground),
                                                std::move(*contact), std::move(*crowd), std::move(*lines),
                                                std::move(*split), *reader));
}

Renderer::Renderer(gl::Context& context, const RendererOptions& options, std::unique_ptr<ShaderLibrary> shaders,
                   GroundPass ground, ContactPass contact, CrowdPass crowd, LinePass lines, SplitPass split,
                   SkinningReadBack reader)
    : context_(&context),
      shaders_(std::move(shaders)),
      ground_(std::move(ground)),
      contact_(std::move(contact)),
      crowd_(std::move(crowd)),
      lines_(std::move(lines)),
      split_(std::move(split)),
      read_back_(reader),
      target_(options.size, options.samples),
      frame_uniforms_(create_frame_uniforms()),
      shadows_(options.shadows) {}

Renderer::~Renderer() = default;

Status Renderer::load_characters(std::span<const CrowdMeshData> characters) {
  assert(!characters.empty() && characters.size() <= most_characters);
  std::vector<CrowdMesh> meshes;
  for (const CrowdMeshData& data : characters) {
    Result<CrowdMesh> mesh = CrowdMesh::create(data);
    if (!mesh) return mesh.error();
    meshes.push_back(std::move(*mesh));
  }
  meshes_ = std::move(meshes);
  return Done{};
}

void Renderer::reset_palette_pages() {
  finish();
  palettes_ = PaletteBuffer();
}

void Renderer::upload(const CrowdFrame& frame) {
  const FrameUniforms uniforms = frame_uniforms(frame.camera, frame.now);
  glNamedBufferSubData(frame_uniforms_.id(), 0, sizeof(uniforms), &uniforms);
  glBindBufferBase(GL_UNIFORM_BUFFER, frame_uniforms_binding, frame_uniforms_.id());
  instances_.upload(frame.instances);
}

std::vector<ReadBackVertex> Renderer::read_back(const CrowdFrame& frame, const ReadBackAgent& agent) {
  assert(agent.character < meshes_.size() && agent.instance < frame.instances.size());
  upload(frame);
  // OpenGL captures no vertices without a framebuffer, and without a window ours is the only one.
  target_.bind_overlay();
  return read_back_.read(agent, meshes_[agent.character], palettes_);
}

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
  if (!frame.fill_pixels) glEnable(GL_RASTERIZER_DISCARD);
  ground_.draw();
  DrawCounts counts{1, 1};
  if (shadows_) add(counts, crowd_.draw_shadows(frame, meshes_, palettes_));
  add(counts, contact_.draw(static_cast<std::uint32_t>(frame.instances.size()), !shadows_));
  add(counts, crowd_.draw(frame, meshes_, palettes_));
  add(counts, lines_.draw(frame.lines, target_.size()));
  glDisable(GL_RASTERIZER_DISCARD);
  target_.resolve();
  return counts;
}

Status Renderer::prepare_overlay() {
  if (!overlay_) {
    Result<OverlayRenderer> overlay = OverlayRenderer::create(*shaders_);
    if (!overlay) return overlay.error();
    overlay_ = std::move(*overlay);
  }
  overlay_->upload_fonts();
  return Done{};
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

void Renderer::set_samples(int samples) {
  if (samples != target_.samples()) target_ = ImageTarget(target_.size(), samples);
}

}  // namespace throng::render
