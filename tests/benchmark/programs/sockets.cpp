#include "tests/benchmark/programs/sockets.h"

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
                                                     std::size_t things, SocketSource source) {
  const std::array<int, 1> hand{carrying_joint(character->skeleton)};
  const anim::JointPlace place = anim::joint_place(character->skeleton, hand.front());
  const auto list = anim::joints_of(character->skeleton, hand);
  auto subject = SystemSubject::create(std::move(character), options, agents, palettes);
  const bool reads_palettes = source == SocketSource::palette;
  if (!list || !subject || (reads_palettes && place.entry < 0)) return nullptr;
  if (!reads_palettes && !subject->system().characters().write_joints(*list, JointFormat::matrices)) {
    return nullptr;
  }
  auto made = std::make_unique<SocketSubject>();
  made->listed_.resize(reads_palettes ? 0 : things);
  made->instances_.resize(things);
  for (int axis = 0; axis < 3 && reads_palettes; ++axis)
    made->from_hand_[axis] = static_cast<float>(place.position[axis]);
  for (std::size_t thing = 0; thing < things; ++thing) {
    const std::size_t agent = thing * agents.size() / things;
    const float* rows = nullptr;
    if (reads_palettes) {
      rows = reinterpret_cast<const float*>(palettes.of(agent)) + std::ptrdiff_t{12} * place.entry;
    } else {
      rows = made->listed_[thing].rows;
      subject->updates()[agent].joints = reinterpret_cast<std::byte*>(made->listed_[thing].rows);
    }
    const auto turn = static_cast<float>(thing);
    made->carriers_.push_back({rows, 0.7F * turn, 0.3F * turn, std::cos(turn), std::sin(turn)});
  }
  made->subject_ = std::make_unique<SystemSubject>(std::move(*subject));
  return made;
}

// The joint, then a turn about +Y and a step along the ground.
void SocketSubject::run() {
  subject_->run();
  const auto& [px, py, pz] = from_hand_;
  for (std::size_t thing = 0; thing < carriers_.size(); ++thing) {
    const Carrier& carrier = carriers_[thing];
    float hand[12];
    for (int row = 0; row < 12; row += 4) {
      const float* const from = carrier.hand + row;
      for (int column = 0; column < 3; ++column) hand[row + column] = from[column];
      hand[row + 3] = from[0] * px + from[1] * py + from[2] * pz + from[3];
    }
    float* const out = instances_[thing].rows;
    for (int column = 0; column < 4; ++column) {
      out[column] = carrier.cosine * hand[column] + carrier.sine * hand[8 + column];
      out[4 + column] = hand[4 + column];
      out[8 + column] = carrier.cosine * hand[8 + column] - carrier.sine * hand[column];
    }
    out[3] += carrier.x;
    out[11] += carrier.z;
  }
}

}  // namespace throng::app
