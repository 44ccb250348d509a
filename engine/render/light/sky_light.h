#pragma once

#include <optional>

#include "throng/render/scene_light.h"

#include "engine/render/gl/handles.h"
#include "engine/render/light/light_uniforms.h"

namespace throng::render {

/// Holds the light of sun and sky on the device, for every program that includes shaders/lighting.glsl.
class SkyLight {
 public:
  /// Binds the light; makes it anew if it changed since the last call, which takes some milliseconds.
  void bind(const SceneLight& light);

  /// Returns the light that was bound last.
  const LightUniforms& uniforms() const { return uniforms_; }

 private:
  void make(const SceneLight& light);

  std::optional<SceneLight> made_;
  LightUniforms uniforms_{};
  gl::Buffer buffer_ = gl::create_buffer(nullptr, sizeof(LightUniforms), GL_DYNAMIC_STORAGE_BIT);
  gl::Texture map_;
  gl::Texture environment_;
};

}  // namespace throng::render
