#include "throng/crowd.h"

#include <atomic>
#include <utility>

#include "throng/debug.h"

#include "engine/anim/api/crowd_parts.h"
#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/asset/joint_list.h"
#include "engine/anim/asset/model.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/base/misuse.h"
#include "engine/anim/kernel/palette/packed_palette.h"
#include "engine/base/glm_numbers.h"

namespace throng {

namespace {

anim::SystemOptions system_options(const CrowdOptions& options) {
  return {.pus = options.pus,
          .local_store_bytes = options.local_store_bytes,
          .executor = options.executor,
          .hash = options.hash,
          .trace = options.trace ? anim::Tracing::on : anim::Tracing::off,
          .palettes = options.palettes};
}

/// Returns a number that no crowd had before.
std::uint64_t new_version() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

void keep(detail::CrowdParts& parts, CharacterId id, const Character& character) {
  if (parts.characters.size() <= id.number) parts.characters.resize(id.number + 1);
  parts.characters[id.number] = {
      .character = character, .kinds = std::make_unique<detail::OwnKinds>(*parts.system, id, character.data()->body)};
  parts.version = new_version();
}

Result<anim::JointList> joints_of(const detail::CharacterData& character, const JointOutput& output) {
  const anim::Skeleton& skeleton = character.baked->skeleton;
  if (!output.skin) return output.bones.empty() ? anim::all_joints(skeleton) : anim::joints_of(skeleton, output.bones);
  Result<anim::JointList> joints = anim::joints_of_skin(character.body->model, *output.skin);
  if (joints && *output.skin >= 0) return joints;
  return Error{skeleton.name + ": the character has no skin " + std::to_string(*output.skin) + " of the file"};
}

/// Returns the inside of a crowd without agents. It stands in for a crowd that was moved from.
detail::CrowdParts& no_crowd() {
  static const std::unique_ptr<detail::CrowdParts> parts = [] {
    anim::Model model;
    model.skeleton.bones.resize(1);
    model.skeleton.references.resize(1);
    model.skeleton.palette.resize(1);
    model.skeleton.level_bone_counts = {1};
    auto empty = std::make_unique<detail::CrowdParts>();
    const auto character = std::make_shared<const anim::Character>(anim::bake_character(model));
    empty->system = std::move(*anim::AnimationSystem::create(character, {}));
    return empty;
  }();
  return *parts;
}

/// Notes that these agents are new.
void note(detail::CrowdParts& parts, std::span<const AgentId> added, CharacterId character) {
  const std::size_t numbers = parts.system->number_limit();
  if (parts.notes.clips.size() < numbers) {
    parts.notes.clips.resize(numbers, -1);
    parts.notes.characters.resize(numbers, 0);
    parts.notes.fades_until.resize(numbers);
    parts.notes.requests.resize(numbers, 0);
  }
  for (const AgentId agent : added) {
    parts.notes.clips[agent.number] = -1;
    parts.notes.characters[agent.number] = static_cast<std::uint8_t>(character.number);
  }
}

/// Returns whether `after` descends from `before`: then no id of a clip of `before` names another clip in `after`.
bool follows(const anim::Character& after, const anim::Character& before) {
  if (after.clips.size() < before.clips.size()) return false;
  for (std::size_t place = 0; place < before.clips.size(); ++place) {
    if (after.clips[place].generation < before.clips[place].generation) return false;
  }
  return true;
}

/// Forgets notes of clips that a character has no more.
void forget_lost_clips(detail::CrowdParts& parts, CharacterId character) {
  const Character& played = parts.characters[character.number].character;
  detail::AgentNotes& notes = parts.notes;
  for (std::size_t agent = 0; agent < notes.clips.size(); ++agent) {
    const bool is_lost = !played.has({static_cast<std::uint32_t>(notes.clips[agent])});
    if (notes.characters[agent] == character.number && is_lost) notes.clips[agent] = -1;
  }
}

}  // namespace

const char* detail::CrowdParts::fault_of(AgentId agent, ClipId clip) const {
  const anim::Agent own = system->agent(agent);
  if (!own.exists() || !clip.valid()) return nullptr;
  const Character& played = characters[own.character_number()].character;
  const bool was_there = clip.generation != whichever || clip.number < played.clip_count();
  if (played.has(clip) || !was_there) return nullptr;
  return "the character has no clip of this id: it was unloaded";
}

detail::CrowdCharacter* detail::CrowdParts::character_of(AgentId agent, const char* call) {
  return has(agent, call) ? &characters[system->agent(agent).character_number()] : nullptr;
}

Crowd::Crowd(std::unique_ptr<detail::CrowdParts> parts) : parts_(std::move(parts)) {}
Crowd::~Crowd() = default;
Crowd::Crowd(Crowd&&) noexcept = default;
Crowd& Crowd::operator=(Crowd&&) noexcept = default;

detail::CrowdParts& Crowd::parts() const { return parts_ == nullptr ? no_crowd() : *parts_; }
bool Crowd::is_gone(const char* call) const {
  return parts_ == nullptr && !anim::report_misuse({call, detail::was_moved_from});
}

Result<Crowd> Crowd::create(const Character& character, const CrowdOptions& options) {
  if (!character) return anim::refuse({"Crowd::create", "the character is empty"});
  auto parts = std::make_unique<detail::CrowdParts>();
  auto system = anim::AnimationSystem::create(detail::baked_of(character), system_options(options));
  if (!system) return system.error();
  parts->system = std::move(*system);
  keep(*parts, 0, character);
  parts->number = parts->version;
  return Crowd(std::move(parts));
}

Status Crowd::configure(const CrowdOptions& options) {
  if (parts_ == nullptr) return anim::refuse({"Crowd::configure", detail::was_moved_from});
  return parts_->system->configure(system_options(options));
}

Result<CharacterId> Crowd::add(const Character& character) {
  if (parts_ == nullptr) return anim::refuse({"Crowd::add", detail::was_moved_from});
  if (!character) return anim::refuse({"Crowd::add", "the character is empty"});
  const Result<CharacterId> id = parts_->system->characters().add(detail::baked_of(character));
  if (id) keep(*parts_, *id, character);
  return id;
}

Status Crowd::remove(CharacterId character) {
  if (parts_ == nullptr) return anim::refuse({"Crowd::remove", detail::was_moved_from});
  const Status removed = parts_->system->characters().remove(character);
  if (!removed) return removed;
  parts_->characters[character.number] = {};
  parts_->version = new_version();
  return removed;
}

Status Crowd::replace(CharacterId character, const Character& with_other_clips) {
  constexpr const char* call = "Crowd::replace";
  if (parts_ == nullptr) return anim::refuse({call, detail::was_moved_from});
  if (!with_other_clips) return anim::refuse({call, "the character is empty"});
  const Character played = this->character(character);
  if (!played) return anim::refuse({call, detail::no_character});
  const anim::Character &before = *played.data()->baked, &after = *with_other_clips.data()->baked;
  if (played.data()->body != with_other_clips.data()->body || !follows(after, before)) {
    return Error{"\"" + after.skeleton.name +
                 "\" was not made of the character that it is to replace: use with_clips() and without() of "
                 "Crowd::character()"};
  }
  const Status replaced = parts_->system->characters().replace_clips(character, detail::baked_of(with_other_clips));
  if (!replaced) return replaced;
  parts_->characters[character.number].character = with_other_clips;
  parts_->version = new_version();
  forget_lost_clips(*parts_, character);
  return replaced;
}

Character Crowd::character(CharacterId character) const {
  if (is_gone("Crowd::character")) return {};
  return parts_->system->characters().has(character) ? parts_->characters[character.number].character : Character();
}

std::size_t Crowd::palette_bytes(CharacterId character) const {
  if (is_gone("Crowd::palette_bytes")) return 0;
  const anim::Characters& characters = std::as_const(*parts_->system).characters();
  if (!characters.has(character)) return 0;
  return anim::palette_stride(static_cast<std::size_t>(characters[character].skeleton.palette_count()),
                              characters.palette_format(character));
}

Status Crowd::write_joints(CharacterId character, const JointOutput& output) {
  if (parts_ == nullptr) return anim::refuse({"Crowd::write_joints", detail::was_moved_from});
  anim::Characters& characters = parts_->system->characters();
  if (!characters.has(character)) {
    return anim::refuse({"Crowd::write_joints", detail::no_character});
  }
  const Result<anim::JointList> joints = joints_of(*parts_->characters[character.number].character.data(), output);
  if (!joints) return joints.error();
  return characters.write_joints(*joints, output.format, character);
}

std::size_t Crowd::joint_bytes(CharacterId character) const {
  if (is_gone("Crowd::joint_bytes")) return 0;
  const anim::Characters& characters = std::as_const(*parts_->system).characters();
  return characters.has(character) ? characters.joint_bytes(character) : 0;
}

MaskId Crowd::add_mask(CharacterId character, std::span<const BoneWeight> bones, float elsewhere) {
  if (is_gone("Crowd::add_mask")) return {};
  anim::Characters& characters = parts_->system->characters();
  if (!characters.has(character)) {
    anim::report_misuse({"Crowd::add_mask", detail::no_character});
    return {};
  }
  const anim::Skeleton& skeleton = std::as_const(characters)[character].skeleton;
  const auto is_weight = [](float weight) { return weight >= 0.0F && weight <= 1.0F; };
  std::vector<anim::SubtreeWeight> subtrees;
  bool are_valid = is_weight(elsewhere);
  for (const BoneWeight& one : bones) {
    are_valid = are_valid && one.bone >= 0 && one.bone < skeleton.bone_count() && is_weight(one.weight);
    subtrees.push_back({.bone = one.bone, .weight = one.weight});
  }
  if (!are_valid) {
    anim::report_misuse({"Crowd::add_mask", "a mask has bones of the character, and weights from 0 to 1"});
    return {};
  }
  const int mask = characters.add_mask(anim::BoneMask("mask", skeleton, subtrees, elsewhere), character);
  return {static_cast<std::uint32_t>(mask)};
}

Result<StepId> Crowd::add_step(CharacterId character, const StepKind& kind) {
  if (parts_ == nullptr) return anim::refuse({"Crowd::add_step", detail::was_moved_from});
  if (!parts_->system->characters().has(character)) {
    return anim::refuse({"Crowd::add_step", detail::no_character});
  }
  const Result<std::uint32_t> number = parts_->characters[character.number].kinds->add_step(kind);
  if (!number) return number.error();
  return StepId{.character = character, .number = *number};
}

AgentId Crowd::add_agent(CharacterId character) {
  const std::span<const AgentId> added = add_agents(1, character);
  return added.empty() ? AgentId{} : added.front();
}

std::span<const AgentId> Crowd::add_agents(std::uint32_t count, CharacterId character) {
  if (is_gone("Crowd::add_agents")) return {};
  const std::span<const AgentId> added = parts_->system->add_agents(count, character);
  note(*parts_, added, character);
  return added;
}

bool Crowd::remove_agent(AgentId agent) {
  if (is_gone("Crowd::remove_agent")) return false;
  return parts_->system->remove_agent(agent);
}

Agent Crowd::agent(AgentId agent) {
  is_gone("Crowd::agent");
  return {parts(), agent};
}

ManyAgents Crowd::many() {
  is_gone("Crowd::many");
  return ManyAgents(parts());
}

std::span<const AgentId> Crowd::agents() const {
  if (is_gone("Crowd::agents")) return {};
  return parts_->system->agents();
}

std::uint32_t Crowd::number_limit() const {
  if (is_gone("Crowd::number_limit")) return 0;
  return parts_->system->number_limit();
}

void Crowd::advance(Ticks delta) {
  if (is_gone("Crowd::advance")) return;
  parts_->system->advance(delta);
}

Ticks Crowd::clock() const {
  if (is_gone("Crowd::clock")) return {};
  return parts_->system->clock();
}

void Crowd::update(std::span<const PoseRequest> requests) {
  if (is_gone("Crowd::update")) return;
  parts_->system->update(requests);
}

void Crowd::pose_exactly(std::span<const PoseRequest> requests) {
  if (is_gone("Crowd::pose_exactly")) return;
  std::vector<anim::ExactPose>& exact = parts_->exact;
  exact.clear();
  for (const PoseRequest& request : requests) {
    exact.push_back({.agent = request.agent, .palette = reinterpret_cast<anim::PaletteMatrix*>(request.palette)});
  }
  parts_->system->pose_exactly(exact);
}

bool Crowd::local_pose(AgentId agent, std::span<LocalTransform> into) {
  constexpr const char* call = "Crowd::local_pose";
  if (is_gone(call)) return false;
  const anim::AgentView own = std::as_const(*parts_->system).agent(agent);
  if (!own.exists()) return anim::report_misuse({call, detail::no_agent});
  const auto bones = static_cast<std::size_t>(own.character().skeleton.bone_count());
  if (into.size() < bones) return anim::report_misuse({call, "there is no room for a transform of each bone"});
  if (own.graph().empty() || !own.can_pose_exactly()) return false;
  std::vector<anim::Transform>& locals = parts_->locals;
  locals.resize(bones);
  const anim::ExactPose pose{.agent = agent, .locals = locals};
  parts_->system->pose_exactly({&pose, 1});
  for (std::size_t bone = 0; bone < bones; ++bone) {
    into[bone] = {.translation = from_glm(locals[bone].translation),
                  .rotation = from_glm(locals[bone].rotation),
                  .scale = from_glm(locals[bone].scale)};
  }
  return true;
}

Debug Crowd::debug() const {
  is_gone("Crowd::debug");
  return Debug(parts());
}

}  // namespace throng
