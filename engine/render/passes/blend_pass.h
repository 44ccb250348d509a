#pragma once

#include "engine/render/crowd_draw.h"
#include "engine/render/frame/blend_target.h"
#include "engine/render/frame/image_target.h"
#include "engine/render/shader/shader_library.h"

namespace throng::render {

/// Lays surfaces that are seen through over a picture, in whatever order they are drawn.
///
///   blend.begin(picture);  ... draw them with crowd_blended.frag ...  blend.finish(picture);
class BlendPass {
 public:
  explicit BlendPass(ShaderLibrary& shaders)
      : average_(shaders.load({"whole_picture.vert", "blended.frag"})),
        average_of_samples_(shaders.load({"whole_picture.vert", "blended_samples.frag"})) {}

  /// Lets later draws add to the sums. Opaque surfaces must be drawn before.
  void begin(const ImageTarget& picture);

  /// Mixes the average into the picture's scene, which is bound again.
  DrawCounts finish(const ImageTarget& picture) const;

 private:
  const gl::Program& average_;
  const gl::Program& average_of_samples_;
  gl::VertexArray no_vertices_ = gl::create_vertex_array();
  BlendTarget target_;  // without storage until the first use
};

}  // namespace throng::render
