#include "engine/anim/api/taken_agents.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/anim/api/crowd_parts.h"
#include "engine/anim/base/misuse.h"
#include "engine/base/glm_numbers.h"

namespace throng::detail {
namespace {

constexpr std::size_t least_room = 64;
constexpr Ticks longest_frame = 3600 * ticks_per_second;
/// No place of a crowd is farther off, in metres: squares of it are still numbers.
constexpr float farthest = 1e9F;

bool is_place(const Vec3& place) {
  return std::abs(place.x) <= farthest && std::abs(place.y) <= farthest && std::abs(place.z) <= farthest;
}

}  // namespace

const char* fault_of(const SaidAgents& said, std::size_t numbers) {
  if (said.positions.size() < numbers) return "the frame's positions have no place for each agent's number";
  if (!said.scales.empty() && said.scales.size() < numbers) return "the frame's scales have no place for each number";
  return nullptr;
}

const char* fault_of(const Camera& camera) {
  if (!is_place(camera.position) || !is_place(camera.forward)) return "a camera's place and direction are numbers";
  if (camera.forward == Vec3{}) return "a camera's direction is not 0";
  for (const std::array<float, 4>& plane : camera.frustum) {
    for (const float number : plane) {
      if (!(std::abs(number) <= farthest)) return "the planes of a camera are numbers";
    }
  }
  const bool is_scale = camera.pixels_per_unit > 0.0F && camera.pixels_per_unit <= farthest;
  return is_scale ? nullptr : "Camera::pixels_per_unit is above 0";
}

const char* fault_of(const LodRules& rules) {
  if (rules.largest_interval < 1 || rules.largest_interval > longest_interval) {
    return "LodRules::largest_interval is from 1 to 16 frames";
  }
  const auto is_within = [](auto number, auto least) {
    return number >= least && static_cast<float>(number) <= farthest;
  };
  if (!is_within(rules.interval_growth, 1e-3F) || !is_within(rules.full_rate_distance, 0.0F)) {
    return "the distances of LodRules are not negative, and interval_growth is at least a millimetre";
  }
  if (!is_within(rules.error_pixels, 0.0F) || !is_within(rules.budget_milliseconds, 0.0)) {
    return "the limits of LodRules are not negative";
  }
  if (!is_within(rules.centre_importance, 1e-3F)) return "LodRules::centre_importance is above 0";
  return nullptr;
}

const char* fault_of_step(Ticks step) {
  return step < Ticks{} || step > longest_frame ? "the frame's step is from 0 to an hour" : nullptr;
}

bool TakenAgents::make_room(std::size_t numbers) {
  if (numbers <= room()) return false;
  const std::size_t more = std::max({numbers, 2 * room(), least_room});
  positions_.resize(more);
  scales_.resize(more, 1.0F);
  characters_.resize(more, 0);
  clips_.resize(more, -1);
  is_absent_.resize(more, 1);
  generations_.resize(more, whichever);
  requests_.resize(more, 0);
  newcomers_.reserve(more);
  asked_.reserve(more);
  return true;
}

void TakenAgents::take(const Crowd& crowd, const SaidAgents& said, const char* call) {
  const AgentNotes& notes = crowd.parts().notes;
  std::ranges::fill(is_absent_, std::uint8_t{1});
  newcomers_.clear();
  asked_.clear();
  for (const AgentId agent : crowd.agents()) {
    const std::uint32_t number = agent.number;
    const float scale = said.scales.empty() ? 1.0F : said.scales[number];
    if (!is_place(said.positions[number]) || !(scale > 0.0F && scale <= farthest)) {
      anim::report_misuse({call, "positions and scales are numbers; an agent with others is left out"});
      continue;
    }
    is_absent_[number] = 0;
    positions_[number] = to_glm(said.positions[number]);
    scales_[number] = scale;
    characters_[number] = notes.characters[number];
    clips_[number] = notes.clips[number];
    const bool is_asked = std::exchange(requests_[number], notes.requests[number]) != notes.requests[number];
    if (std::exchange(generations_[number], agent.generation) != agent.generation) {
      newcomers_.push_back(number);
    } else if (is_asked) {
      asked_.push_back(number);
    }
  }
}

void TakenAgents::tell(const Crowd& crowd, anim::LevelOfDetail& lod) const {
  const CrowdParts& parts = crowd.parts();
  for (const std::uint32_t number : newcomers_) lod.make_due(number);
  for (const std::uint32_t number : asked_) {
    // A pose that cannot be wound back stands ahead, and is shown first.
    if (std::as_const(*parts.system).agent(number).can_wind_back()) lod.make_due(number);
    lod.change_clip(number, parts.notes.fades_until[number]);
  }
}

}  // namespace throng::detail
