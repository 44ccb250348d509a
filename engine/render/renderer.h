#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "engine/render/contact_pass.h"
#include "engine/render/crowd_draw.h"
#include "engine/render/crowd_mesh_data.h"
#include "engine/render/crowd_pass.h"
#include "engine/render/frame_fences.h"
#include "engine/render/gl/context.h"
#include "engine/render/ground_pass.h"
#include "engine/render/image.h"
#include "engine/render/image_target.h"
#include "engine/render/instance_stream.h"
#include "engine/render/line_pass.h"
#include "engine/render/mesh.h"
#include "engine/render/overlay_renderer.h"
#include "engine/render/palette_buffer.h"
#include "engine/render/result.h"
#include "engine/render/shader_library.h"
#include "engine/render/skinning_read_back.h"
#include "engine/render/split_pass.h"

namespace throng::render {

struct RendererOptions {
  std::filesystem::path data;  ///< folder that has `shaders`
  glm::ivec2 size{1280, 720};  ///< pixels of the picture
  int samples = 0;             ///< 0 or 4
  bool shadows = true;
};

inline constexpr std::size_t most_characters = 256;  ///< that one picture shows

/// All that app/ needs for a picture. Everything happens on the thread on which `context` is current.
///
///   slots.reclaim(renderer.fences().poll());         // before animation: which slots are free again
///   ... animation writes palettes ...
///   renderer.draw(frame);                            // scene into the renderer's own picture
///   renderer.fences().insert(frame_number);
///   renderer.draw_overlay(*ImGui::GetDrawData());    // if there is one
///   renderer.present();  or  renderer.read_image();
class Renderer {
 public:
  /// `context` must outlive the renderer.
  static Result<std::unique_ptr<Renderer>> create(gl::Context& context, const RendererOptions& options);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Replaces the characters that are drawn, at least one and at most most_characters; CrowdBatch::character counts
  /// them. On failure the former ones stay.
  Status load_characters(std::span<const CrowdMeshData> characters);

  /// Of the characters loaded.
  std::span<const CrowdMesh> meshes() const { return meshes_; }

  /// Where PaletteSlots takes its pages from; CrowdBatch::page counts them.
  PalettePageSource& palette_pages() { return palettes_; }

  /// Forgets all pages, for a new PaletteSlots; waits for the device.
  void reset_palette_pages();

  FrameFences& fences() { return fences_; }

  /// Draws ground, shadows, crowd and lines. Nothing is kept of `frame`.
  DrawCounts draw(const CrowdFrame& frame);

  /// The two parts of draw(), to be timed apart. What was uploaded last can be drawn again.
  void upload(const CrowdFrame& frame);
  DrawCounts draw_uploaded(const CrowdFrame& frame);

  /// Draws two frames into one picture. `left` is uploaded last.
  DrawCounts draw_split(const CrowdFrame& left, const CrowdFrame& right, const SplitView& split);

  /// Where the vertex shader puts each vertex of one agent of `frame`, for tests; draws nothing and waits.
  std::vector<ReadBackVertex> read_back(const CrowdFrame& frame, const ReadBackAgent& agent);

  /// Makes draw_overlay possible; an ImGui context must be current, its fonts added. Again after fonts were added.
  Status prepare_overlay();
  void draw_overlay(const ImDrawData& data);

  /// Shows the picture in the context's window.
  void present();

  /// The picture as it stands, overlay included if it was drawn.
  Image read_image() const { return target_.read(); }

  /// Waits until the device has drawn everything: ends a timed frame.
  void finish();

  void set_size(glm::ivec2 size);
  void set_samples(int samples);
  void set_shadows(bool shadows) { shadows_ = shadows; }
  glm::ivec2 size() const { return target_.size(); }
  int samples() const { return target_.samples(); }
  bool shadows() const { return shadows_; }

  /// Builds all shaders again from disk; those that fail stay as they were.
  Status reload_shaders() { return shaders_->reload(); }

  gl::Context& context() { return *context_; }

 private:
  Renderer(gl::Context& context, const RendererOptions& options, std::unique_ptr<ShaderLibrary> shaders,
           GroundPass ground, ContactPass contact, CrowdPass crowd, LinePass lines, SplitPass split,
           SkinningReadBack reader);

  gl::Context* context_;
  std::unique_ptr<ShaderLibrary> shaders_;
  GroundPass ground_;
  ContactPass contact_;
  CrowdPass crowd_;
  LinePass lines_;
  SplitPass split_;
  SkinningReadBack read_back_;
  std::optional<OverlayRenderer> overlay_;
  ImageTarget target_;
  gl::Buffer frame_uniforms_;
  InstanceStream instances_;
  PaletteBuffer palettes_;
  FrameFences fences_;
  std::vector<CrowdMesh> meshes_;
  bool shadows_;
};

}  // namespace throng::render
