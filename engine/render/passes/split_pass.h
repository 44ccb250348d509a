#pragma once

#include <glm/vec2.hpp>

#include "throng/render/crowd_draw.h"

#include "engine/render/frame/image_target.h"
#include "engine/render/shader/shader_library.h"

namespace throng::render {

/// Puts two finished pictures side by side into one, with a line between them. It keeps a copy of each, so that both
/// can be drawn into the same target.
class SplitPass {
 public:
  explicit SplitPass(ShaderLibrary& shaders) : program_(shaders.load({"whole_picture.vert", "split.frag"})) {}

  void keep_left(const ImageTarget& picture) { keep(left_, picture); }
  void keep_right(const ImageTarget& picture) { keep(right_, picture); }

  /// Draws over all finished pixels of `target`. Both sides must be kept and have its size.
  DrawCounts draw(const ImageTarget& target, const SplitView& split) const;
  /// Gives back the memory of both sides.
  void forget_sides() { left_ = {}, right_ = {}; }

 private:
  struct Side {
    gl::Texture pixels;
    glm::ivec2 size{0};
  };

  static void keep(Side& side, const ImageTarget& picture);

  const gl::Program& program_;
  gl::VertexArray no_vertices_ = gl::create_vertex_array();
  Side left_, right_;  // without storage while no split is drawn
};

}  // namespace throng::render
