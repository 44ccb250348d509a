#include <algorithm>
#include <limits>

#include "engine/anim/api/c/parts.h"

namespace throng::c {

static_assert(THRONG_PALETTES_PACKED == static_cast<int>(PaletteFormat::packed));
static_assert(THRONG_JOINTS_AS_MATRICES_4X4 == static_cast<int>(JointFormat::matrices_4x4));

template <>
throng_crowd_options default_of() {
  const CrowdOptions own;
  throng_crowd_options options{};
  options.pus = static_cast<uint32_t>(own.pus);
  options.palettes = static_cast<uint32_t>(own.palettes);
  options.hash = own.hash ? 1 : 0;
  options.trace = own.trace ? 1 : 0;
  options.local_store_bytes = own.local_store_bytes;
  return options;
}

template <>
throng_joint_output default_of() {
  throng_joint_output output{};
  output.format = static_cast<uint32_t>(JointOutput{}.format);
  output.skin = THRONG_NONE;
  return output;
}

namespace {

/// The jobs of a host in C.
class HostExecutor final : public Executor {
 public:
  HostExecutor(throng_executor run, void* user) : run_(run), user_(user) {}
  void run(int count, Job job) override { run_(count, job.run, job.context, user_); }

 private:
  throng_executor run_;
  void* user_;
};

/// Options with the executor that they name.
struct ReadOptions {
  std::unique_ptr<Executor> executor;
  CrowdOptions own;
};

std::optional<ReadOptions> read_options(const Call& call, const throng_crowd_options* given) {
  const auto read = call.read("throng_crowd_options", given);
  if (!read || !call.is_constant("throng_crowd_options::palettes", read->palettes, PaletteFormat::packed)) return {};
  constexpr std::uint32_t too_many = 1'000'000;  // more would not fit the option
  ReadOptions options;
  if (read->executor != nullptr) {
    options.executor = std::make_unique<HostExecutor>(read->executor, read->executor_user);
  }
  options.own.pus = static_cast<int>(std::min(read->pus, too_many));
  options.own.local_store_bytes = static_cast<std::size_t>(
      std::min<std::uint64_t>(read->local_store_bytes, std::numeric_limits<std::size_t>::max()));
  options.own.palettes = static_cast<PaletteFormat>(read->palettes);
  options.own.executor = options.executor.get();
  options.own.hash = read->hash != 0;
  options.own.trace = read->trace != 0;
  return options;
}

}  // namespace
}  // namespace throng::c

using namespace throng::c;  // NOLINT: functions of C have no namespace

int throng_crowd_options_fill(throng_crowd_options* into, size_t size) {
  return fill("throng_crowd_options_fill", into, size);
}

int throng_joint_output_fill(throng_joint_output* into, size_t size) {
  return fill("throng_joint_output_fill", into, size);
}

throng_crowd* throng_crowd_create(const throng_character* character, const throng_crowd_options* options) {
  const Call call("throng_crowd_create");
  if (call.is_missing(character)) return nullptr;
  std::optional<ReadOptions> read = read_options(call, options);
  if (!read) return nullptr;
  Result<Crowd> made = Crowd::create(character->own, read->own);
  if (made) return make<throng_crowd>(std::move(read->executor), std::move(*made));
  fail(made.error().message);
  return nullptr;
}

void throng_crowd_free(throng_crowd* crowd) { delete crowd; }

int throng_crowd_configure(throng_crowd* crowd, const throng_crowd_options* options) {
  const Call call("throng_crowd_configure");
  if (call.is_missing(crowd)) return failed;
  std::optional<ReadOptions> read = read_options(call, options);
  if (!read) return failed;
  const Result<Done> configured = crowd->own.configure(read->own);
  if (configured) crowd->executor = std::move(read->executor);
  return outcome(configured);
}

throng_id throng_crowd_add_character(throng_crowd* crowd, const throng_character* character) {
  if (is_missing("throng_crowd_add_character", crowd, character)) return id_of(CharacterId{});
  const Result<CharacterId> id = crowd->own.add(character->own);
  if (!id) fail(id.error().message);
  return id_of(id ? *id : CharacterId{});
}

int throng_crowd_remove_character(throng_crowd* crowd, throng_id character) {
  if (is_missing("throng_crowd_remove_character", crowd)) return failed;
  return outcome(crowd->own.remove(character_id(character)));
}

