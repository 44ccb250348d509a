#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>

#include "engine/base/result.h"
#include "engine/render/crowd_draw.h"
#include "engine/render/crowd_mesh_data.h"
#include "engine/render/frame/frame_data.h"
#include "engine/render/frame/tiled_target.h"
#include "engine/render/gl/context.h"
#include "engine/render/image.h"
#include "engine/render/label_picture.h"
#include "engine/render/lens.h"
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
#include "engine/render/scenery_data.h"
#include "engine/render/shader/shader_library.h"

namespace throng::render {

struct RendererOptions {
  std::filesystem::path data;  ///< folder that has `shaders`
  glm::ivec2 size{1280, 720};  ///< pixels of the picture
  int samples = 0;             ///< 0 or 4
  int longest_tile = 4096;     ///< pixels; a picture with a longer side is drawn in tiles, unless a window shows it
  bool lights_at_vertices = false;  ///< sun and sky light scenery less exactly, and sooner where a processor draws
  std::optional<Lens> lens = {};    ///< unset: all is sharp; else each picture takes Lens::points times as long
};

inline constexpr std::size_t most_characters = 256;  ///< the most in one picture
/// Holds the data to make a character's mesh of, or the index in Renderer::meshes() of a mesh to keep for it.
using CharacterToLoad = std::variant<CrowdMeshData, std::size_t>;

/// Draws pictures of a crowd: this is all that a program calls. It works on the thread on which `context` is current.
///
///   slots.reclaim(renderer.fences().poll());         // before animation: frees slots
///   ... animation writes palettes ...
///   renderer.draw(frame);                            // scene into the renderer's own picture
///   renderer.fences().insert(frame_number);
///   renderer.draw_overlay(*ImGui::GetDrawData());    // if there is one
///   renderer.present();  or  renderer.read_image();
class Renderer {
 public:
  /// `context` must outlive the renderer. Errors: the shaders are not there; the device or the machine's memory take no
  /// picture of that size, and the error names the largest that memory takes.
  static Result<std::unique_ptr<Renderer>> create(gl::Context& context, const RendererOptions& options);

  /// Replaces the characters, 1 to most_characters; CrowdBatch::character is an index into them. Errors: those of
  /// CrowdMesh::create, and of the shaders that morphs need, and that the device has no memory for them; then the
  /// former ones stay.
  Status load_characters(std::span<const CrowdMeshData> characters);
  /// Replaces the characters where some meshes are there already, each for one character.
  Status load_characters(std::span<const CharacterToLoad> characters);

  /// Gives the meshes of the loaded characters.
  std::span<const CrowdMesh> meshes() const { return meshes_; }

  /// Replaces the meshes of scenery, and removes all instances. Errors: the device has no memory for them.
  Status load_scenery(std::span<const SceneryMeshData> meshes) { return scenery_.load(meshes); }
  /// Replaces the instances of scenery. SceneryInstance::mesh is an index into these meshes.
  void place_scenery(std::span<const SceneryInstance> instances) { scenery_.place(instances); }
  /// Replaces the lamps that shine there at night.
  void place_lamps(std::span<const SceneryLamp> lamps) { lamps_.place(lamps); }

  /// Gives PaletteSlots its pages; CrowdBatch::page is an index into them.
  PalettePageSource& palette_pages() { return palettes_; }

  /// Binds pages for programs other than the renderer's own.
  const PaletteBuffer& palettes() const { return palettes_; }

  /// Drops all pages, for a new PaletteSlots. Waits for the device.
  void reset_palette_pages();

  FrameFences& fences() { return fences_; }

  /// Draws shadow maps, crowd, scenery, ground, sky, bones and lines. Keeps nothing of `frame`.
  DrawCounts draw(const CrowdFrame& frame);

  /// These two functions are the parts of draw(), so that each can be timed. The last upload can be drawn again.
  void upload(const CrowdFrame& frame);
  DrawCounts draw_uploaded(const CrowdFrame& frame);

