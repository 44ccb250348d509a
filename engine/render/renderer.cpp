#include "throng/render/renderer.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

#include "engine/base/files/free_memory.h"
#include "engine/render/gl/device_errors.h"
#include "engine/render/renderer_parts.h"

namespace throng::render {
namespace {

// Colours, depths, blended surfaces, and the two sides of a split view.
std::uint64_t bytes_a_pixel(int samples) {
  constexpr std::uint64_t bytes_a_sample = 4 + 8 + 10, bytes_of_sides = 8, bytes_of_finished = 4;
  return bytes_a_sample * static_cast<std::uint64_t>(std::max(samples, 1)) + bytes_of_sides + bytes_of_finished;
}

Result<TiledTarget> create_target(const gl::Context& context, const RendererOptions& options, bool whole) {
  const gl::DeviceLimits& device = context.limits();
  if (options.samples > device.samples) {
    return Error{"the graphics device takes at most " + std::to_string(device.samples) + " samples a pixel, not " +
                 std::to_string(options.samples)};
  }
  const TileLimits limits{.longest = whole ? device.target : glm::min(device.target, glm::ivec2(options.longest_tile)),
                          .memory = free_memory(),
                          .bytes_a_pixel = context.is_software() ? bytes_a_pixel(options.samples) : 0,
                          .bytes_beside = options.lens ? AveragedPicture::bytes_a_pixel : 0,
                          .whole = whole};
  return TiledTarget::create(options.size, options.samples, limits);
}

}  // namespace

Result<std::unique_ptr<Renderer>> Renderer::create(gl::Context& context, const RendererOptions& options) {
  Result<TiledTarget> target = create_target(context, options, context.window() != nullptr);
  if (!target) return target.error();
  auto parts = std::make_unique<Parts>(context, options, std::move(*target));
  if (const Status& built = parts->shaders.status(); !built) return built.error();
  if (const Status made = gl::take_errors("the parts of a picture"); !made) return made.error();
  return std::unique_ptr<Renderer>(new Renderer(std::move(parts)));
}

Renderer::Renderer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Renderer::~Renderer() = default;

Status Renderer::load_characters(std::span<const CrowdMeshData> characters) {
  return parts_->load_characters(std::vector<CharacterToLoad>(characters.begin(), characters.end()));
}
Status Renderer::load_characters(std::span<const CharacterToLoad> characters) {
  return parts_->load_characters(characters);
}

std::span<const CrowdMesh> Renderer::meshes() const { return parts_->meshes; }
MeshLodList Renderer::mesh_lods(std::size_t character) const {
  const CrowdMesh& mesh = parts_->meshes[character];
  return {.errors = mesh.error_by_lod(), .triangles = mesh.triangles_by_lod()};
}

Status Renderer::load_scenery(std::span<const SceneryMeshData> meshes) { return parts_->scenery.load(meshes); }
void Renderer::place_scenery(std::span<const SceneryInstance> instances) { parts_->scenery.place(instances); }
void Renderer::place_lamps(std::span<const SceneryLamp> lamps) { parts_->lamps.place(lamps); }

PalettePageSource& Renderer::palette_pages() { return parts_->palettes; }
void Renderer::bind_palette_page(std::uint32_t page, unsigned binding) const { parts_->palettes.bind(page, binding); }

void Renderer::reset_palette_pages() {
  glFinish();
  parts_->palettes.take_back_pages();
}

void Renderer::end_frame(std::uint64_t frame) { parts_->fences.insert(frame); }

std::uint64_t Renderer::completed_frame(std::uint64_t newest) {
  const std::uint64_t drawn = parts_->fences.poll();
  return parts_->fences.frames_in_flight() == 0 ? newest : drawn;
}

void Renderer::upload(const CrowdFrame& frame) { parts_->upload(frame); }

DrawCounts Renderer::draw(const CrowdFrame& frame) {
  upload(frame);
  return draw_uploaded(frame);
}

DrawCounts Renderer::draw_uploaded(const CrowdFrame& frame) {
  parts_->split.forget_sides();
  DrawCounts counts = parts_->draw_light(frame);
  const std::optional<Lens>& lens = parts_->options.lens;
  add(counts, lens ? parts_->draw_through_lens(frame, *lens) : parts_->draw_tiles(frame));
  return counts;
}

DrawCounts Renderer::draw_split(const CrowdFrame& left, const CrowdFrame& right, const SplitView& split) {
  return parts_->draw_split(left, right, split);
}

Status Renderer::draw_labels(const CrowdFrame& frame, LabelPicture& labels) {
  return parts_->draw_labels(frame, labels);
}

Status Renderer::measure_bodies(const CrowdFrame& frame, std::span<const PixelBox> boxes, std::span<BodyAlone> bodies) {
  return parts_->measure_bodies(frame, boxes, bodies);
}

void Renderer::draw_only(const PixelRect& part, std::uint32_t around) { parts_->part = {part, around}; }

Status Renderer::prepare_overlay() {
  if (!parts_->overlay) parts_->overlay.emplace(parts_->shaders);
  if (Status uploaded = parts_->overlay->upload_fonts(); !uploaded) return uploaded;
  return parts_->shaders.status();
}

void Renderer::draw_overlay(const ImDrawData& data, bool keeps_around) {
  assert(parts_->overlay.has_value());
  if (!parts_->stretched) {
    return parts_->target.draw_tiles_over([&](const PixelRect& drawn) {
      parts_->target.tile().bind_overlay();
      parts_->overlay->draw(data, drawn);
    });
  }
  parts_->stretch(keeps_around);
  parts_->stretched->bind_overlay();
  const PixelRect whole{{0, 0}, size()};
  parts_->overlay->draw(data, whole, keeps_around ? parts_->seen_part(size()) : whole);
}

void Renderer::present() {
  parts_->finished().copy_to_window(context().framebuffer_size());
  context().swap_buffers();
}

const Image& Renderer::read_image() {
  if (!parts_->stretched) return parts_->target.read();
  parts_->stretched_image = Image::blank(size().x, size().y);
  parts_->stretched->read(parts_->stretched_image, {{0, 0}, size()});
  return parts_->stretched_image;
}
Status Renderer::finish() { return parts_->finish(); }

Status Renderer::set_size(glm::ivec2 size, std::optional<glm::ivec2> drawn_size) {
  const glm::ivec2 drawn = drawn_size.value_or(size);
  if (!parts_->draws_stills && size == parts_->size() && drawn == parts_->target.size()) return Done{};
  RendererOptions changed = parts_->options;
  changed.size = drawn;
  Result<TiledTarget> target = create_target(context(), changed, context().window() != nullptr);
  if (!target) return target.error();
  std::optional<ImageTarget> stretched;
  if (drawn != size) {
    Result<ImageTarget> made = ImageTarget::create(size, 0);
    if (!made) return made.error();
    stretched = std::move(*made);
  }
  parts_->target = std::move(*target);
  parts_->stretched = std::move(stretched);
  parts_->options = changed;
  parts_->draws_stills = false;
  return Done{};
}

Status Renderer::set_still(glm::ivec2 size, int samples) {
  RendererOptions still = parts_->options;
  still.size = size;
  still.samples = samples;
  Result<TiledTarget> target = create_target(context(), still, false);
  if (!target) return target.error();
  parts_->target = std::move(*target);
  parts_->stretched.reset();
  parts_->part.reset();
  parts_->draws_stills = true;
  return Done{};
}

glm::ivec2 Renderer::size() const { return parts_->size(); }
Status Renderer::reload_shaders() { return parts_->shaders.reload(); }
bool Renderer::shaders_are_out_of_date() const { return parts_->shaders.is_out_of_date(); }
gl::Context& Renderer::context() { return *parts_->context; }

}  // namespace throng::render
