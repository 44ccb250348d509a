#pragma once

#include <span>

#include "engine/anim/run/program/agent_work.h"
#include "engine/anim/run/store/tile_scratch.h"

namespace throng::anim {

/// What the strips of an update have in common about palettes.
struct PaletteStores {
  PaletteMatrix* unseen = nullptr;  ///< the PU's own, for characters that nobody draws
  StorePolicy policy = StorePolicy::prefetched;
};

/// Local poses of one packet of the characters of a strip.
struct StripPacket {
  int packet;
  float* local;                    ///< [width][components][16]
  QuadMask displaced = all_quads;  ///< see ModelPaletteJob
};

/// The last step of a strip: model space and palettes, packet by packet in ascending order. Bones that leave a level
/// are changed first. Small, so that it stays near while kernels drive all else out of the nearest cache.
class StripPalettes {
 public:
  StripPalettes() = default;
  /// Of a strip of `width` lanes. What is pointed to stays where it is until the strip is done.
  StripPalettes(const UpdateContext& context, const ModelScratch& scratch, std::span<const AgentWork> strip, int width,
                const PaletteStores& stores);

  void write(const StripPacket& about);
  /// Hands the hashes of the whole strip to its agents, where they are wanted.
  void store_hashes() const;

 private:
  void fade(const StripPacket& about) const;

  ModelPaletteJob job_;
  void (*model_palette_)(const ModelPaletteJob& job) = nullptr;
  bool fades_ = false;  // bones of some character are on their way to where they stand still
  const UpdateContext* context_ = nullptr;
  std::span<const AgentWork> strip_{};
};

}  // namespace throng::anim
