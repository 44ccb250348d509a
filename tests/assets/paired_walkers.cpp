#include "tests/assets/paired_walkers.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "engine/anim/agent/foot_placement_process.h"
#include "engine/anim/import/import.h"

namespace throng::test {
namespace {

using anim::FootPlacementProcess;

constexpr float stands_below = 0.01F;  // metres, of a sole

struct BuiltIn {
  anim::ImportedFile file = *import::import_file(THRONG_SOURCE_DIR "/assets/mannequin.glb");
  anim::CharacterRigs rigs{file.models.front()};
  std::shared_ptr<const anim::Character> character =
      std::make_shared<const anim::Character>(anim::bake_character(file.models.front()));
};

const BuiltIn& built_in() {
  static const BuiltIn only;
  return only;
}

std::uint32_t placed(std::size_t pair) { return static_cast<std::uint32_t>(2 * pair); }
std::uint32_t as_in_clip(std::size_t pair) { return static_cast<std::uint32_t>(2 * pair + 1); }

float level_distance(const glm::vec3& a, const glm::vec3& b) {
  return glm::distance(glm::vec2(a.x, a.z), glm::vec2(b.x, b.z));
}

}  // namespace

PairedWalkers::PairedWalkers(std::size_t pairs)
    : system_(std::move(*anim::AnimationSystem::create(built_in().character, {.schedule = anim::Schedule::levels}))),
      placements_(pairs),
      pairs_(pairs) {
  const anim::RigKinds kinds = built_in().rigs.add_to(*system_);
  system_->set_agent_count(as_in_clip(pairs - 1) + 1);
  for (std::size_t pair = 0; pair < pairs; ++pair) {
    anim::Agent agent = system_->agent(placed(pair));
    if (!agent.add_post_process(std::make_unique<FootPlacementProcess>(*kinds.foot_placement))) std::abort();
    updates_.push_back({.agent = placed(pair)});
    updates_.push_back({.agent = as_in_clip(pair)});
  }
}

const anim::Character& PairedWalkers::character() { return *built_in().character; }

void PairedWalkers::ask(std::size_t pair, const std::function<void(anim::Agent)>& request) {
  request(system_->agent(placed(pair)));
  request(system_->agent(as_in_clip(pair)));
}

const std::vector<PairedWalkers::Pair>& PairedWalkers::step() {
  const Ticks before = system_->clock();
  system_->advance(ticks_per_second / 60);
  for (std::size_t pair = 0; pair < pairs_.size(); ++pair) {
    anim::Agent agent = system_->agent(placed(pair));
    anim::JointMotion& placement = placements_[pair];
    const anim::RootMotion moved = agent.motion().displacement(before, system_->clock());
    placement.position += placement.rotation * glm::vec3(moved.translation);
    placement.rotation =
        glm::normalize(placement.rotation * glm::angleAxis(static_cast<float>(moved.yaw), glm::vec3(0.0F, 1.0F, 0.0F)));
    const Status changed =
        agent.change_process<FootPlacementProcess>({0}, [&](auto& feet) { feet.set_placement(placement); });
    if (!changed) std::abort();
  }
  system_->update(updates_);
  for (std::size_t pair = 0; pair < pairs_.size(); ++pair) {
    pairs_[pair] = {body(placed(pair), placements_[pair]), body(as_in_clip(pair), placements_[pair])};
  }
  return pairs_;
}

PairedWalkers::Body PairedWalkers::body(std::uint32_t agent, const anim::JointMotion& placement) const {
  const anim::FootPlacementRig& rig = *built_in().rigs.foot_placement();
  const anim::PoseView pose{const_cast<float*>(std::as_const(*system_).agent(agent).pose().data()),
                            anim::rigid_components * anim::packet_bones, anim::rigid_components,
                            character().skeleton.bone_count()};
  Body body{};
  for (std::size_t leg = 0; leg < leg_count; ++leg) {
    const anim::PlacedLeg& about = rig.legs[leg];
    anim::ChainMotion motions;
    anim::pose_chain(about.limb.chain, pose, motions);
    const anim::JointMotion& ankle = motions[static_cast<std::size_t>(about.limb.end())];
    const auto in_world = [&](const glm::vec3& place) { return placement.position + placement.rotation * place; };
    const glm::vec3 heel = in_world(ankle.position + ankle.rotation * about.sole[0]);
    const glm::vec3 ball = in_world(ankle.position + ankle.rotation * about.sole[1]);
    body.legs[leg] = {in_world(ankle.position), ball, std::min(heel.y, ball.y)};
    body.hips = motions[static_cast<std::size_t>(rig.pelvis)].position.y;
  }
  return body;
}

void WalkFigures::add(const PairedWalkers::Pair& before, const PairedWalkers::Pair& now) {
  most_drop = std::max(most_drop, now.clip.hips - now.placed.hips);
  for (std::size_t leg = 0; leg < PairedWalkers::leg_count; ++leg) {
    const auto stepped = [&](auto body) {
      return glm::distance((now.*body).legs[leg].ankle, (before.*body).legs[leg].ankle);
    };
    const auto slides = [&](auto body) {
      const bool stands = std::max((before.*body).legs[leg].sole, (now.*body).legs[leg].sole) < stands_below;
      return stands ? level_distance((now.*body).legs[leg].ball, (before.*body).legs[leg].ball) : 0.0F;
    };
    const float extra = stepped(&PairedWalkers::Pair::placed) - stepped(&PairedWalkers::Pair::clip);
    most_extra_step = std::max(most_extra_step, extra);
    slid += static_cast<double>(slides(&PairedWalkers::Pair::placed));
    slid_in_clip += static_cast<double>(slides(&PairedWalkers::Pair::clip));
  }
}

}  // namespace throng::test
