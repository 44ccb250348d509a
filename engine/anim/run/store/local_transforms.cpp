#include "engine/anim/run/store/local_transforms.h"

#include <algorithm>

namespace throng::anim {

void write_locals(const Skeleton& skeleton, int packet, QuadMask displaced, const float* state, Transform* locals) {
  const int first = packet * packet_bones;
  const int count = std::min(packet_bones, skeleton.bone_count() - first);
  for (int i = 0; i < count; ++i) {
    const auto value = [&](int component) { return static_cast<double>(state[component * packet_bones + i]); };
    StateTransform relative{.rotation = glm::dquat(value(3), value(0), value(1), value(2))};
    if (!skeleton.rigid || is_in(displaced, i / quad_bones)) relative.position = {value(4), value(5), value(6)};
    if (!skeleton.rigid) relative.scale = {value(7), value(8), value(9)};
    const StateTransform local = to_local(skeleton, first + i, relative);
    locals[first + i] = {.translation = glm::vec3(local.position),
                         .rotation = glm::quat(glm::normalize(local.rotation)),
                         .scale = glm::vec3(local.scale)};
  }
}

}  // namespace throng::anim
