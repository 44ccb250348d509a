#include "engine/anim/run/lod.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace throng::anim {
namespace {

constexpr float near_enough_to_divide = 1e-3F;  // metres
constexpr float return_margin = 0.9F;           // of a level's distance: nearer than this the level below comes back

float dot(const glm::vec3& a, const glm::vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// Distances squared, so that no square root stands between a knob and its effect.
struct Thresholds {
  std::array<float, longest_interval> longer_interval;  // [i]: from here on interval i + 2
  std::array<float, most_bone_levels - 1> next_level;
  std::array<float, most_bone_levels - 1> level_back;
};

Thresholds square_thresholds(const LodRules& rules) {
  Thresholds squares{};
  for (std::size_t step = 0; step < squares.longer_interval.size(); ++step) {
    const float from = rules.full_rate_distance + rules.interval_growth * static_cast<float>(step);
    squares.longer_interval[step] = from * from;
  }
  for (std::size_t level = 0; level < squares.next_level.size(); ++level) {
    const float from = rules.level_distances[level];
    squares.next_level[level] = from * from;
    squares.level_back[level] = (from * return_margin) * (from * return_margin);
  }
  return squares;
}

int interval_at(float squared_distance, const LodRules& rules, const Thresholds& squares) {
  int interval = 1;
  while (interval < rules.largest_interval &&
         squared_distance >= squares.longer_interval[static_cast<std::size_t>(interval - 1)]) {
    ++interval;
  }
  return interval;
}

// `current` is the level shown now; pass 0 and `fresh` for an agent that was out of view.
int bone_level_at(float squared_distance, int current, bool fresh, int level_count, const Thresholds& squares) {
  int level = std::min(current, level_count - 1);
  while (level + 1 < level_count && squared_distance >= squares.next_level[static_cast<std::size_t>(level)]) ++level;
  while (!fresh && level > 0 && squared_distance < squares.level_back[static_cast<std::size_t>(level - 1)]) --level;
  return level;
}

// Frames until the next frame that is the agent's own: 1 to interval.
int frames_to_own_turn(std::uint64_t agent, std::uint64_t frame, std::uint64_t interval) {
  const std::uint64_t own = agent % interval;
  const std::uint64_t now = frame % interval;
  return static_cast<int>(own > now ? own - now : own + interval - now);
}

bool in_view(const glm::vec3& centre, float radius, const LodCamera& camera) {
  return std::all_of(camera.frustum.begin(), camera.frustum.end(),
                     [&](const glm::vec4& plane) { return dot(glm::vec3(plane), centre) + plane.w >= -radius; });
}

float squared(const glm::vec3& from_camera) { return dot(from_camera, from_camera); }

struct Decision {
  int interval;
  int look_ahead;
  int bone_level;
};

Decision decide(const LodFrame& frame, const Thresholds& squares, const LodState& state, std::size_t agent,
                int level_count, float squared_distance) {
  const bool fresh = state.was_visible[agent] == 0;
  const int shown = fresh ? 0 : state.bone_level[agent];
  const int levels = frame.rules.bone_lod ? level_count : 1;
  const bool forced = frame.force.concerns(agent);
  const bool has_level = forced && frame.force.bone_level >= 0, has_interval = forced && frame.force.interval > 0;
  const int bone_level = has_level ? std::min(frame.force.bone_level, level_count - 1)
                                   : bone_level_at(squared_distance, shown, fresh, levels, squares);
  if (frame.rules.rule == LodRule::off) return {1, 1, bone_level};
  const int interval = has_interval ? frame.force.interval : interval_at(squared_distance, frame.rules, squares);
  const int own_turn = frames_to_own_turn(agent, frame.number, static_cast<std::uint64_t>(interval));
  return {interval, fresh ? 1 : own_turn, bone_level};
}

void update(LodState& state, std::size_t agent, std::uint64_t frame, const Decision& decision) {
  state.interval[agent] = static_cast<std::uint8_t>(decision.interval);
  state.bone_level[agent] = static_cast<std::uint8_t>(decision.bone_level);
  state.next_update[agent] = frame + static_cast<std::uint64_t>(decision.look_ahead);
}

void check(const LodFrame& frame, const LodState& state) {
  assert(frame.positions.size() == frame.scales.size());
  assert(frame.positions.size() == state.next_update.size());
  assert(frame.rules.largest_interval >= 1 && frame.rules.largest_interval <= longest_interval);
  assert(frame.character_of.empty() || frame.character_of.size() == frame.positions.size());
  assert(frame.rules.interval_growth > 0.0F);
  assert(frame.force.interval >= 0 && frame.force.interval <= longest_interval);
  static_cast<void>(frame);
  static_cast<void>(state);
}

}  // namespace

void LodState::make_all_due() { std::ranges::fill(was_visible, std::uint8_t{0}); }

void LodState::resize(std::size_t agents, LodSelection& selection) {
  next_update.assign(agents, 0);
  interval.assign(agents, 1);
  bone_level.assign(agents, 0);
  was_visible.assign(agents, 0);
  selection.room_for_visible.resize(agents);
  selection.room_for_due.resize(agents);
  selection.visible = std::span(selection.room_for_visible).first(0);
  selection.due = std::span(selection.room_for_due).first(0);
}

namespace {

const LodCharacter& character_of(const LodFrame& frame, std::size_t agent) {
  static constexpr LodCharacter person;
  if (frame.characters.empty()) return person;
  return frame.characters[frame.character_of.empty() ? 0 : frame.character_of[agent]];
}

/// Agents that one job decides for, one after the other. Lists begin where they would if all were chosen.
struct LodTile {
  std::size_t first = 0, end = 0;
  std::size_t visible = 0, due = 0;  // how many

