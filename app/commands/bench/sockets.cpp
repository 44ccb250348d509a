#include "app/commands/bench/sockets.h"

#include <array>
#include <cmath>
#include <utility>

#include "engine/anim/asset/joint_list.h"
#include "engine/anim/rig/rig_map.h"

namespace throng::app {

int carrying_joint(const anim::Skeleton& skeleton) {
  const int hand = anim::find_rig(skeleton).at(anim::BodyRole::right_hand);
  return hand >= 0 ? hand : skeleton.bone_count() - 1;
}

std::unique_ptr<SocketSubject> SocketSubject::create(std::shared_ptr<const anim::Character> character,
                                                     const anim::SystemOptions& options,
                                                     std::span<const BenchAgent> agents, const BenchPalettes& palettes,
                                                     std::size_t things) {
  const std::array<int, 1> hand{carrying_joint(character->skeleton)};
  const auto list = anim::joints_of(character->skeleton, hand);
  auto subject = SystemSubject::create(std::move(character), options, agents, palettes);
  if (!list || !subject) return nullptr;
  if (!subject->system().characters().write_joints(*list, anim::JointFormat::matrices)) return nullptr;
  auto made = std::make_unique<SocketSubject>();
  made->hands_.resize(things);
  made->instances_.resize(things);
  for (std::size_t thing = 0; thing < things; ++thing) {
    const auto turn = static_cast<float>(thing);
    made->places_.push_back({0.7F * turn, 0.3F * turn, std::cos(turn), std::sin(turn)});
    subject->write_joints_beside(thing * agents.size() / things,
                                 reinterpret_cast<std::byte*>(made->hands_[thing].rows));
  }
  made->subject_ = std::make_unique<SystemSubject>(std::move(*subject));
  return made;
}

// A turn about +Y and a step along the ground.
void SocketSubject::run() {
  subject_->run();
  for (std::size_t thing = 0; thing < places_.size(); ++thing) {
    const Place& place = places_[thing];
    const float* const hand = hands_[thing].rows;
    float* const out = instances_[thing].rows;
    for (int column = 0; column < 4; ++column) {
      out[column] = place.cosine * hand[column] + place.sine * hand[8 + column];
      out[4 + column] = hand[4 + column];
      out[8 + column] = place.cosine * hand[8 + column] - place.sine * hand[column];
    }
    out[3] += place.x;
    out[11] += place.z;
  }
}

}  // namespace throng::app