int throng_crowd_replace_character(throng_crowd* crowd, throng_id character, const throng_character* with_other_clips) {
  if (is_missing("throng_crowd_replace_character", crowd, with_other_clips)) return failed;
  return outcome(crowd->own.replace(character_id(character), with_other_clips->own));
}

throng_character* throng_crowd_character(const throng_crowd* crowd, throng_id character) {
  if (is_missing("throng_crowd_character", crowd)) return nullptr;
  const Character own = crowd->own.character(character_id(character));
  if (own) return make<throng_character>(own);
  fail("throng_crowd_character: the crowd has no character of this id");
  return nullptr;
}

uint32_t throng_crowd_palette_bytes(const throng_crowd* crowd, throng_id character) {
  if (is_missing("throng_crowd_palette_bytes", crowd)) return 0;
  return static_cast<uint32_t>(crowd->own.palette_bytes(character_id(character)));
}

int throng_crowd_write_joints(throng_crowd* crowd, throng_id character, const throng_joint_output* output) {
  const Call call("throng_crowd_write_joints");
  if (call.is_missing(crowd)) return failed;
  const auto read = call.read("throng_joint_output", output);
  if (!read || !call.is_constant("throng_joint_output::format", read->format, JointFormat::matrices_4x4)) return failed;
  if (call.lacks(read->bones, read->bone_count)) return failed;
  JointOutput own;
  own.bones = as<const int>(read->bones, read->bone_count);
  if (read->skin != THRONG_NONE) own.skin = static_cast<int>(read->skin);
  own.format = static_cast<JointFormat>(read->format);
  return outcome(crowd->own.write_joints(character_id(character), own));
}

uint32_t throng_crowd_joint_bytes(const throng_crowd* crowd, throng_id character) {
  if (is_missing("throng_crowd_joint_bytes", crowd)) return 0;
  return static_cast<uint32_t>(crowd->own.joint_bytes(character_id(character)));
}

uint32_t throng_crowd_add_mask(throng_crowd* crowd, throng_id character, const throng_bone_weight* bones,
                               uint32_t count, float elsewhere) {
  const Call call("throng_crowd_add_mask");
  if (call.is_missing(crowd) || call.lacks(bones, count)) return THRONG_NONE;
  const MaskId mask = crowd->own.add_mask(character_id(character), as<const BoneWeight>(bones, count), elsewhere);
  return call.went_well() ? mask.number : THRONG_NONE;
}

int throng_crowd_add_agents(throng_crowd* crowd, throng_id character, uint32_t count, throng_id* agents) {
  const Call call("throng_crowd_add_agents");
  if (call.is_missing(crowd) || call.lacks(agents, count)) return failed;
  const std::span<const AgentId> added = crowd->own.add_agents(count, character_id(character));
  list(added, agents, count);
  return call.outcome(added.size() == count);
}

int throng_crowd_remove_agent(throng_crowd* crowd, throng_id agent) {
  const Call call("throng_crowd_remove_agent");
  return call.is_missing(crowd) ? failed : call.outcome(crowd->own.remove_agent(agent_id(agent)));
}

uint32_t throng_crowd_agent_count(const throng_crowd* crowd) {
  return is_missing("throng_crowd_agent_count", crowd) ? 0 : static_cast<uint32_t>(crowd->own.agents().size());
}

uint32_t throng_crowd_agents(const throng_crowd* crowd, throng_id* agents, uint32_t most) {
  const Call call("throng_crowd_agents");
  if (call.is_missing(crowd) || call.lacks(agents, most)) return 0;
  return list(crowd->own.agents(), agents, most);
}

uint32_t throng_crowd_number_limit(const throng_crowd* crowd) {
  return is_missing("throng_crowd_number_limit", crowd) ? 0 : crowd->own.number_limit();
}

int throng_agent_exists(const throng_crowd* crowd, throng_id agent) {
  return !is_missing("throng_agent_exists", crowd) && agent_of(crowd, agent).exists() ? 1 : 0;
}

throng_id throng_agent_character(const throng_crowd* crowd, throng_id agent) {
  const Call call("throng_agent_character");
  if (call.is_missing(crowd)) return id_of(CharacterId{});
  const CharacterId character = agent_of(crowd, agent).character();
  return id_of(call.went_well() ? character : CharacterId{});
}
