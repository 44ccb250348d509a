#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "throng/render/camera.h"
#include "throng/render/renderer.h"

#include "engine/crowd/palette_slots.h"
#include "tests/gl/doll.h"
#include "tests/gl/skinning_read_back.h"

namespace throng::render::test {

/// A small crowd of dolls and the renderer that draws it. Its data is public, so that tests can put faults into it
/// before it goes to the device.
class DollCrowd {
 public:
  static constexpr int width = 320;
  static constexpr int height = 180;
  static constexpr std::uint32_t now = 5'000'000;  ///< microseconds

  explicit DollCrowd(gl::Context& context, int samples = 0, int longest_tile = 4096);

  /// Puts `count` dolls in rows before the camera, each between two poses. No two have the same pose, heading and
  /// colours.
  void stand(std::size_t count);

  /// Gives every agent its slots and fills them.
  void write_palettes();

  CrowdFrame frame();
  Image picture();

  /// Gives the surface of `agent` as the vertex shader computes it.
  std::vector<ReadBackVertex> read_back(const CrowdFrame& drawn, std::uint32_t agent) const {
    return read_back_->read(drawn, {agent, 0});
  }

  Renderer& renderer() { return *renderer_; }
  const Doll& doll() const { return doll_; }

  std::vector<InstanceRecord> instances;
  std::vector<AgentLook> looks;   ///< one an agent
  std::vector<DollPalette> from;  ///< one an agent
  std::vector<DollPalette> to;    ///< one an agent
  Camera camera;

 private:
  std::uint32_t write(const DollPalette& palette);

  Doll doll_;
  std::unique_ptr<Renderer> renderer_;
  std::unique_ptr<PaletteSlots> slots_;
  std::unique_ptr<SkinningReadBack> read_back_;
  std::vector<CrowdBatch> batches_;
};

}  // namespace throng::render::test
