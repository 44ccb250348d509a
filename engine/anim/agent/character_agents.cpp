#include "engine/anim/agent/character_agents.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <set>
#include <string_view>
#include <utility>

#include "engine/anim/asset/reference_pose.h"
#include "engine/base/text/plain_text.h"

namespace throng::anim {
namespace {

ClipStreams streams_of(const Character& character, int index) {
  const BakedClip& clip = character.clips[static_cast<std::size_t>(index)];
  if (clip.is_empty()) return {};
  return {.keyframe = clip.keyframe(),
          .sampled = clip.sampled(),
          .duration = clip.duration,
          .root_motion = clip.root_motion.keys.empty() ? nullptr : &clip.root_motion,
          .data_keys = clip.data_keys,
          .curves = clip.curves.empty() ? nullptr : &clip.curves,
          .morphs = clip.morphs.empty() ? nullptr : &clip.morphs,
          .ground_speed = clip.ground_speed()};
}

std::vector<ClipStreams> all_streams_of(const Character& character) {
  std::vector<ClipStreams> streams;
  const int count = static_cast<int>(character.clips.size());
  streams.reserve(character.clips.size());
  for (int clip = 0; clip < count; ++clip) streams.push_back(streams_of(character, clip));
  return streams;
}

bool keeps_clip(const Character& before, const Character& after, std::size_t place) {
  static const BakedClip none;
  const BakedClip& then = place < after.clips.size() ? after.clips[place] : none;
  return then.keyframe() == before.clips[place].keyframe() && then.sampled() == before.clips[place].sampled();
}

std::string in_words(std::size_t count) {
  return count == 1 ? std::string("1 agent") : std::to_string(count) + " agents";
}

/// A player of a clip that another character has not in its place.
struct LostPlayer {
  std::uint32_t clip;
  std::uint32_t owner;

  friend bool operator<(const LostPlayer& a, const LostPlayer& b) {
    return a.clip != b.clip ? a.clip < b.clip : a.owner < b.owner;
  }
};

/// Says which agents play a clip that `after` has not in its place; empty: none do.
std::string played_clip(const Character& before, const Character& after, const EntityPools& pools) {
  std::set<LostPlayer> lost;
  const auto note = [&](const std::byte* block) {
    const auto& player = *reinterpret_cast<const Player*>(block);
    if (!keeps_clip(before, after, player.clip)) lost.insert({.clip = player.clip, .owner = player.state.owner});
  };
  for (const EntityPools::Kind kind : {EntityPools::sampled_players, EntityPools::keyframe_players}) {
    pools.pool(kind).for_each_block(note);
    pools.shared_pool(kind).for_each_block(note);
  }
  if (lost.empty()) return {};
  const std::uint32_t clip = lost.begin()->clip;
  const auto agents = std::ranges::count_if(
      lost, [&](const LostPlayer& one) { return one.clip == clip && (one.owner & shared_owner) == 0; });
  const std::string who = agents == 0 ? std::string("a shared graph") : in_words(static_cast<std::size_t>(agents));
  return who + (agents > 1 ? " play " : " plays ") + in_quotes(before.clips[clip].name) +
         (agents > 1 ? ": let them play something else first" : ": let it play something else first");
}

/// Returns how many graphs have a channel that has no fault now and would have one, and the fault of the last.
std::pair<std::size_t, const char*> faulty_graphs(const AgentGraphs& graphs, const EntityBuilder& now,
                                                  const EntityBuilder& then) {
  std::size_t count = 0;
  const char* fault = nullptr;
  for (std::uint32_t graph = 0; graph < graphs.count(); ++graph) {
    bool has_fault = false;
    for (std::size_t place = 0; place < graphs.channel_count(graph); ++place) {
      const Channel& channel = *graphs.channel(graph, place).part;
      const char* const found = channel.fault(then);
      if (found == nullptr || channel.fault(now) != nullptr) continue;
      fault = found;
      has_fault = true;
    }
    count += has_fault ? 1 : 0;
  }
  return {count, fault};
}

/// Says which place would go from one clip to another at once; empty: none would.
std::string exchanged_clip(const Character& before, const Character& after) {
  const std::size_t places = std::min(before.clips.size(), after.clips.size());
  for (std::size_t place = 0; place < places; ++place) {
    const BakedClip &old = before.clips[place], &other = after.clips[place];
    if (old.is_empty() || other.is_empty() || keeps_clip(before, after, place)) continue;
    return "place " + std::to_string(place) + " would go from " + in_quotes(old.name) + " to " + in_quotes(other.name) +
           " at once, and ids of the one would name the other: take the character without " + in_quotes(old.name) +
           " first";
  }
  return {};
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
  assert(reordered->clips.size() == character->clips.size() && "another character");
  still_pose = anim::still_pose(reordered->skeleton);
  agents.restart_keyframes();
  shared.restart_keyframes();
  return replace_clips(std::move(reordered));
}

std::shared_ptr<const Character> CharacterAgents::replace_clips(std::shared_ptr<const Character> other) {
  assert(other->skeleton.bone_count() == skeleton().bone_count() && "another character");
  clips = all_streams_of(*other);
  return std::exchange(character, std::move(other));
}

std::string CharacterAgents::bound_to_clips(const Character& other) {
  if (std::string played = played_clip(*character, other, pools); !played.empty()) return played;
  const EntityBuilder::About about{.masks = masks.size(), .selections = selections.size()};
  const std::vector<ClipStreams> others = all_streams_of(other);
  const EntityBuilder now(pools, clips, about), then(pools, others, about);
  constexpr const char* cannot = " could not play the other clips: ";
  if (const auto [count, fault] = faulty_graphs(agents, now, then); count > 0) {
    return "a channel of " + in_words(count) + cannot + fault;
  }
  if (const auto [count, fault] = faulty_graphs(shared, now, then); count > 0) {
    return std::string("a shared channel") + cannot + fault;
  }
  return exchanged_clip(*character, other);
}

std::string CharacterAgents::bound_to_bone_order() const {
  if (!selections.empty()) return "selections of bones";
  if (!joint_programs.empty()) return "a list of joints";
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

void CharacterAgents::reorder_masks(std::span<const int> places) {
  for (std::size_t i = 0; i < masks.size(); ++i) {
    std::vector<SubtreeWeight> weights;
    for (int bone = 0; bone < skeleton().bone_count(); ++bone) {
      weights.push_back({.bone = places[static_cast<std::size_t>(bone)], .weight = masks[i].weight(bone)});
    }
    masks[i] = BoneMask(masks[i].name(), skeleton(), weights);
    mask_weights[i] = masks[i].packet(0);
  }
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

const CharacterAgents& no_agents() {
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
    demand.plays_keys = std::ranges::any_of(one->clips, [&](const ClipStreams& clip) {
      return !clip.is_empty() && clip.played(stream) == StreamKind::keyframe;
    });
  }
  return demand;
}

}  // namespace throng::anim
