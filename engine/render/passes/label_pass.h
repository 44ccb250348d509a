#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "throng/render/crowd_draw.h"
#include "throng/render/label_picture.h"

#include "engine/base/result.h"
#include "engine/render/gl/handles.h"
#include "engine/render/mesh/mesh.h"
#include "engine/render/palette/palette_buffer.h"
#include "engine/render/passes/indirect_draws.h"
#include "engine/render/shader/program_variants.h"

namespace throng::render {

/// Draws numbers in place of colours: the agent at each pixel, and what each agent would cover if nothing hid it.
/// There is one sample a pixel. A blended surface counts as solid from an alpha of one half on. Frame data must be
/// bound.
class LabelPass {
 public:
  /// `shaders` must outlive the pass.
  explicit LabelPass(ShaderLibrary& shaders);

  /// Makes ready for meshes that morph; see CrowdPass.
  void prepare_morphs();
  /// Makes a target for pictures of that size, or keeps its present one. Errors: the device has no memory for it.
  Status prepare(glm::ivec2 size);

  /// Begins a picture: binds the target and empties it of agents.
  void begin() const;
  /// Draws numbers and depths of the crowd over the depths that are there.
  void draw(const CrowdFrame& frame, std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes);
  /// Reads the first `size` pixels into a place of a larger picture, which is counted from its top left; the first row
  /// of the target is the last one there. Depths are as the device has them.
  void read(LabelPicture& picture, glm::ivec2 corner, glm::ivec2 size);

  /// Measures the pixels that each instance of a frame covers in a picture of that size, inside of its box of `boxes`,
  /// which holds it. The view of the whole picture must be bound. Errors: the device has no memory for it.
  Status measure(const CrowdFrame& frame, std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes,
                 glm::ivec2 picture, std::span<const PixelBox> boxes, std::span<BodyAlone> bodies);

 private:
  /// As `shaders/labels/crowd.vert` reads it.
  struct Cell {
    glm::ivec4 place{0};
    glm::ivec2 shift{0};
    glm::ivec2 unused{0};
  };
  /// A part of a box, in the target that several share.
  struct Part {
    std::uint32_t instance;
    PixelBox source;    // in the picture
    glm::ivec2 corner;  // in the target, from its bottom left
  };
  struct Programs {
    Programs(ShaderLibrary& shaders, const std::vector<std::string>& always);
    ProgramVariants labels;
  };
  enum Switch : std::uint32_t { cut_out_bit = 1, alone_bit = 2 };

  Status prepare_cells(glm::ivec2 picture);
  bool add_part(std::uint32_t instance, const PixelBox& source);
  void draw_parts(const CrowdFrame& frame, std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes,
                  glm::ivec2 picture);
  void begin_page();
  void count_parts(std::span<BodyAlone> bodies);
  void count_row(const Part& part, int y, BodyAlone& body) const;
  void draw_surfaces(std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes, std::uint32_t switches,
                     const auto& set_more);

  ShaderLibrary* shaders_;
  Programs plain_;
  std::optional<Programs> morphed_;
  bool morphs_ = false;
  IndirectDraws draws_;
  std::vector<CrowdBatch> batches_;  // of the instances in parts_

  glm::ivec2 size_{0};
  gl::Texture numbers_;
  gl::Renderbuffer depth_;
  gl::Framebuffer target_;

  glm::ivec2 cells_size_{0};
  gl::Texture cells_pixels_;
  gl::Framebuffer cells_target_;
  std::vector<Part> parts_;
  glm::ivec2 next_{0};  // where the next part goes
  int row_height_ = 0;  // of the parts in the last row
  std::vector<Cell> cells_;
  gl::GrowingBuffer<Cell> cell_buffer_;
  std::vector<std::uint8_t> covered_;  // pixels of cells_pixels_
};

}  // namespace throng::render
