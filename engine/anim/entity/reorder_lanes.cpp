#include "engine/anim/entity/reorder_lanes.h"

#include <vector>

#include "engine/anim/base/pose.h"

namespace throng::anim {

void reorder_lanes(std::span<const int> places, int components, float* pose) {
  const auto lane = [&](int bone, int component) {
    const int packet = bone / packet_bones;
    const int index = (packet * components + component) * packet_bones + bone % packet_bones;
    return static_cast<std::size_t>(index);
  };
  const std::size_t floats = pose_bytes(static_cast<int>(places.size()), components) / sizeof(float);
  const std::vector<float> before(pose, pose + floats);
  for (int bone = 0; bone < static_cast<int>(places.size()); ++bone) {
    for (int component = 0; component < components; ++component) {
      pose[lane(places[static_cast<std::size_t>(bone)], component)] = before[lane(bone, component)];
    }
  }
}

}  // namespace throng::anim
