#include "engine/anim/api/c/parts.h"

namespace throng::c {

template <>
throng_step default_of() {
  const StepKind own;
  throng_step step{};
  step.memory_bytes = static_cast<uint32_t>(own.memory_bytes);
  step.name = own.name;
  return step;
}

namespace {

void run_step(const StepJob& job) {
  const throng_step& step = static_cast<const HostStep*>(job.shared)->own;
  const throng_step_job told{
      .memory = job.memory, .user = step.user, .delta = to_seconds(job.delta), .pose = &job.pose};
  step.run(&told);
}

const StepPose& pose_of(const throng_step_job* job) { return *static_cast<const StepPose*>(job->pose); }

}  // namespace
}  // namespace throng::c

using namespace throng::c;  // NOLINT: functions of C have no namespace

int throng_step_fill(throng_step* into, size_t size) { return fill("throng_step_fill", into, size); }

uint32_t throng_crowd_add_step(throng_crowd* crowd, throng_id character, const throng_step* step) {
  const Call call("throng_crowd_add_step");
  if (call.is_missing(crowd, step)) return THRONG_NONE;
  const auto read = call.read("throng_step", step);
  if (!read) return THRONG_NONE;
  HostStep& own = crowd->steps.emplace_back(HostStep{.own = *read, .name = std::string(view_of(read->name))});
  const Result<StepId> id =
      crowd->own.add_step(character_id(character), {.name = own.name.c_str(),
                                                    .memory_bytes = read->memory_bytes,
                                                    .run = read->run == nullptr ? nullptr : run_step,
                                                    .shared = &own});
  if (!id) {
    crowd->steps.pop_back();
    fail(id.error().message);
    return THRONG_NONE;
  }
  own.id = *id;
  return static_cast<uint32_t>(crowd->steps.size() - 1);
}

uint32_t throng_agent_add_step(throng_crowd* crowd, throng_id agent, uint32_t step) {
  const Call call("throng_agent_add_step");
  if (call.is_missing(crowd)) return THRONG_NONE;
  if (step < crowd->steps.size()) return number_or_none(agent_of(crowd, agent).add(crowd->steps[step].id));
  call.refuse("the crowd has no step of this number");
  return THRONG_NONE;
}

uint32_t throng_step_bone_count(const throng_step_job* job) {
  if (is_missing("throng_step_bone_count", job)) return 0;
  return static_cast<uint32_t>(pose_of(job).bone_count());
}

void throng_step_rotation(const throng_step_job* job, uint32_t bone, float rotation[4]) {
  if (is_missing("throng_step_rotation", job, rotation)) return;
  const Quat own = pose_of(job).rotation(static_cast<int>(bone));
  std::memcpy(rotation, &own, sizeof(own));
}

void throng_step_set_rotation(const throng_step_job* job, uint32_t bone, const float rotation[4]) {
  if (is_missing("throng_step_set_rotation", job, rotation)) return;
  pose_of(job).set_rotation(static_cast<int>(bone), {rotation[0], rotation[1], rotation[2], rotation[3]});
}

void throng_step_position(const throng_step_job* job, uint32_t bone, float position[3]) {
  if (is_missing("throng_step_position", job, position)) return;
  write(pose_of(job).position(static_cast<int>(bone)), position);
}

void throng_step_set_position(const throng_step_job* job, uint32_t bone, const float position[3]) {
  if (is_missing("throng_step_set_position", job, position)) return;
  pose_of(job).set_position(static_cast<int>(bone), vector_of(position));
}
