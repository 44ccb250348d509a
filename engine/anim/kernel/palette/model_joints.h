#pragma once

#include "engine/anim/base/pose.h"
#include "engine/anim/kernel/palette/joint_program.h"

namespace throng::anim {

/// Computes the joints of a list that bones of one packet carry, of `width` characters of one skeleton. Packets are
/// done in order; packets that the program does not need may be left out. Joints have the bits of the palette.
struct ModelJointsJob {
  const JointProgram* program = nullptr;
  int packet = 0;                  ///< of the skeleton
  int width = widest_strip;        ///< 1, 2, 4, 8 or 16
  const float* local = nullptr;    ///< [width][components][16]
  QuadMask displaced = all_quads;  ///< on rigid skeletons: positions of others are 0, and are not read
  float* carry = nullptr;          ///< in and out, [branch_slot_floats][width]
  float* branch_slots = nullptr;   ///< in and out, [slot_count][branch_slot_floats][width]
  float* const* to = nullptr;  ///< [width] JointProgram::bytes each, 16-byte aligned, written in no special order and
                               ///< not read; lanes that are not wanted may share a place
};
bool is_valid(const ModelJointsJob& job);

}  // namespace throng::anim
