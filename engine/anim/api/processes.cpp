#include <memory>

#include "throng/agent.h"
#include "throng/many.h"

#include "engine/anim/agent/foot_placement_process.h"
#include "engine/anim/agent/noise_process.h"
#include "engine/anim/agent/ragdoll_process.h"
#include "engine/anim/agent/socket_process.h"
#include "engine/anim/agent/spring_bones_process.h"
#include "engine/anim/agent/targeted_processes.h"
#include "engine/anim/api/convert.h"
#include "engine/anim/api/crowd_parts.h"
#include "engine/anim/api/step_process.h"
#include "engine/anim/kernel/limb/joint_place.h"
#include "engine/base/glm_numbers.h"

namespace throng {
namespace {

constexpr const char* adds = "Agent::add";

using detail::no_agent;

/// Adds a process of type `Process`, made of its kind and `settings`, to an agent.
template <typename Process, typename... Settings>
Result<ProcessId> add(detail::CrowdParts& crowd, AgentId agent, const Result<detail::OwnKinds::Kind>& kind,
                      const Settings&... settings) {
  if (!kind) return kind.error();
  return crowd.system->agent(agent).add_post_process(std::make_unique<Process>(*kind, settings...));
}

/// Calls change(process) if the agent has a process of this id and of one of these types.
template <typename... Processes, typename Change>
bool change(detail::CrowdParts& crowd, AgentId agent, ProcessId process, const char* call, Change&& change_it) {
  anim::Agent own = crowd.system->agent(agent);
  const anim::MisuseListener misuses;
  bool done = false;
  const auto change_one = [&]<typename Process>(std::type_identity<Process>) {
    if (std::as_const(own).template post_process<Process>(process) == nullptr) return false;
    done = own.template change_process<Process>(process, change_it, call).has_value();
    return true;
  };
  const bool is_known = (change_one(std::type_identity<Processes>()) || ...);
  if (!is_known) return anim::report_misuse({call, "the agent has no process of this id that can do so"});
  return done && misuses.reason().empty();
}

/// Returns a process to read from; null, after a report, if the agent has none of this id and type.
template <typename Process>
const Process* find(const detail::CrowdParts& crowd, AgentId agent, ProcessId process, const char* call) {
  const auto* const found = std::as_const(*crowd.system).agent(agent).template post_process<Process>(process);
  if (found == nullptr) anim::report_misuse({call, "the agent has no process of this id that can do so"});
  return found;
}

const anim::EntityPools& pools_of(const detail::CrowdParts& crowd, AgentId agent) {
  return std::as_const(*crowd.system).agent(agent).pools();
}

}  // namespace

Result<ProcessId> Agent::add(const LookAt& settings) const {
  detail::CrowdCharacter* const own = crowd_->character_of(id_, adds);
  if (own == nullptr) return Error{no_agent};
  const anim::LookAtLimits limits{.yaw = settings.yaw,
                                  .pitch_up = settings.pitch_up,
                                  .pitch_down = settings.pitch_down,
                                  .smooth_seconds = settings.smooth_seconds};
  return throng::add<anim::LookAtProcess>(*crowd_, id_, own->kinds->rig(anim::EntityType::look_at), limits);
}

Result<ProcessId> Agent::add(const Reach& settings) const {
  detail::CrowdCharacter* const own = crowd_->character_of(id_, adds);
  if (own == nullptr) return Error{no_agent};
  const Result<std::uint32_t> limb = own->kinds->limb(settings.limb);
  if (!limb) return limb.error();
  const anim::ReachProcess::Settings reach{.limb = *limb, .softness = settings.softness, .pole = to_glm(settings.pole)};
  return throng::add<anim::ReachProcess>(*crowd_, id_, own->kinds->rig(anim::EntityType::two_bone_ik), reach);
}

Result<ProcessId> Agent::add(const ChainReach& settings) const {
  detail::CrowdCharacter* const own = crowd_->character_of(id_, adds);
  if (own == nullptr) return Error{no_agent};
  const anim::ChainReachProcess::Settings reach{
      .chain = 0, .iterations = settings.iterations, .tolerance = settings.tolerance};
  return throng::add<anim::ChainReachProcess>(*crowd_, id_, own->kinds->chain(settings), reach);
}

Result<ProcessId> Agent::add(const FootPlacement& settings) const {
  detail::CrowdCharacter* const own = crowd_->character_of(id_, adds);
  if (own == nullptr) return Error{no_agent};
  anim::FootPlacementOptions options;
  options.max_drop = settings.max_drop;
  options.lock.farthest = settings.farthest_lock;
  options.lock.enabled = settings.farthest_lock > 0.0F;
  return throng::add<anim::FootPlacementProcess>(*crowd_, id_, own->kinds->rig(anim::EntityType::foot_placement),
                                                 options);
}

Result<ProcessId> Agent::add(const Noise& settings) const {
  return crowd_->system->agent(id_).add_post_process(
      std::make_unique<anim::NoiseProcess>(anim::NoiseProcess::Settings{.frequency = settings.frequency,
                                                                        .amplitude = settings.amplitude,
                                                                        .seed = settings.seed,
                                                                        .mask = detail::number_of(settings.mask)}));
}

Result<ProcessId> Agent::add(const Springs& settings) const {
  detail::CrowdCharacter* const own = crowd_->character_of(id_, adds);
  if (own == nullptr) return Error{no_agent};
  return throng::add<anim::SpringBonesProcess>(*crowd_, id_, own->kinds->springs(settings));
}

Result<ProcessId> Agent::add(const Ragdoll& settings) const {
  detail::CrowdCharacter* const own = crowd_->character_of(id_, adds);
  if (own == nullptr) return Error{no_agent};
  return throng::add<anim::RagdollProcess>(*crowd_, id_, own->kinds->rig(anim::EntityType::ragdoll), settings.fade);
}

Result<ProcessId> Agent::add(const Socket& settings) const {
  detail::CrowdCharacter* const own = crowd_->character_of(id_, adds);
  if (own == nullptr) return Error{no_agent};
  const Result<detail::OwnKinds::Place> place = own->kinds->socket(settings);
  if (!place) return place.error();
  return throng::add<anim::SocketProcess>(*crowd_, id_, place->kind, place->number);
}

Result<ProcessId> Agent::add(StepId step) const {
  detail::CrowdCharacter* const own = crowd_->character_of(id_, adds);
  if (own == nullptr) return Error{no_agent};
  const std::optional<detail::OwnKinds::Kind> kind = own->kinds->step(step.number);
  if (!kind || !(step.character == character() || step.character == CharacterId(character().number))) {
    return anim::refuse({adds, "the step is not one of the agent's character"});
  }
  return throng::add<detail::StepProcess>(*crowd_, id_, *kind);
}

bool Agent::remove(ProcessId process) const { return crowd_->system->agent(id_).remove_post_process(process); }

bool Processes::set_weight(ProcessId process, float weight, Ticks fade) const {
  const auto set = [&](auto& own) { own.set_weight(weight, fade); };
  return change<anim::LookAtProcess, anim::ReachProcess, anim::ChainReachProcess, anim::FootPlacementProcess,
                anim::SpringBonesProcess>(*crowd_, agent_, process, "Processes::set_weight", set);
}

bool Processes::look_at(ProcessId gaze, const Vec3& target, Ticks fade) const {
  const GazeRequest request{.agent = agent_, .gaze = gaze, .target = target, .fade = fade};
  return crowd_->system->many().look_at({&request, 1}, "Processes::look_at");
}

bool Processes::look_away(ProcessId gaze, Ticks fade) const {
  const auto look = [&](anim::LookAtProcess& own) { own.look_away(fade); };
  return change<anim::LookAtProcess>(*crowd_, agent_, gaze, "Processes::look_away", look);
}

bool Processes::reach(ProcessId limb, const Vec3& target) const {
  const ReachRequest request{.agent = agent_, .limb = limb, .target = target};
  return crowd_->system->many().reach({&request, 1}, "Processes::reach");
}

bool Processes::set_placement(ProcessId process, const Place& model_in_world) const {
  const PlacementRequest request{.agent = agent_, .process = process, .model_in_world = model_in_world};
  return crowd_->system->many().set_placements({&request, 1}, "Processes::set_placement");
}

bool Processes::set_ground(ProcessId feet, int leg, const Vec3& point, const Vec3& normal) const {
  const GroundRequest request{.agent = agent_, .feet = feet, .leg = leg, .point = point, .normal = normal};
  return crowd_->system->many().set_grounds({&request, 1}, "Processes::set_ground");
}

Vec3 Processes::ankle(ProcessId feet, int leg) const {
  const auto* const own = find<anim::FootPlacementProcess>(*crowd_, agent_, feet, "Processes::ankle");
  return own == nullptr ? Vec3{} : from_glm(own->ankle(pools_of(*crowd_, agent_), leg));
}

bool Processes::push(ProcessId ragdoll, const Vec3& impulse, const Vec3& place) const {
  const auto give = [&](anim::RagdollProcess& own) { own.push(to_glm(impulse), to_glm(place)); };
  return change<anim::RagdollProcess>(*crowd_, agent_, ragdoll, "Processes::push", give);
}

bool Processes::recover(ProcessId ragdoll, Ticks fade) const {
  const auto stand_up = [&](anim::RagdollProcess& own) { own.recover(fade); };
  return change<anim::RagdollProcess>(*crowd_, agent_, ragdoll, "Processes::recover", stand_up);
}

bool Processes::is_down(ProcessId ragdoll) const {
  const auto* const own = find<anim::RagdollProcess>(*crowd_, agent_, ragdoll, "Processes::is_down");
  return own != nullptr && own->phase() != anim::RagdollProcess::Phase::standing;
}

Place Processes::socket(ProcessId socket) const {
  const auto* const own = find<anim::SocketProcess>(*crowd_, agent_, socket, "Processes::socket");
  return own == nullptr ? Place{} : anim::from_joint(own->motion(pools_of(*crowd_, agent_)));
}

}  // namespace throng
