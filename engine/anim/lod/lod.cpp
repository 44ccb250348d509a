#include "engine/anim/lod/lod.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "engine/anim/lod/lod_choices.h"
#include "engine/base/glm_numbers.h"
#include "engine/base/run_jobs.h"

namespace throng::anim {
namespace {

constexpr float near_enough_to_divide = 1e-3F;  // metres
constexpr float return_margin = 0.9F;           // of a level's distance: the finer level returns below it

float dot(const glm::vec3& a, const glm::vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// Holds squared distances, which are compared without a square root.
struct Thresholds {
  std::array<float, longest_interval> longer_interval;  // [i]: interval i + 2 begins here
  std::array<float, max_bone_levels - 1> next_level;
  std::array<float, max_bone_levels - 1> level_back;
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

// `current` is the level shown now. For an agent that was out of view pass 0 and `fresh`.
int bone_level_at(float squared_distance, int current, bool fresh, int level_count, const Thresholds& squares) {
  int level = std::min(current, level_count - 1);
  while (level + 1 < level_count && squared_distance >= squares.next_level[static_cast<std::size_t>(level)]) ++level;
  while (!fresh && level > 0 && squared_distance < squares.level_back[static_cast<std::size_t>(level - 1)]) --level;
  return level;
}

// Returns the frames until the agent's next own frame: 1 to interval.
int frames_to_own_turn(std::uint64_t agent, std::uint64_t frame, std::uint64_t interval) {
  const std::uint64_t own = agent % interval;
  const std::uint64_t now = frame % interval;
  return static_cast<int>(own > now ? own - now : own + interval - now);
}

bool in_view(const glm::vec3& centre, float radius, const Camera& camera) {
  return std::all_of(camera.frustum.begin(), camera.frustum.end(), [&](const std::array<float, 4>& plane) {
    return dot({plane[0], plane[1], plane[2]}, centre) + plane[3] >= -radius;
  });
}

float squared(const glm::vec3& from_camera) { return dot(from_camera, from_camera); }

/// An agent as this frame sees it.
struct Seen {
  float squared_distance;   // square metres
  float metres_a_pixel;     // error in the character's own space that shows as one pixel, over its importance
  bool fresh;               // it was out of view, or its graph has changed
  const MotionLod* motion;  // null where no cost is counted
};

struct Decision {
  int interval;
  int look_ahead;
  int bone_level;
};

LodChoice choose_by_distance(const LodFrame& frame, const Thresholds& squares, int shown_level, int level_count,
                             const Seen& seen) {
  const int levels = frame.rules.bone_lod ? level_count : 1;
  const int shown = seen.fresh ? 0 : shown_level;
  const int level = bone_level_at(seen.squared_distance, shown, seen.fresh, levels, squares);
  const int interval = frame.rules.rule == LodRule::off ? 1 : interval_at(seen.squared_distance, frame.rules, squares);
  return {static_cast<std::uint8_t>(interval), static_cast<std::uint8_t>(level)};
}

LodChoice choose_within_tolerance(const LodFrame& frame, const Seen& seen, LodChoice shown) {
  const float allowed = frame.tolerance_pixels * seen.metres_a_pixel;
  if (seen.fresh || shown.interval > frame.rules.largest_interval) return seen.motion->choose(allowed);
  return seen.motion->choose(allowed, shown);
}

void apply_force(const LodForce& force, std::size_t agent, int level_count, LodChoice& choice) {
  if (!force.concerns(agent)) return;
  if (force.interval > 0) choice.interval = static_cast<std::uint8_t>(force.interval);
  if (force.bone_level >= 0) choice.bone_level = static_cast<std::uint8_t>(std::min(force.bone_level, level_count - 1));
}

Decision decide(const LodFrame& frame, const Thresholds& squares, const LodState& state, std::size_t agent,
                int level_count, const Seen& seen) {
  LodChoice choice = frame.rules.rule == LodRule::budget
                         ? choose_within_tolerance(frame, seen, {state.interval[agent], state.bone_level[agent]})
                         : choose_by_distance(frame, squares, state.bone_level[agent], level_count, seen);
  apply_force(frame.force, agent, level_count, choice);
  if (frame.rules.rule == LodRule::off) return {1, 1, choice.bone_level};
  const int own_turn = frames_to_own_turn(agent, frame.number, choice.interval);
  return {choice.interval, seen.fresh ? 1 : own_turn, choice.bone_level};
}

void update(LodState& state, std::size_t agent, std::uint64_t frame, const Decision& decision) {
  state.interval[agent] = static_cast<std::uint8_t>(decision.interval);
  state.bone_level[agent] = static_cast<std::uint8_t>(decision.bone_level);
  // The next frame may be of the same turn, where it is shorter than others.
  state.next_update[agent] = decision.look_ahead == 1 ? frame : frame + static_cast<std::uint64_t>(decision.look_ahead);
}

void check(const LodFrame& frame, const LodState& state) {
  assert(frame.positions.size() == frame.scales.size());
  assert(frame.positions.size() == state.next_update.size());
  assert(frame.rules.largest_interval >= 1 && frame.rules.largest_interval <= longest_interval);
  assert(frame.character_of.empty() || frame.character_of.size() == frame.positions.size());
  assert(frame.clips.empty() || frame.clips.size() == frame.positions.size());
  assert(frame.changing.empty() || frame.changing.size() == frame.positions.size());
  assert(frame.importance.empty() || frame.importance.size() == frame.positions.size());
  assert(frame.absent.empty() || frame.absent.size() == frame.positions.size());
  assert(frame.rules.interval_growth > 0.0F);
  assert(frame.rules.rule != LodRule::budget || (frame.choices != nullptr && frame.tolerance_pixels > 0.0F));
  assert(frame.force.interval >= 0 && frame.force.interval <= longest_interval);
  static_cast<void>(frame);
  static_cast<void>(state);
}

}  // namespace

void LodState::make_all_due() { std::ranges::fill(frames_seen, std::uint8_t{0}); }

void LodState::resize(std::size_t agents, LodSelection& selection) {
  next_update.assign(agents, 0);
  interval.assign(agents, 1);
  bone_level.assign(agents, 0);
  frames_seen.assign(agents, 0);
  is_called.assign(agents, 0);
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

const MotionLod* motion_of(const LodFrame& frame, std::size_t agent) {
  if (frame.choices == nullptr) return nullptr;
  const std::size_t character = frame.character_of.empty() ? 0 : frame.character_of[agent];
  if (!frame.changing.empty() && frame.changing[agent] != 0) return &frame.choices->changing(character);
  return &frame.choices->of(character, frame.clips.empty() ? 0 : frame.clips[agent]);
}

float cosine_of_degrees(float degrees) { return std::cos(degrees * std::numbers::pi_v<float> / 180.0F); }

// Away from the middle of the picture, a motion across the line of sight covers more pixels. The factor is one over
// the squared cosine of the angle from the middle.
constexpr float least_cosine = 0.5F;

float metres_a_pixel(const LodFrame& frame, float cosine_of_centre, std::size_t agent, const glm::vec3& from_camera,
                     float distance) {
  const float cosine = std::clamp(dot(from_camera, to_glm(frame.camera.forward)) / distance, least_cosine, 1.0F);
  const float pixels = frame.scales[agent] * frame.camera.pixels_per_unit / (distance * cosine * cosine);
  const float importance = frame.importance.empty() ? 1.0F : frame.importance[agent];
  return 1.0F / (pixels * importance * (cosine >= cosine_of_centre ? frame.rules.centre_importance : 1.0F));
}

constexpr std::uint8_t frames_of_coming_into_view = 2;  // one update for its pose, one to look ahead from there

/// Agents that one job decides for, in order. Its lists begin where they would if all agents before were chosen.
struct LodTile {
  std::size_t first = 0, end = 0;
  std::size_t visible = 0, due = 0;  // counts
  LodCost cost;

  void decide_all(const LodFrame& frame, const Thresholds& squares, LodState& state, LodSelection& selection) {
    visible = due = 0;
    by_tolerance_.fill(0);
    const float cosine_of_centre = cosine_of_degrees(frame.rules.centre_degrees);
    for (std::size_t agent = first; agent < end; ++agent) {
      const bool is_there = frame.absent.empty() || frame.absent[agent] == 0;
      if (is_there) {
        decide_one(frame, squares, cosine_of_centre, state, selection, agent);
      } else {
        state.frames_seen[agent] = 0;
      }
    }
    std::ranges::copy(by_tolerance_, cost.by_tolerance.begin());
  }

 private:
  void decide_one(const LodFrame& frame, const Thresholds& squares, float cosine_of_centre, LodState& state,
                  LodSelection& selection, std::size_t agent) {
    const LodCharacter& character = character_of(frame, agent);
    const float scale = frame.scales[agent];
    const glm::vec3 centre = frame.positions[agent] + glm::vec3(0.0F, character.centre_height * scale, 0.0F);
    const glm::vec3 from_camera = centre - to_glm(frame.camera.position);
    const bool is_visible = in_view(centre, character.radius * scale, frame.camera);
    std::uint8_t& frames_seen = state.frames_seen[agent];
    Seen seen{.squared_distance = squared(from_camera),
              .metres_a_pixel = 0.0F,
              .fresh = frames_seen == 0 || state.is_called[agent] != 0,
              .motion = motion_of(frame, agent)};
    const float distance = std::max(std::sqrt(seen.squared_distance), near_enough_to_divide);
    const bool turn_has_come = seen.fresh || (!frame.stands_still && frame.number >= state.next_update[agent]);
    const bool is_due = frame.rules.rule == LodRule::off || (is_visible && turn_has_come);
    if (frame.rules.rule == LodRule::budget && is_visible && (is_due || frame.counts_cost)) {
      seen.metres_a_pixel = metres_a_pixel(frame, cosine_of_centre, agent, from_camera, distance);
    }
    if (is_due) {
      const Decision decision = decide(frame, squares, state, agent, character.level_count, seen);
      update(state, agent, frame.number, decision);
      selection.room_for_due[first + due++] = static_cast<std::uint32_t>(agent);
    }
    if (is_visible) {
      selection.room_for_visible[first + visible++] = {
          static_cast<std::uint32_t>(agent), character.height * scale * frame.camera.pixels_per_unit / distance,
          state.interval[agent], state.bone_level[agent]};
    }
    if (seen.motion != nullptr) {
      count_cost(seen, is_visible, is_due, state.bone_level[agent], frame.counts_cost);
      if (is_due && frames_seen < frames_of_coming_into_view)
        cost.reappeared += seen.motion->update_cost(state.bone_level[agent]);
    }
    frames_seen = is_visible ? std::min<std::uint8_t>(frames_seen + 1, frames_of_coming_into_view) : 0;
    state.is_called[agent] = 0;
  }

  void count_cost(const Seen& seen, bool is_visible, bool is_due, std::size_t level, bool by_tolerance) {
    const std::uint32_t all_bones = seen.motion->update_cost(0);
    cost.everyone += all_bones;
    if (!is_visible) return;
    cost.visible += all_bones;
    if (by_tolerance) seen.motion->add_cost(seen.metres_a_pixel, by_tolerance_);
    if (!is_due) return;
    cost.due_all_bones += all_bones;
    cost.due += seen.motion->update_cost(level);
  }

  std::array<std::uint32_t, tolerance_steps> by_tolerance_{};
};

/// Closes the gaps between the lists of the tiles and returns the whole list.
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
constexpr std::size_t most_lod_tiles = 64;

}  // namespace

void select_for_update(const LodFrame& frame, LodState& state, LodSelection& selection, Executor& executor, int jobs) {
  check(frame, state);
  const std::size_t agents = frame.positions.size();
  const std::size_t count =
      std::clamp<std::size_t>(std::min(agents / agents_worth_a_job, std::size_t(jobs)), 1, most_lod_tiles);
  std::array<LodTile, most_lod_tiles> tiles;
  for (std::size_t i = 0; i < count; ++i) {
    tiles[i].first = agents * i / count;
    tiles[i].end = agents * (i + 1) / count;
  }

  const Thresholds squares = square_thresholds(frame.rules);
  run_jobs(executor, count, [&](std::size_t tile) { tiles.at(tile).decide_all(frame, squares, state, selection); });
  const std::span<const LodTile> decided = std::span(tiles).first(count);
  selection.visible = joined(selection.room_for_visible, decided, &LodTile::visible);
  selection.due = joined(selection.room_for_due, decided, &LodTile::due);
  selection.cost = {};
  for (const LodTile& tile : decided) selection.cost += tile.cost;
}

void select_for_update(const LodFrame& frame, LodState& state, LodSelection& selection) {
  InOrder here;
  select_for_update(frame, state, selection, here, 1);
}

}  // namespace throng::anim
