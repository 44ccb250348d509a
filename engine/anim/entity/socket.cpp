#include "engine/anim/entity/socket.h"

#include <algorithm>
#include <cmath>

#include "engine/anim/entity/entity_run.h"

namespace throng::anim {
namespace {

void advance_socket(const EntityInStore& entity, const SourcesInStore& sources) {
  auto& socket = entity.as<Socket>();
  socket.state.delta_time = Ticks{};
  take_velocity(socket.state, sources[0]);
}

void note_place(const EntityInStore& entity, const PoseView& pose) {
  auto& socket = entity.as<Socket>();
  const SocketPlace& place = (*static_cast<const SocketPlaces*>(entity.layout->kind->resource))[socket.place];
  if (!is_within(place.chain, pose)) return;
  ChainMotion motions;
  pose_chain(place.chain, pose, motions);
  const JointMotion& joint = motions[static_cast<std::size_t>(place.chain.tip())];
  const glm::quat frame = joint.rotation * place.bind;
  const glm::vec3 position = joint.position + frame * place.offset.position;
  const glm::quat turned = glm::normalize(frame * place.offset.rotation);
  const float sign = turned.w < 0.0F ? -1.0F : 1.0F;
  for (int axis = 0; axis < 3; ++axis) {
    socket.position[axis] = position[axis];
    socket.rotation[axis] = sign * turned[axis];
  }
}

}  // namespace

Result<SocketPlace> make_socket_place(const Skeleton& skeleton, int bone, const JointMotion& offset) {
  if (!is_valid(offset)) return Error{"a socket's offset is of finite metres and a unit quaternion"};
  Result<JointChain> chain = make_joint_chain(skeleton, bone);
  if (!chain) return chain.error();
  const glm::quat bind(skeleton.references[static_cast<std::size_t>(bone)].rotation);
  return SocketPlace{.chain = *chain, .bind = bind, .offset = offset};
}

JointMotion socket_motion(const Socket& socket) {
  const glm::vec3 xyz(socket.rotation[0], socket.rotation[1], socket.rotation[2]);
  const float w = std::sqrt(std::max(0.0F, 1.0F - glm::dot(xyz, xyz)));
  return {.rotation = {w, xyz.x, xyz.y, xyz.z},
          .position = {socket.position[0], socket.position[1], socket.position[2]}};
}

EntityKind socket_kind(const SocketPlaces& places) {
  return {.name = "socket",
          .type = EntityType::socket,
          .sources = only_source<Socket>,
          .reads_identity = false,
          .advance = advance_each<advance_socket>,
          .pose_whole = note_place,
          .resource = &places};
}

}  // namespace throng::anim