  /// Draws two frames into one picture. Uploads `left` last.
  DrawCounts draw_split(const CrowdFrame& left, const CrowdFrame& right, const SplitView& split);

  /// Labels each pixel of a frame that was uploaded with the agent there; scenery hides agents. Errors: the device has
  /// no memory for it.
  Status draw_labels(const CrowdFrame& frame, LabelPicture& labels);
  /// Measures the pixels that each instance of an uploaded frame would cover if it were alone. boxes[instance] holds
  /// it. Errors: those of draw_labels().
  Status measure_bodies(const CrowdFrame& frame, std::span<const PixelBox> boxes, std::span<BodyAlone> bodies);

  /// Draws scenes into a part of the picture alone from now on, and gives the rest an sRGB colour, red in the lowest
  /// byte. A processor that draws has less to do then. Only a picture that is not tiled has a part.
  void draw_only(const PixelRect& part, std::uint32_t around) { part_ = {part, around}; }

  /// Prepares draw_overlay(). An ImGui context must be current and its fonts added; call it again after adding fonts.
  Status prepare_overlay();
  void draw_overlay(const ImDrawData& data);

  /// Shows the picture in the context's window.
  void present();

  /// Reads the picture, with the overlay if it was drawn. The image is valid until the next one is drawn.
  const Image& read_image() { return target_.read(); }

  /// Waits until the device has done everything, which ends a timed frame. Errors: it failed at something since the
  /// last call, so the picture is not whole.
  Status finish();

  /// Changes the size of pictures. Errors: those of create(); then it is as it was.
  Status set_size(glm::ivec2 size);
  glm::ivec2 size() const { return target_.size(); }

  /// Builds all shaders again from disk, and returns the first error. A program that fails keeps its last good build.
  Status reload_shaders() { return shaders_.reload(); }
  /// Returns whether a file of the shaders was saved since they were built last; see ShaderLibrary.
  bool shaders_are_out_of_date() const { return shaders_.is_out_of_date(); }

  gl::Context& context() { return *context_; }

 private:
  struct DrawnPart {
    PixelRect place;
    std::uint32_t around;
  };

  Renderer(gl::Context& context, const RendererOptions& options, TiledTarget target);

  DrawCounts draw_light(const CrowdFrame& frame);
  DrawCounts draw_tiles(const CrowdFrame& frame);
  DrawCounts draw_through_lens(const CrowdFrame& frame, const Lens& lens);
  void keep_to_part() const;
  DrawCounts draw_scene(const CrowdFrame& frame);
  DrawCounts draw_scenery(const CrowdFrame& frame, glm::ivec2 pixels);
  Status prepare_labels();

  gl::Context* context_;
  ShaderLibrary shaders_;
  GroundPass ground_{shaders_};
  CrowdPass crowd_{shaders_, context_->is_software() ? Calls::some : Calls::one};
  ShadowPass shadows_{shaders_};
  CrowdShadePass crowd_shade_{shaders_};
  SceneryPass scenery_{shaders_};
  BlendPass blend_{shaders_};
  BonePass bones_{shaders_};
  LinePass lines_{shaders_};
  SplitPass split_{shaders_};
  std::optional<LabelPass> labels_;  // none: no caller has asked for labels
  std::optional<OverlayRenderer> overlay_;
  TiledTarget target_;
  RendererOptions options_;
  FrameData frame_data_;
  SkyLight sky_;
  LampMap lamps_;
  gl::Buffer shadow_uniforms_ = gl::create_buffer(nullptr, sizeof(ShadowUniforms), GL_DYNAMIC_STORAGE_BIT);
  PaletteBuffer palettes_;
  FrameFences fences_;
  std::vector<CrowdMesh> meshes_;
  std::uint32_t light_parts_ = 0;  // of the picture that is drawn
  bool splits_ = false;            // two crowds are drawn into one picture
  std::optional<DrawnPart> part_;  // none: all of the picture is drawn
  std::optional<Error> trouble_;   // finish() returns it
};

}  // namespace throng::render
