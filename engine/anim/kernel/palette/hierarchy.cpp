#include "engine/anim/kernel/palette/hierarchy.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "engine/anim/base/pose.h"

namespace throng::anim {
namespace {

constexpr int matrix_floats = 12;

/// For each bone, the last child that reads its slot; -1 if only the next bone is its child.
std::vector<int> last_slot_readers(const Skeleton& skeleton) {
  std::vector<int> last(skeleton.bones.size(), -1);
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    const int parent = skeleton.bones[static_cast<std::size_t>(bone)].parent;
    if (parent >= 0 && parent != bone - 1) last[static_cast<std::size_t>(parent)] = bone;
  }
  return last;
}

/// Numbers of branch slots: the lowest free one first, so that the slots in use stay few and close together.
class SlotNumbers {
 public:
  std::int16_t take() {
    const auto free = std::find(taken_.begin(), taken_.end(), false);
    const auto slot = static_cast<std::int16_t>(free - taken_.begin());
    if (free == taken_.end()) {
      taken_.push_back(true);
    } else {
      *free = true;
    }
    return slot;
  }
  void give_back(std::int16_t slot) { taken_[static_cast<std::size_t>(slot)] = false; }
  int most_taken() const { return static_cast<int>(taken_.size()); }

 private:
  std::vector<bool> taken_;
};

void plan_branch_slots(const Skeleton& skeleton, HierarchyProgram& program) {
  const std::vector<int> last_reader = last_slot_readers(skeleton);
  SlotNumbers slots;
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    HierarchyStep& step = program.steps[static_cast<std::size_t>(bone)];
    const int parent = skeleton.bones[static_cast<std::size_t>(bone)].parent;
    assert(parent < bone);
    if (parent >= 0 && parent == bone - 1) {
      step.load = HierarchyStep::from_previous;
    } else if (parent >= 0) {
      step.load = program.steps[static_cast<std::size_t>(parent)].store;
      // The kernel loads before it stores, so this bone may take over the slot that it reads last.
      if (last_reader[static_cast<std::size_t>(parent)] == bone) slots.give_back(step.load);
    }
    if (last_reader[static_cast<std::size_t>(bone)] >= 0) step.store = slots.take();
  }
  program.slot_count = slots.most_taken();
}

void assign_entries(const Skeleton& skeleton, HierarchyProgram& program) {
  for (int entry = 0; entry < skeleton.palette_count(); ++entry) {
    HierarchyStep& step =
        program.steps[static_cast<std::size_t>(skeleton.palette[static_cast<std::size_t>(entry)].bone)];
    if (step.entry_count == 0) step.first_entry = entry;
    ++step.entry_count;
  }
}

void append_rows(const glm::dmat4& matrix, std::vector<float>& rows) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) rows.push_back(static_cast<float>(matrix[column][row]));
  }
}

glm::dvec3 origin_of(const Skeleton& skeleton, int bone) {
  return bone < 0 ? glm::dvec3(0.0) : skeleton.references[static_cast<std::size_t>(bone)].origin;
}

/// The box of packed positions, over the power of two above the box of joints at rest.
constexpr int packed_box_octaves = 4;

float joint_step(const Skeleton& skeleton) {
  double extent = 0.0;
  for (const ReferenceFrame& frame : skeleton.references) {
    for (int axis = 0; axis < 3; ++axis) extent = std::max(extent, std::abs(frame.origin[axis]));
  }
  if (extent <= 0.0) return 0.0F;
  int octave = 0;
  std::frexp(extent, &octave);  // extent is below 2^octave
  return std::ldexp(1.0F, octave + packed_box_octaves - (packed_joint_bits - 1));
}

void copy_origins(const Skeleton& skeleton, HierarchyProgram& program) {
  program.to_model_origin.assign(program.steps.size() * 3, 0.0F);
  program.offsets.assign(program.steps.size() * 3, 0.0F);
  for (std::size_t bone = 0; bone < skeleton.references.size(); ++bone) {
    const glm::dvec3 origin = origin_of(skeleton, static_cast<int>(bone));
    const glm::dvec3 offset = origin - origin_of(skeleton, skeleton.bones[bone].parent);
    for (int axis = 0; axis < 3; ++axis) {
      program.to_model_origin[bone * 3 + static_cast<std::size_t>(axis)] = static_cast<float>(-origin[axis]);
      program.offsets[bone * 3 + static_cast<std::size_t>(axis)] = static_cast<float>(offset[axis]);
    }
  }
  program.joint_step = joint_step(skeleton);
}

void copy_matrices(const Skeleton& skeleton, HierarchyProgram& program) {
  for (const Bone& bone : skeleton.bones) {
    append_rows(bone.prefix, program.prefixes);
    program.has_prefix.push_back(bone.prefix == glm::dmat4(1.0) ? 0 : 1);
  }
  program.prefixes.resize(program.steps.size() * matrix_floats, 0.0F);
  program.has_prefix.resize(program.steps.size(), 0);
  for (const PaletteEntry& entry : skeleton.palette) append_rows(entry.post, program.posts);
}

/// The rank of every palette entry by the node of its bone: it does not depend on the order of bones.
std::vector<std::int16_t> ranks_by_node(const Skeleton& skeleton) {
  std::vector<std::size_t> order(skeleton.palette.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto node = [&](std::size_t entry) {
    return skeleton.bones[static_cast<std::size_t>(skeleton.palette[entry].bone)].node;
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return node(a) < node(b); });
  std::vector<std::int16_t> ranks(order.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank) ranks[order[rank]] = static_cast<std::int16_t>(rank);
  return ranks;
}

}  // namespace

std::vector<PackingFrame> packing_frames(const Skeleton& skeleton) {
  std::vector<PackingFrame> frames;
  const float step = skeleton.rigid ? joint_step(skeleton) : 0.0F;
  if (step <= 0.0F) return frames;
  for (const PaletteEntry& entry : skeleton.palette) {
    const glm::vec3 pivot(origin_of(skeleton, entry.bone));
    frames.push_back({{pivot.x, pivot.y, pivot.z}, step});
  }
  return frames;
}

HierarchyProgram compile_hierarchy(const Skeleton& skeleton) {
  HierarchyProgram program;
  program.rigid = skeleton.rigid;
  program.bone_count = skeleton.bone_count();
  program.steps.resize(static_cast<std::size_t>(packets_for(skeleton.bone_count())) * packet_bones);
  plan_branch_slots(skeleton, program);
  assign_entries(skeleton, program);
  if (skeleton.rigid) {
    copy_origins(skeleton, program);
  } else {
    copy_matrices(skeleton, program);
  }
  program.skin_joint = ranks_by_node(skeleton);
  return program;
}

}  // namespace throng::anim
