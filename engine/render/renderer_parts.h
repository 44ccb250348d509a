#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "throng/render/renderer.h"

#include "engine/render/frame/frame_data.h"
#include "engine/render/frame/tiled_target.h"
#include "engine/render/light/lamp_map.h"
#include "engine/render/light/sky_light.h"
#include "engine/render/mesh/mesh.h"
#include "engine/render/palette/frame_fences.h"
#include "engine/render/palette/palette_buffer.h"
#include "engine/render/passes/blend_pass.h"
#include "engine/render/passes/bone_pass.h"
#include "engine/render/passes/crowd_pass.h"
#include "engine/render/passes/crowd_shade_pass.h"
#include "engine/render/passes/ground_pass.h"
#include "engine/render/passes/label_pass.h"
#include "engine/render/passes/line_pass.h"
#include "engine/render/passes/overlay_renderer.h"
#include "engine/render/passes/shadow_pass.h"
#include "engine/render/passes/split_pass.h"
#include "engine/render/scenery/scenery_pass.h"
#include "engine/render/shader/shader_library.h"

namespace throng::render {

/// The inside of a renderer: the passes of a picture, and what they keep on the device.
struct Renderer::Parts {
  /// The part of the picture, in its full size, that scenes are drawn into alone.
  struct DrawnPart {
    PixelRect place;
    std::uint32_t around;
  };

  Parts(gl::Context& its_context, const RendererOptions& its_options, TiledTarget its_target)
      : context(&its_context),
        shaders(its_options.data / "shaders"),
        target(std::move(its_target)),
        options(its_options) {}

  void upload(const CrowdFrame& frame);
  DrawCounts draw_light(const CrowdFrame& frame);
  DrawCounts draw_tiles(const CrowdFrame& frame);
  DrawCounts draw_through_lens(const CrowdFrame& frame, const Lens& lens);
  DrawCounts draw_scene(const CrowdFrame& frame);
  DrawCounts draw_split(const CrowdFrame& left, const CrowdFrame& right, const SplitView& view);
  Status draw_labels(const CrowdFrame& frame, LabelPicture& picture);
  Status measure_bodies(const CrowdFrame& frame, std::span<const PixelBox> boxes, std::span<BodyAlone> bodies);
  Status load_characters(std::span<const CharacterToLoad> characters);
  Status finish();
  void keep_to_part(glm::ivec2 size_of_target) const;
  glm::ivec2 size() const { return stretched ? stretched->size() : target.size(); }
  const ImageTarget& finished() const { return stretched ? *stretched : target.tile(); }
  /// Leaves the pixels around `part` as they are where `keeps_around`.
  void stretch(bool keeps_around) const;
  PixelRect seen_part(glm::ivec2 size_of_target) const;
  DrawCounts draw_scenery(const CrowdFrame& frame, glm::ivec2 pixels);
  Status prepare_labels();

  gl::Context* context;
  ShaderLibrary shaders;
  GroundPass ground{shaders};
  CrowdPass crowd{shaders, context->is_software() ? Calls::some : Calls::one};
  ShadowPass shadows{shaders};
  CrowdShadePass crowd_shade{shaders};
  SceneryPass scenery{shaders};
  BlendPass blend{shaders};
  BonePass bones{shaders};
  LinePass lines{shaders};
  SplitPass split{shaders};
  std::optional<LabelPass> labels;  // none: no caller has asked for labels
  std::optional<OverlayRenderer> overlay;
  TiledTarget target;
  std::optional<ImageTarget> stretched;  // the picture in its full size; none: it is drawn in that size
  Image stretched_image;                 // what was read of it last
  RendererOptions options;
  FrameData frame_data;
  SkyLight sky;
  LampMap lamps;
  gl::Buffer shadow_uniforms = gl::create_buffer(nullptr, sizeof(ShadowUniforms), GL_DYNAMIC_STORAGE_BIT);
  PaletteBuffer palettes;
  FrameFences fences;
  std::vector<CrowdMesh> meshes;
  std::uint32_t light_parts = 0;  // of the picture that is drawn
  bool splits = false;            // two crowds are drawn into one picture
  bool draws_stills = false;      // as without a window
  std::optional<DrawnPart> part;  // none: all of the picture is drawn
  std::optional<Error> trouble;   // finish() returns it
};

}  // namespace throng::render
