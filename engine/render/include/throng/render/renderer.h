#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>

#include "throng/render/context.h"
#include "throng/render/crowd_draw.h"
#include "throng/render/crowd_mesh_data.h"
#include "throng/render/image.h"
#include "throng/render/label_picture.h"
#include "throng/render/lens.h"
#include "throng/render/mesh_error_value.h"
#include "throng/render/palette_page.h"
#include "throng/render/pixel_rect.h"
#include "throng/render/scenery_data.h"
#include "throng/result.h"

struct ImDrawData;

namespace throng::render {

class CrowdMesh;

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
///   ... renderer.completed_frame(newest) ...         // before animation: these frames' palettes can be written again
///   ... animation writes palettes ...
///   renderer.draw(frame);                            // scene into the renderer's own picture
///   renderer.end_frame(frame_number);
///   renderer.draw_overlay(*ImGui::GetDrawData());    // if there is one
///   renderer.present();  or  renderer.read_image();
class Renderer {
 public:
  /// `context` must outlive the renderer. Errors: the shaders are not there; the device or the machine's memory take no
  /// picture of that size, and the error names the largest that memory takes.
  static Result<std::unique_ptr<Renderer>> create(gl::Context& context, const RendererOptions& options);
  ~Renderer();

  /// Replaces the characters, 1 to most_characters; CrowdBatch::character is an index into them. For characters of a
  /// crowd throng::mesh_data gives the data. Errors: those of
  /// CrowdMesh::create, and of the shaders that morphs need, and that the device has no memory for them; then the
  /// former ones stay.
  Status load_characters(std::span<const CrowdMeshData> characters);
  /// Replaces the characters where some meshes are there already, each for one character.
  Status load_characters(std::span<const CharacterToLoad> characters);

  /// Gives the meshes of the loaded characters.
  std::span<const CrowdMesh> meshes() const;
  /// Gives the mesh LODs of a loaded character.
  MeshLodList mesh_lods(std::size_t character) const;

  /// Replaces the meshes of scenery, and removes all instances. Errors: the device has no memory for them.
  Status load_scenery(std::span<const SceneryMeshData> meshes);
  /// Replaces the instances of scenery. SceneryInstance::mesh is an index into these meshes.
  void place_scenery(std::span<const SceneryInstance> instances);
  /// Replaces the lamps that shine there at night.
  void place_lamps(std::span<const SceneryLamp> lamps);

  /// Gives PaletteSlots its pages; CrowdBatch::page is an index into them.
  PalettePageSource& palette_pages();
  /// Binds a palette page as storage block `binding`, for programs other than the renderer's own.
  void bind_palette_page(std::uint32_t page, unsigned binding) const;

  /// Takes all pages back, for a new PaletteSlots. Waits for the device.
  void reset_palette_pages();

  /// Notes that all draws of a frame, 1 or more, were called. A frame may be drawn again. A frame that is not drawn
  /// needs no call.
  void end_frame(std::uint64_t frame);
  /// Returns the newest frame up to `newest` that the device has finished reading. Frames without draws are finished.
  /// Never waits.
  std::uint64_t completed_frame(std::uint64_t newest);

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
  void draw_only(const PixelRect& part, std::uint32_t around);

  /// Prepares draw_overlay(). An ImGui context must be current and its fonts added; call it again after adding fonts.
  Status prepare_overlay();
  /// Draws the overlay, and where `keeps_around`, leaves what it drew before outside of the part of draw_only(). A
  /// picture whose scene is not stretched is drawn anew in any case.
  void draw_overlay(const ImDrawData& data, bool keeps_around = false);

  /// Shows the picture in the context's window.
  void present();

  /// Reads the picture, with the overlay if it was drawn. The image is valid until the next one is drawn.
  const Image& read_image();

  /// Waits until the device has done everything, which ends a timed frame. Errors: it failed at something since the
  /// last call, so the picture is not whole.
  Status finish();

  /// Changes the size of pictures. Where scenes are drawn in another size, they are stretched smoothly: the overlay is
  /// drawn in the full size, and only draw_overlay() stretches. A picture that is drawn in tiles has one size. Errors:
  /// those of create(); then it is as it was.
  Status set_size(glm::ivec2 size, std::optional<glm::ivec2> drawn_size = {});
  /// Draws stills from now on, as a renderer without a window would: in that size, with 0 or 4 samples, in tiles, and
  /// with exact light. set_size() ends that, and a window shows no still. Errors: those of set_size().
  Status set_still(glm::ivec2 size, int samples);
  glm::ivec2 size() const;

  /// Builds all shaders again from disk, and returns the first error. A program that fails keeps its last good build.
  Status reload_shaders();
  /// Returns whether a file of the shaders was saved since they were built last; see ShaderLibrary.
  bool shaders_are_out_of_date() const;

  gl::Context& context();

 private:
  struct Parts;
  explicit Renderer(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace throng::render
