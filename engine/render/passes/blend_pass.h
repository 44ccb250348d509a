#pragma once

#include <glm/vec2.hpp>

#include "throng/render/crowd_draw.h"

#include "engine/render/frame/image_target.h"
#include "engine/render/shader/shader_library.h"

namespace throng::render {

/// Lays surfaces that are seen through over a picture, in whatever order they are drawn. It sums them up over the
/// depths of the picture, so that nearer opaque surfaces hide them.
///
///   blend.begin(picture);  ... draw them with crowd_blended.frag ...  blend.finish(picture);
class BlendPass {
 public:
  explicit BlendPass(ShaderLibrary& shaders)
      : average_(shaders.load({"whole_picture.vert", "blended.frag"})),
        average_of_samples_(shaders.load({"whole_picture.vert", "blended_samples.frag"})) {}

  /// Lets later draws add to the sums, which are empty. Opaque surfaces must be drawn before. The first call makes
  /// storage of the picture's size and samples. If the device has none left, drawing is an error of OpenGL, which the
  /// renderer asks for once a frame.
  void begin(const ImageTarget& picture);

  /// Mixes the average into the picture's scene, which is bound again.
  DrawCounts finish(const ImageTarget& picture) const;

 private:
  void make_storage(const ImageTarget& picture);

  const gl::Program& average_;
  const gl::Program& average_of_samples_;
  gl::VertexArray no_vertices_ = gl::create_vertex_array();
  glm::ivec2 size_{0};
  gl::Texture sums_;    // RGBA16F: colours and alphas, added up
  gl::Texture behind_;  // R16F: share of the picture that stays, multiplied
  gl::Framebuffer target_;
};

}  // namespace throng::render
