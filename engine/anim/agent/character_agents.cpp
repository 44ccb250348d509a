#include "engine/anim/agent/character_agents.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <string_view>
#include <utility>

#include "engine/anim/asset/reference_pose.h"

namespace throng::anim {
namespace {

ClipStreams streams_of(const Character& character, int index) {
  const BakedClip& clip = character.clips[static_cast<std::size_t>(index)];
  return {.keyframe = &clip.keyframe(),
          .sampled = clip.sampled(),
          .duration = clip.duration,
          .root_motion = clip.root_motion.keys.empty() ? nullptr : &clip.root_motion,
          .data_keys = clip.data_keys,
          .curves = clip.curves.empty() ? nullptr : &clip.curves,
          .morphs = clip.morphs.empty() ? nullptr : &clip.morphs,
          .ground_speed = ground_speed(character, index)};
}

std::vector<ClipStreams> all_streams_of(const Character& character) {
  std::vector<ClipStreams> streams;
  const int count = static_cast<int>(character.clips.size());
  for (int clip = 0; clip < count; ++clip) streams.push_back(streams_of(character, clip));
  return streams;
}

void add(PoolMemory& sum, const PoolMemory& part) {
  sum.blocks_alive += part.blocks_alive;
  sum.blocks_capacity += part.blocks_capacity;
  sum.bytes_alive += part.bytes_alive;
  sum.bytes_reserved += part.bytes_reserved;
  sum.bytes_of_tables += part.bytes_of_tables;
}

}  // namespace

std::size_t CharacterAgentsSnapshot::bytes() const {
  std::size_t bytes = agents ? agents->bytes() + shared->bytes() : 0;
  for (const PoolSnapshot& pool : pools) bytes += pool.bytes();
  return bytes;
}

CharacterAgents::CharacterAgents(std::shared_ptr<const Character> played)
    : character(std::move(played)),
      still_pose(anim::still_pose(character->skeleton)),
      clips(all_streams_of(*character)),
      pools(skeleton().bone_count(), skeleton().components(), Residency::transient),
      agents(pools, programs),
      shared(pools, programs, shared_owner) {}

std::shared_ptr<const Character> CharacterAgents::replace_character(std::shared_ptr<const Character> reordered) {
  assert(reordered->skeleton.bone_count() == skeleton().bone_count() && "another character");
  assert(reordered->clips.size() == character->clips.size() && "another character");
  clips = all_streams_of(*reordered);
  still_pose = anim::still_pose(reordered->skeleton);
  agents.restart_keyframes();
  shared.restart_keyframes();
  return std::exchange(character, std::move(reordered));
}

std::string CharacterAgents::bound_to_bone_order() const {
  if (!masks.empty()) return "masks of bones";
  if (!selections.empty()) return "selections of bones";
  if (!joint_programs.empty()) return "a list of joints";
  if (pools.pool(EntityPools::inertialisers).memory().blocks_alive > 0) return "inertialisers";
  return {};
}

UpdateContext CharacterAgents::context(const Kernels& kernels) const {
  return {.hierarchy = &character->hierarchy,
          .assets = {.clips = clips,
                     .masks = mask_weights,
                     .selections = selections,
                     .kernels = &kernels,
                     .bone_count = skeleton().bone_count(),
                     .components = skeleton().components()},
          .level_bone_counts = skeleton().level_bone_counts,
          .pools = &pools,
          .still_pose = still_pose,
          .joint_programs = joint_programs};
}

int CharacterAgents::add_mask(BoneMask mask) {
  assert(mask.packets() == packets_for(skeleton().bone_count()) && "a mask of another skeleton");
  assert(masks.size() < std::numeric_limits<std::int16_t>::max());
  mask_weights.push_back(mask.packet(0));
  const std::span weights(mask.packet(0), static_cast<std::size_t>(skeleton().bone_count()));
  mask_ranges.push_back({.least = *std::ranges::min_element(weights), .most = *std::ranges::max_element(weights)});
  masks.push_back(std::move(mask));
  return static_cast<int>(masks.size()) - 1;
}

std::uint32_t CharacterAgents::add_selection(BoneSelection selection) {
  assert(selection.packets() == packets_for(skeleton().bone_count()) && "a selection of another skeleton");
  selections.push_back(std::move(selection));
  return static_cast<std::uint32_t>(selections.size());
}

void CharacterAgents::set_residency(Residency residency) {
  if (residency == pools.residency()) return;
  pools.set_residency(residency);
  agents.recompile();
}

void CharacterAgents::set_stream(StreamKind stream) {
  for (std::uint32_t agent = 0; agent < agents.count(); ++agent) {
    agents.restream(EntityBuilder(pools, clips, {.owner = agent, .stream = stream}), agent);
  }
  agents.recompile();
}

void CharacterAgents::reserve_fades(StreamKind stream, std::size_t agent_count) {
  constexpr std::size_t players_of_a_fade = 2;
  const bool sampled = stream == StreamKind::sampled;
  pools.pool(sampled ? EntityPools::sampled_players : EntityPools::keyframe_players)
      .reserve(players_of_a_fade * agent_count);
  pools.pool(EntityPools::ease_blenders).reserve(agent_count);
}

void CharacterAgents::snapshot(CharacterAgentsSnapshot& into) const {
  into.character = character;
  into.pools.resize(std::size_t{2} * pools.kind_count());
  for (EntityPools::Kind kind = 0; kind < pools.kind_count(); ++kind) {
    pools.pool(kind).snapshot(into.pools[2 * kind]);
    pools.shared_pool(kind).snapshot(into.pools[2 * kind + 1]);
  }
  into.agents.emplace(agents.clone());
  into.shared.emplace(shared.clone());
}

Status CharacterAgents::restore(const CharacterAgentsSnapshot& from) {
  for (EntityPools::Kind kind = 0; kind < pools.kind_count(); ++kind) {
    // The first is refused if any is: all are of one residency.
    if (Status restored = pools.pool(kind).restore(from.pools[2 * kind]); !restored) return restored;
    if (Status restored = pools.shared_pool(kind).restore(from.pools[2 * kind + 1]); !restored) return restored;
  }
  agents = from.agents->clone();
  shared = from.shared->clone();
  return Done{};
}

Compaction CharacterAgents::compact() {
  std::vector<Handle> order;
  for (const AgentGraphs* graphs : {&shared, &agents}) {
    for (std::uint32_t agent = 0; agent < graphs->count(); ++agent) {
      const std::vector<Handle>& entities = graphs->graph(agent).entities;
      order.insert(order.end(), entities.begin(), entities.end());
    }
  }
  Compaction all{.complete = true};
  for (EntityPools::Kind kind = 0; kind < pools.kind_count(); ++kind) {
    for (Pool* pool : {&pools.pool(kind), &pools.shared_pool(kind)}) {
      const Compaction one = pool->compact(order);
      all.blocks_moved += one.blocks_moved;
      all.bytes_given_back += one.bytes_given_back;
    }
  }
  return all;
}

void CharacterAgents::add_memory(std::vector<KindMemory>& kinds) const {
  for (EntityPools::Kind kind = 0; kind < pools.kind_count(); ++kind) {
    const char* const name = pools.layout(kind).kind->name;
    auto found = std::ranges::find(kinds, std::string_view(name), &KindMemory::kind);
    if (found == kinds.end()) found = kinds.insert(kinds.end(), {.kind = name, .own = {}, .shared = {}});
    add(found->own, pools.pool(kind).memory());
    add(found->shared, pools.shared_pool(kind).memory());
  }
}

std::size_t CharacterAgents::bytes_alive() const {
  std::size_t bytes = agents.bytes();
  for (EntityPools::Kind kind = 0; kind < pools.kind_count(); ++kind) bytes += pools.pool(kind).memory().bytes_alive;
  return bytes;
}

const CharacterAgents& nobody() {
  struct Nobody : CharacterAgents {
    Nobody() : CharacterAgents(without_bones()) { agents.add(); }
    // It has a level, as every skeleton that a PU is told of.
    static std::shared_ptr<const Character> without_bones() {
      auto character = std::make_shared<Character>();
      character->skeleton.level_bone_counts = {0};
      return character;
    }
  };
  static const Nobody one;
  return one;
}

LocalStoreDemand local_store_demand(std::span<const std::unique_ptr<CharacterAgents>> characters, StreamKind stream) {
  LocalStoreDemand demand{.skeleton = {}, .stream = stream, .largest = {}};
  int most_bones = 0;
  for (const std::unique_ptr<CharacterAgents>& one : characters) {
    demand.largest.widen(one->agents.largest_needs());
    demand.shared_entity_bytes =
        std::max<std::size_t>(demand.shared_entity_bytes, one->shared.largest_needs().entity_bytes);
    if (one->skeleton().bone_count() <= most_bones) continue;
    most_bones = one->skeleton().bone_count();
    demand.skeleton = one->skeleton().name;
    demand.falls_back =
        std::ranges::any_of(one->clips, [](const ClipStreams& clip) { return clip.sampled == nullptr; });
  }
  return demand;
}

}  // namespace throng::anim
