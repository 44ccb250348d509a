#pragma once

#include <span>

#include "engine/anim/run/program/agent_work.h"
#include "engine/anim/run/store/strip_joints.h"

namespace throng::anim {

/// The way in which palettes are written. It is the same for all strips of an update.
struct PaletteStores {
  PaletteMatrix* unseen = nullptr;  ///< the PU's own, for characters that are not drawn
  StorePolicy policy = StorePolicy::prefetched;
};

/// Makes palettes of a strip by way of model space, packet by packet in ascending order, and the joints that are listed
/// beside them. Bones that leave a level are changed first. Palettes without a destination are made for their hashes.
/// This object is small, so that it stays in L1 while kernels evict all else.
class StripPalettes {
 public:
  StripPalettes() = default;
  /// `width` is the number of lanes. Everything that is pointed to stays where it is until the strip is done.
  StripPalettes(const UpdateContext& context, const ModelScratch& scratch, std::span<const AgentWork> strip, int width,
                const PaletteStores& stores);

  /// Returns whether anything of a packet is wanted. A packet that is not wanted may be left out.
  bool needs(int packet) const { return makes_palettes_ || joints_.needs(packet); }
  void write(const StripPacket& about);
  /// Hands the hashes of the whole strip to its agents, if they are wanted.
  void store_hashes() const;

 private:
  void fade(const StripPacket& about) const;
  void write_local_transforms(const StripPacket& about) const;

  ModelPaletteJob job_;
  void (*model_palette_)(const ModelPaletteJob& job) = nullptr;
  StripJoints joints_;
  bool makes_palettes_ = false;
  bool joints_with_palettes_ = false;  // one kernel writes both
  bool fades_ = false;                 // bones of some character are on their way to where they stand still
  const UpdateContext* context_ = nullptr;
  std::span<const AgentWork> strip_{};
};

}  // namespace throng::anim