  void decide_all(const LodFrame& frame, const Thresholds& squares, LodState& state, LodSelection& selection) {
    visible = due = 0;
    for (std::size_t agent = first; agent < end; ++agent) decide_one(frame, squares, state, selection, agent);
  }

 private:
  void decide_one(const LodFrame& frame, const Thresholds& squares, LodState& state, LodSelection& selection,
                  std::size_t agent) {
    const LodCharacter& character = character_of(frame, agent);
    const float scale = frame.scales[agent];
    const glm::vec3 centre = frame.positions[agent] + glm::vec3(0.0F, character.centre_height * scale, 0.0F);
    const bool is_visible = in_view(centre, character.radius * scale, frame.camera);
    const float squared_distance = squared(centre - frame.camera.position);
    const bool turn_has_come = state.was_visible[agent] == 0 || frame.number >= state.next_update[agent];
    if (frame.rules.rule == LodRule::off || (is_visible && turn_has_come)) {
      const Decision decision = decide(frame, squares, state, agent, character.level_count, squared_distance);
      update(state, agent, frame.number, decision);
      selection.room_for_due[first + due++] = {static_cast<std::uint32_t>(agent),
                                               static_cast<std::uint8_t>(decision.look_ahead), state.bone_level[agent]};
    }
    if (is_visible) {
      const float distance = std::max(std::sqrt(squared_distance), near_enough_to_divide);
      selection.room_for_visible[first + visible++] = {
          static_cast<std::uint32_t>(agent), character.height * scale * frame.camera.pixels_per_unit / distance,
          state.interval[agent], state.bone_level[agent]};
    }
    state.was_visible[agent] = is_visible ? 1 : 0;
  }
};

/// Closes the gaps between the lists of the tiles; returns the length of the whole.
template <typename Element>
std::span<Element> joined(std::vector<Element>& room, std::span<const LodTile> tiles, std::size_t LodTile::*count) {
  std::size_t length = 0;
  for (const LodTile& tile : tiles) {
    const auto from = room.begin() + static_cast<std::ptrdiff_t>(tile.first);
    std::copy(from, from + static_cast<std::ptrdiff_t>(tile.*count),
              room.begin() + static_cast<std::ptrdiff_t>(length));
    length += tile.*count;
  }
  return {room.data(), length};
}

constexpr std::size_t agents_worth_a_job = 512;
constexpr std::size_t most_lod_tiles = 256;

}  // namespace

void select_for_update(const LodFrame& frame, LodState& state, LodSelection& selection, Executor& executor, int jobs) {
  check(frame, state);
  const std::size_t agents = frame.positions.size();
  const std::size_t count =
      std::clamp<std::size_t>(std::min(agents / agents_worth_a_job, std::size_t(jobs)), 1, most_lod_tiles);
  std::array<LodTile, most_lod_tiles> tiles;
  for (std::size_t i = 0; i < count; ++i) tiles[i] = {.first = agents * i / count, .end = agents * (i + 1) / count};

  struct Context {
    const LodFrame& frame;
    Thresholds squares;
    LodState& state;
    LodSelection& selection;
    std::span<LodTile> tiles;
  } shared{frame, square_thresholds(frame.rules), state, selection, std::span(tiles).first(count)};
  executor.run(static_cast<int>(count), {[](void* context, int tile) {
                                           auto& all = *static_cast<Context*>(context);
                                           all.tiles[static_cast<std::size_t>(tile)].decide_all(
                                               all.frame, all.squares, all.state, all.selection);
                                         },
                                         &shared});
  selection.visible = joined(selection.room_for_visible, shared.tiles, &LodTile::visible);
  selection.due = joined(selection.room_for_due, shared.tiles, &LodTile::due);
}

void select_for_update(const LodFrame& frame, LodState& state, LodSelection& selection) {
  InOrder here;
  select_for_update(frame, state, selection, here, 1);
}

}  // namespace throng::anim
