#include "engine/anim/api/step_process.h"

#include <glm/gtc/quaternion.hpp>

#include "engine/anim/base/misuse.h"
#include "engine/anim/entity/entity_run.h"
#include "engine/anim/kernel/lanes/rotations.h"
#include "engine/base/glm_numbers.h"

namespace throng {
namespace {

constexpr std::size_t most_step_bytes = 4096;

const anim::PoseView& view_of(const void* view) { return *static_cast<const anim::PoseView*>(view); }

void advance_step(const anim::EntityInStore& entity, const anim::SourcesInStore& sources) {
  auto& step = entity.as<detail::StepEntity>();
  step.elapsed = step.state.delta_time;
  step.state.delta_time = Ticks{};
  anim::take_velocity(step.state, sources[0]);
}

void run_step(const anim::EntityInStore& entity, const anim::PoseView& pose) {
  const auto& kind = entity.resource_as<StepKind>();
  kind.run({.memory = entity.private_part().data(),
            .shared = kind.shared,
            .delta = entity.as<detail::StepEntity>().elapsed,
            .pose = StepPose(&pose, pose.bone_count)});
}

}  // namespace

const char* detail::fault_of(const StepKind& step) {
  if (step.run == nullptr) return "StepKind::run is null: a step needs a function";
  if (step.memory_bytes > most_step_bytes) return "StepKind::memory_bytes is more than 4,096";
  return nullptr;
}

anim::EntityKind detail::step_entity_kind(const StepKind& step) {
  return {.name = step.name,
          .sources = anim::only_source<StepEntity>,
          .private_bytes = step.memory_bytes,
          .reads_identity = false,
          .advance = anim::advance_each<advance_step>,
          .pose_whole = run_step,
          .resource = &step};
}

// A pose has no such bones in a coarser level of detail, so they are neither read nor written.
Quat StepPose::rotation(int bone) const {
  return bone >= 0 && bone < bones_ ? from_glm(view_of(view_).rotation(bone)) : Quat{};
}

void StepPose::set_rotation(int bone, const Quat& rotation) const {
  if (bone < 0 || bone >= bones_) return;
  const float square = glm::dot(to_glm(rotation), to_glm(rotation));
  if (square > 0.25F && square < 4.0F) {
    view_of(view_).set_rotation(bone, to_glm(rotation));
  } else {
    anim::report_misuse({"StepPose::set_rotation", "a rotation is a unit quaternion"});
  }
}

Vec3 StepPose::position(int bone) const {
  return bone >= 0 && bone < bones_ ? from_glm(view_of(view_).position(bone)) : Vec3{};
}

void StepPose::set_position(int bone, const Vec3& position) const {
  if (bone < 0 || bone >= bones_) return;
  if (anim::is_place(to_glm(position))) {
    view_of(view_).set_position(bone, to_glm(position));
  } else {
    anim::report_misuse({"StepPose::set_position", "a position is of finite metres"});
  }
}

}  // namespace throng
