#pragma once

#include <span>

#include "engine/anim/run/store/tile_scratch.h"

namespace throng::anim {

/// One packet of the local poses of a strip.
struct StripPacket {
  int packet;
  float* local;                    ///< [width][components][16]
  QuadMask displaced = all_quads;  ///< see ModelPaletteJob
};

/// Writes the listed joints of a strip, packet by packet in ascending order, if one of its characters wants them.
class StripJoints {
 public:
  StripJoints() = default;
  /// As for StripPalettes. Joints that are not wanted are written to `unseen`, which has room for a list.
  StripJoints(const UpdateContext& context, const ModelScratch& scratch, std::span<const AgentWork> strip, int width,
              float* unseen);

  /// Returns whether a packet has bones that a listed joint needs.
  bool needs(int packet) const { return job_.program != nullptr && job_.program->needs(packet); }
  void write(const StripPacket& about);
  /// Makes the kernel that makes palettes write the joints too.
  void write_with_palettes(ModelPaletteJob& job) const {
    job.joints = job_.program;
    job.joints_to = job_.to;
  }

 private:
  ModelJointsJob job_;  // without a program: no joints are wanted
  void (*model_joints_)(const ModelJointsJob& job) = nullptr;
};

}  // namespace throng::anim
