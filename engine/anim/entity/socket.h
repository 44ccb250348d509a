#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/anim/entity/entity_kind.h"
#include "engine/anim/kernel/limb/joint_chain.h"

namespace throng::anim {

/// A place on a skeleton to which something is attached: a sword in a hand, a camera on a head.
struct SocketPlace {
  JointChain chain;                        ///< its tip is the joint that carries the attachment
  glm::quat bind{1.0F, 0.0F, 0.0F, 0.0F};  ///< rotation of that joint in the bind pose, model space
  JointMotion offset{};                    ///< from the joint to the attachment, in the joint's own frame
};

/// Makes a socket at `bone`, `offset` from it in the bone's own frame. Errors as make_joint_chain.
Result<SocketPlace> make_socket_place(const Skeleton& skeleton, int bone, const JointMotion& offset = {});

/// The sockets of one skeleton; the resource of its socket kind.
using SocketPlaces = std::vector<SocketPlace>;

/// Passes its source's pose on, to the bit, and stores where a socket is in model space. A host reads that from the
/// block at the next frame boundary, so no palette is read back.
///
///     [header 96 | socket 32 | transforms if resident]
struct alignas(64) Socket {
  static constexpr EntityType entity_type = EntityType::socket;

  AnimationStateHeader state;  //   0
  float position[3];           //  96  metres, model space, after the last update
  float rotation[3];           // 108  x y z of a unit quaternion, w is not negative
  Handle source;               // 120
  std::uint32_t place;         // 124  index of SocketPlaces
};
static_assert(sizeof(Socket) == entity_header_bytes);
static_assert(offsetof(Socket, rotation) == 108 && offsetof(Socket, source) == 120);

/// Returns where the attachment was in the last update that had all bones of the chain, in model space.
JointMotion socket_motion(const Socket& socket);

/// `places` outlives the kind; more may be added between frames.
EntityKind socket_kind(const SocketPlaces& places);

}  // namespace throng::anim
