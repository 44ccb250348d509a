#include "engine/render/passes/label_pass.h"

#include <algorithm>
#include <cstddef>

#include <glm/common.hpp>

#include "engine/render/frame/frame_data.h"
#include "engine/render/gl/device_errors.h"
#include "engine/render/passes/crowd_surfaces.h"

namespace throng::render {
namespace {

/// Locations of uniforms of cells.
enum LabelLocation : GLint {
  first_instance_location = 21,
  target_per_picture_location = 22,
  target_pixels_location = 23
};

constexpr float least_label_alpha = 0.5F;  // of a blended surface that counts
constexpr int least_cells_side = 2048;     // pixels

void set_label_state(bool with_depth) {
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  if (with_depth) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);  // depth is reversed
    glDepthMask(GL_TRUE);
  } else {
    glDisable(GL_DEPTH_TEST);
  }
}

void clear_numbers(const gl::Framebuffer& target) {
  constexpr GLuint no_agent[4] = {0, 0, 0, 0};
  glClearNamedFramebufferuiv(target.id(), GL_COLOR, 0, no_agent);
}

void set_label_material(const CrowdMaterial& material) {
  const bool blended = is_blended(material);
  glUniform1f(alpha_cutoff_location, blended ? least_label_alpha : material.alpha_cutoff);
  glUniform4fv(base_color_location, 1, material.base_color);
  glBindTextureUnit(0, material.base_color_texture.image);
  glBindSampler(0, material.base_color_texture.sampler);
}

/// Returns the part of a batch whose instances have a number of at least `first` and below `end`.
CrowdBatch part_of(const CrowdFrame& frame, CrowdBatch batch, std::uint32_t first, std::uint32_t end) {
  std::uint32_t from = std::max(batch.first, first), to = std::min(batch.first + batch.count, end);
  if (!frame.drawn.empty()) {
    const auto begin = frame.drawn.begin(), of_batch = begin + batch.first;
    from = static_cast<std::uint32_t>(std::lower_bound(of_batch, of_batch + batch.count, first) - begin);
    to = static_cast<std::uint32_t>(std::lower_bound(of_batch, of_batch + batch.count, end) - begin);
  }
  batch.first = from;
  batch.count = to - std::min(from, to);
  return batch;
}

/// Turns rows round: the device's first row is the last one of a picture.
template <typename Number>
void turn_rows(std::vector<Number>& numbers, const LabelPicture& picture, glm::ivec2 corner, glm::ivec2 size) {
  for (int row = 0; row < size.y / 2; ++row) {
    Number* const upper = &numbers[picture.place(corner.x, corner.y + row)];
    Number* const lower = &numbers[picture.place(corner.x, corner.y + size.y - 1 - row)];
    std::swap_ranges(upper, upper + size.x, lower);
  }
}

}  // namespace

LabelPass::Programs::Programs(ShaderLibrary& shaders, const std::vector<std::string>& always)
    : labels(shaders, {.vertex = "labels/crowd.vert", .fragment = "labels/crowd.frag", .switches = always},
             {"CUT_OUT", "ALONE"}) {}

LabelPass::LabelPass(ShaderLibrary& shaders) : shaders_(&shaders), plain_(shaders, {}) {}

void LabelPass::prepare_morphs() {
  if (!morphed_) morphed_.emplace(*shaders_, std::vector<std::string>{"MORPHED"});
}

Status LabelPass::prepare(glm::ivec2 size) {
  if (size == size_) return Done{};
  numbers_ = gl::create_texture(GL_R32UI, size.x, size.y);
  depth_ = gl::create_renderbuffer();
  glNamedRenderbufferStorage(depth_.id(), GL_DEPTH_COMPONENT32F, size.x, size.y);
  target_ = gl::create_framebuffer();
  glNamedFramebufferTexture(target_.id(), GL_COLOR_ATTACHMENT0, numbers_.id(), 0);
  glNamedFramebufferRenderbuffer(target_.id(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
  if (Status made = gl::take_errors("the labels of a picture"); !made) return made;
  size_ = size;
  return gl::check_complete(target_.id(), "the labels of a picture");
}

void LabelPass::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, target_.id());
  glViewport(0, 0, size_.x, size_.y);
  set_label_state(true);
  clear_numbers(target_);
  constexpr GLfloat farthest = 0.0F;
  glClearNamedFramebufferfv(target_.id(), GL_DEPTH, 0, &farthest);
}

