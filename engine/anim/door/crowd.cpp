#include "throng/crowd.h"

#include <atomic>
#include <utility>

#include "throng/debug.h"

#include "engine/anim/agent/system_snapshot.h"
#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/base/misuse.h"
#include "engine/anim/door/crowd_parts.h"
#include "engine/anim/kernel/palette/packed_palette.h"

namespace throng {

struct Snapshot::State {
  anim::SystemSnapshot system;
  detail::AgentNotes notes;
};

namespace {

anim::SystemOptions system_options(const CrowdOptions& options) {
  return {.pus = options.pus,
          .local_store_bytes = options.local_store_bytes,
          .executor = options.executor,
          .hash = options.hash,
          .trace = options.trace ? anim::Tracing::on : anim::Tracing::off,
          .palettes =
              options.palettes == PaletteFormat::packed ? anim::PaletteFormat::packed : anim::PaletteFormat::matrices};
}

anim::AgentUpdate update_of(const PoseRequest& request) {
  return {.agent = request.agent,
          .level = request.level,
          .look_ahead = request.look_ahead,
          .palette = anim::PaletteDestination(request.palette),
          .fade_level = request.fade_level,
          .fade_halves = request.fade_halves};
}

/// Returns a number that no crowd had before.
std::uint64_t new_version() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

void keep(detail::CrowdParts& parts, CharacterId id, const Character& character) {
  if (parts.characters.size() <= id.number) parts.characters.resize(id.number + 1);
  parts.characters[id.number] = {.character = character,
                                 .kinds = std::make_unique<detail::OwnKinds>(*parts.system, id, *character.data())};
  parts.version = new_version();
}

/// Notes that these agents are new.
void note(detail::CrowdParts& parts, std::span<const AgentId> added, CharacterId character) {
  const std::size_t numbers = parts.system->number_limit();
  if (parts.notes.clips.size() < numbers) {
    parts.notes.clips.resize(numbers, -1);
    parts.notes.characters.resize(numbers, 0);
  }
  for (const AgentId agent : added) {
    parts.notes.clips[agent.number] = -1;
    parts.notes.characters[agent.number] = static_cast<std::uint8_t>(character.number);
  }
}

}  // namespace

detail::CrowdCharacter* detail::CrowdParts::character_of(AgentId agent, const char* call) {
  const anim::Agent own = system->agent(agent);
  if (own.exists()) return &characters[own.character_number()];
  anim::report_misuse({call, "an agent of this id is not in the crowd"});
  return nullptr;
}

Snapshot::Snapshot() : state_(std::make_unique<State>()) {}
Snapshot::~Snapshot() = default;
Snapshot::Snapshot(Snapshot&&) noexcept = default;
Snapshot& Snapshot::operator=(Snapshot&&) noexcept = default;
std::size_t Snapshot::bytes() const { return state_ == nullptr ? 0 : state_->system.bytes(); }

Crowd::Crowd(std::unique_ptr<detail::CrowdParts> parts) : parts_(std::move(parts)) {}
Crowd::~Crowd() = default;
Crowd::Crowd(Crowd&&) noexcept = default;
Crowd& Crowd::operator=(Crowd&&) noexcept = default;

Result<Crowd> Crowd::create(const Character& character, const CrowdOptions& options) {
  if (!character) return anim::refuse({"Crowd::create", "the character is empty"});
  auto parts = std::make_unique<detail::CrowdParts>();
  auto system = anim::AnimationSystem::create(detail::baked_of(character), system_options(options));
  if (!system) return system.error();
  parts->system = std::move(*system);
  keep(*parts, 0, character);
  return Crowd(std::move(parts));
}

Status Crowd::configure(const CrowdOptions& options) { return parts_->system->configure(system_options(options)); }

Result<CharacterId> Crowd::add(const Character& character) {
  if (!character) return anim::refuse({"Crowd::add", "the character is empty"});
  const Result<CharacterId> id = parts_->system->characters().add(detail::baked_of(character));
  if (id) keep(*parts_, *id, character);
  return id;
}

Status Crowd::remove(CharacterId character) {
  const Status removed = parts_->system->characters().remove(character);
  if (!removed) return removed;
  parts_->characters[character.number] = {};
  parts_->version = new_version();
  return removed;
}

Character Crowd::character(CharacterId character) const {
  return parts_->system->characters().has(character) ? parts_->characters[character.number].character : Character();
}

std::size_t Crowd::palette_bytes(CharacterId character) const {
  const anim::Characters& characters = std::as_const(*parts_->system).characters();
  if (!characters.has(character)) return 0;
  return anim::palette_stride(static_cast<std::size_t>(characters[character].skeleton.palette_count()),
                              characters.palette_format(character));
}

MaskId Crowd::add_mask(CharacterId character, std::span<const BoneWeight> bones, float elsewhere) {
  anim::Characters& characters = parts_->system->characters();
  if (!characters.has(character)) {
    anim::report_misuse({"Crowd::add_mask", "a character of this id is not in the crowd"});
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
  if (!parts_->system->characters().has(character)) {
    return anim::refuse({"Crowd::add_step", "a character of this id is not in the crowd"});
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
  const std::span<const AgentId> added = parts_->system->add_agents(count, character);
  note(*parts_, added, character);
  return added;
}

bool Crowd::remove_agent(AgentId agent) { return parts_->system->remove_agent(agent); }
Agent Crowd::agent(AgentId agent) { return {*parts_, agent}; }
std::span<const AgentId> Crowd::agents() const { return parts_->system->agents(); }
std::uint32_t Crowd::number_limit() const { return parts_->system->number_limit(); }

void Crowd::advance(Ticks delta) { parts_->system->advance(delta); }
Ticks Crowd::clock() const { return parts_->system->clock(); }

void Crowd::update(std::span<const PoseRequest> requests) {
  std::vector<anim::AgentUpdate>& updates = parts_->updates;
  updates.clear();
  for (const PoseRequest& request : requests) updates.push_back(update_of(request));
  parts_->system->update(updates);
}

void Crowd::pose_exactly(std::span<const PoseRequest> requests) {
  std::vector<anim::ExactPose>& exact = parts_->exact;
  exact.clear();
  for (const PoseRequest& request : requests) {
    exact.push_back({.agent = request.agent, .palette = reinterpret_cast<anim::PaletteMatrix*>(request.palette)});
  }
  parts_->system->pose_exactly(exact);
}

void Crowd::snapshot(Snapshot& into) const {
  if (into.state_ == nullptr) into.state_ = std::make_unique<Snapshot::State>();
  parts_->system->snapshot(into.state_->system);
  into.state_->notes = parts_->notes;
}

Status Crowd::restore(const Snapshot& from) {
  if (from.state_ == nullptr) return anim::refuse({"Crowd::restore", "the snapshot was moved from"});
  const Status restored = parts_->system->restore(from.state_->system);
  if (restored) parts_->notes = from.state_->notes;
  return restored;
}

Debug Crowd::debug() const { return Debug(*parts_); }

}  // namespace throng
