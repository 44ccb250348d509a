#include "engine/render/light/sky_light.h"

#include <vector>

#include "engine/render/frame/frame_data.h"
#include "engine/render/light/sky_picture.h"

namespace throng::render {
namespace {

gl::Texture create_cube() {
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_CUBE_MAP, 1, &id);
  glTextureStorage2D(id, SkyPicture::environment_levels, GL_RGBA16F, SkyPicture::environment_side,
                     SkyPicture::environment_side);
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  return gl::Texture(id);
}

}  // namespace

void SkyLight::bind(const SceneLight& light) {
  if (made_ != light) make(light);
  glBindBufferBase(GL_UNIFORM_BUFFER, light_uniforms_binding, buffer_.id());
  glBindTextureUnit(sky_unit, map_.id());
  glBindTextureUnit(environment_unit, environment_.id());
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

void SkyLight::make(const SceneLight& light) {
  const SkyPicture sky(light);
  uniforms_ = sky.uniforms();
  glNamedBufferSubData(buffer_.id(), 0, sizeof uniforms_, &uniforms_);
  if (!map_) {
    map_ = gl::create_texture(GL_RGBA16F, SkyPicture::side, SkyPicture::side);
    glTextureParameteri(map_.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(map_.id(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(map_.id(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    environment_ = create_cube();
  }
  glTextureSubImage2D(map_.id(), 0, 0, 0, SkyPicture::side, SkyPicture::side, GL_RGBA, GL_FLOAT, sky.map().data());
  for (int level = 0; level < SkyPicture::environment_levels; ++level) {
    const int pixels = SkyPicture::environment_side >> level;
    for (int face = 0; face < 6; ++face) {
      const std::vector<glm::vec4> colors = sky.environment(face, level);
      glTextureSubImage3D(environment_.id(), level, 0, 0, face, pixels, pixels, 1, GL_RGBA, GL_FLOAT, colors.data());
    }
  }
  made_ = light;
}

}  // namespace throng::render