void LabelPass::draw(const CrowdFrame& frame, std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes) {
  morphs_ = morphed_.has_value() && !frame.morph_weights.empty();
  set_label_state(true);
  compose_surfaces(frame.batches, meshes, draws_, is_any);
  draw_surfaces(meshes, palettes, 0, [] {});
}

void LabelPass::draw_surfaces(std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes, std::uint32_t switches,
                              const auto& set_more) {
  draws_.upload();
  for (const IndirectDraws::Group& group : draws_.groups()) {
    const CrowdMesh& mesh = meshes[group.character];
    const CrowdMaterial& material = mesh.materials()[group.material];
    Programs& programs = morphs_ && mesh.has_morphs() ? *morphed_ : plain_;
    const bool cut_out = material.coverage != Coverage::opaque;
    glUseProgram(programs.labels.with(switches | (cut_out ? cut_out_bit : 0U)).id());
    set_more();
    if (cut_out) set_label_material(material);
    set_culling(material);
    mesh.bind();
    palettes.bind(group.page, palette_binding);
    draws_.draw(group);
  }
  glDisable(GL_CULL_FACE);
  glBindSampler(0, 0);
}

void LabelPass::read(LabelPicture& picture, glm::ivec2 corner, glm::ivec2 size) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, target_.id());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glPixelStorei(GL_PACK_ROW_LENGTH, picture.size.x);
  const std::size_t first = picture.place(corner.x, corner.y);
  glReadPixels(0, 0, size.x, size.y, GL_RED_INTEGER, GL_UNSIGNED_INT, &picture.agents[first]);
  glReadPixels(0, 0, size.x, size.y, GL_DEPTH_COMPONENT, GL_FLOAT, &picture.metres[first]);
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  turn_rows(picture.agents, picture, corner, size);
  turn_rows(picture.metres, picture, corner, size);
}

Status LabelPass::prepare_cells(glm::ivec2 picture) {
  const glm::ivec2 size = glm::clamp(picture, glm::ivec2(least_cells_side), glm::ivec2(2 * least_cells_side));
  if (size == cells_size_) return Done{};
  cells_pixels_ = gl::create_texture(GL_R8UI, size.x, size.y);
  cells_target_ = gl::create_framebuffer();
  glNamedFramebufferTexture(cells_target_.id(), GL_COLOR_ATTACHMENT0, cells_pixels_.id(), 0);
  if (Status made = gl::take_errors("the bodies of a picture"); !made) return made;
  cells_size_ = size;
  return gl::check_complete(cells_target_.id(), "the bodies of a picture");
}

/// Finds a place for a part, row by row. Returns whether there is one: each instance has one part at a time.
bool LabelPass::add_part(std::uint32_t instance, const PixelBox& source) {
  if (!parts_.empty() && parts_.back().instance == instance) return false;
  const glm::ivec2 size(source.width(), source.height());
  if (next_.x + size.x > cells_size_.x) next_ = {0, next_.y + row_height_}, row_height_ = 0;
  if (next_.y + size.y > cells_size_.y) return false;
  parts_.push_back({instance, source, next_});
  next_.x += size.x;
  row_height_ = std::max(row_height_, size.y);
  return true;
}

void LabelPass::begin_page() {
  parts_.clear();
  next_ = {0, 0};
  row_height_ = 0;
}

Status LabelPass::measure(const CrowdFrame& frame, std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes,
                          glm::ivec2 picture, std::span<const PixelBox> boxes, std::span<BodyAlone> bodies) {
  if (Status prepared = prepare_cells(picture); !prepared) return prepared;
  morphs_ = morphed_.has_value() && !frame.morph_weights.empty();
  const auto end_page = [&] {
    if (parts_.empty()) return;
    draw_parts(frame, meshes, palettes, picture);
    count_parts(bodies);
    begin_page();
  };
  begin_page();
  std::ranges::fill(bodies, BodyAlone{});
  for (std::uint32_t instance = 0; instance < boxes.size(); ++instance) {
    const PixelBox& box = boxes[instance];
    for (int top = box.top; top < box.bottom; top += cells_size_.y) {
      for (int left = box.left; left < box.right; left += cells_size_.x) {
        const PixelBox part{left, top, std::min(box.right, left + cells_size_.x),
                            std::min(box.bottom, top + cells_size_.y)};
        if (add_part(instance, part)) continue;
        end_page();
        add_part(instance, part);
      }
    }
  }
  end_page();
  return Done{};
}

void LabelPass::draw_parts(const CrowdFrame& frame, std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes,
                           glm::ivec2 picture) {
  const std::uint32_t first = parts_.front().instance, end = parts_.back().instance + 1;
  cells_.assign(end - first, {});
  for (const Part& part : parts_) {
    const glm::ivec2 size(part.source.width(), part.source.height());
    cells_[part.instance - first] = {
        .place = {part.corner, part.corner + size},
        .shift = part.corner - glm::ivec2(part.source.left, picture.y - part.source.bottom)};
  }
  cell_buffer_.upload(cells_);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, cells_binding, cell_buffer_.id());
  batches_.clear();
  for (const CrowdBatch& batch : frame.batches) {
    const CrowdBatch part = part_of(frame, batch, first, end);
    if (part.count > 0) batches_.push_back(part);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, cells_target_.id());
  glViewport(0, 0, cells_size_.x, cells_size_.y);
  set_label_state(false);
  clear_numbers(cells_target_);
  compose_surfaces(batches_, meshes, draws_, is_any);
  const glm::vec2 target(cells_size_);
  draw_surfaces(meshes, palettes, alone_bit, [&] {
    glUniform1ui(first_instance_location, first);
    glUniform2f(target_per_picture_location, target.x / static_cast<float>(picture.x),
                target.y / static_cast<float>(picture.y));
    glUniform2f(target_pixels_location, target.x, target.y);
  });
}

void LabelPass::count_parts(std::span<BodyAlone> bodies) {
  const int rows = std::min(next_.y + row_height_, cells_size_.y);
  covered_.resize(static_cast<std::size_t>(cells_size_.x) * static_cast<std::size_t>(rows));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, cells_target_.id());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, cells_size_.x, rows, GL_RED_INTEGER, GL_UNSIGNED_BYTE, covered_.data());
  for (const Part& part : parts_) {
    for (int y = 0; y < part.source.height(); ++y) count_row(part, y, bodies[part.instance]);
  }
}

/// Counts the pixels that a row of a part covers, counted from its top.
void LabelPass::count_row(const Part& part, int y, BodyAlone& body) const {
  const auto row = static_cast<std::size_t>(part.corner.y + part.source.height() - 1 - y);
  const auto begin = row * static_cast<std::size_t>(cells_size_.x) + static_cast<std::size_t>(part.corner.x);
  const std::span<const std::uint8_t> pixels(&covered_[begin], static_cast<std::size_t>(part.source.width()));
  const auto first = std::ranges::find(pixels, 1);
  if (first == pixels.end()) return;
  auto last = pixels.end();
  while (*(last - 1) != 1) --last;
  const int top = part.source.top + y, left = part.source.left;
  const PixelBox covered{left + static_cast<int>(first - pixels.begin()), top,
                         left + static_cast<int>(last - pixels.begin()), top + 1};
  PixelBox& box = body.box;
  if (body.pixels == 0) box = covered;
  box = {std::min(box.left, covered.left), std::min(box.top, covered.top), std::max(box.right, covered.right),
         std::max(box.bottom, covered.bottom)};
  body.pixels += static_cast<std::uint64_t>(std::count(first, last, 1));
}

}  // namespace throng::render
