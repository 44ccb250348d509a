#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "throng/agent.h"

#include "engine/anim/api/convert.h"
#include "engine/anim/api/crowd_parts.h"
#include "engine/anim/base/misuse.h"
#include "engine/base/glm_numbers.h"

namespace throng {
namespace {

constexpr Ticks longest_way = 60 * ticks_per_second;  // a clip may play 32,767 times as fast as it was made

anim::AgentMotion motion_of(const detail::CrowdParts& crowd, AgentId agent) {
  return std::as_const(*crowd.system).agent(agent).motion();
}

/// What an agent met, to be told once all of it is known: the listener may change the crowd. A frame meets few, which
/// need no memory of their own.
template <typename Met>
class MetThings {
 public:
  void add(const Met& met) {
    if (count_ < few_.size()) {
      few_[count_++] = met;
    } else {
      more_.push_back(met);
    }
  }
  void tell(void (*visit)(void*, const Met&), void* context) const {
    for (const Met& met : std::span(few_).first(count_)) visit(context, met);
    for (const Met& met : more_) visit(context, met);
  }

 private:
  std::array<Met, 16> few_;
  std::size_t count_ = 0;
  std::vector<Met> more_;
};

// Public enumerators have the numbers of the library's own.
static_assert(static_cast<int>(KeyChoice::heaviest) == static_cast<int>(anim::KeyChoice::heaviest));
static_assert(static_cast<int>(KeyChoice::all) == static_cast<int>(anim::KeyChoice::all));

}  // namespace

bool detail::CrowdParts::are_near(Ticks from, Ticks to, const char* call) const {
  constexpr Ticks day = 24 * 3600 * ticks_per_second;
  const Ticks now = system->clock();
  const auto is_near = [&](Ticks time) { return time >= now - day && time <= now + day; };
  if (is_near(from) && is_near(to)) return true;
  return anim::report_misuse({call, "times are within a day of the clock"});
}

bool detail::CrowdParts::has(AgentId agent, const char* call) const {
  return system->agent(agent).exists() || anim::report_misuse({call, no_agent});
}

bool detail::CrowdParts::is_asked_in_time(Ticks from, Ticks to, const char* call) const {
  if (!are_near(from, to, call)) return false;
  if (to < from) return anim::report_misuse({call, "an interval ends before it begins"});
  return to - from <= longest_way || anim::report_misuse({call, "an interval is a minute at most: ask in each frame"});
}

RootMotion Motion::displacement(Ticks from, Ticks to) const {
  constexpr const char* call = "Motion::displacement";
  if (!crowd_->has(agent_, call) || !crowd_->are_near(from, to, call)) return {};
  const anim::RootMotion motion = motion_of(*crowd_, agent_).displacement(from, to);
  return {.displacement = from_glm(glm::vec3(motion.translation)), .turn = static_cast<float>(motion.yaw)};
}

float Motion::curve(std::uint32_t name) const {
  const anim::AgentView agent = std::as_const(*crowd_->system).agent(agent_);
  if (agent.exists() && name < agent.character().curve_names.size())
    return agent.motion().curve(name, crowd_->system->clock());
  return static_cast<float>(
      anim::report_misuse({"Motion::curve", "the agent has no curve of this name, an index of curve_names"}));
}

bool Motion::morph_weights(std::span<float> into) const {
  constexpr const char* call = "Motion::morph_weights";
  const anim::AgentView agent = std::as_const(*crowd_->system).agent(agent_);
  if (!agent.exists()) return anim::report_misuse({call, detail::no_agent});
  const std::size_t morphs = agent.character().morph_bones.size();
  if (into.size() < morphs) return anim::report_misuse({call, "there is no room for the weight of each morph"});
  std::ranges::fill(into, 0.0F);
  return agent.motion().add_morph_weights(crowd_->system->clock(), into.first(morphs));
}

std::optional<Place> Motion::absolute_root() const {
  if (!crowd_->has(agent_, "Motion::absolute_root")) return std::nullopt;
  const auto root = motion_of(*crowd_, agent_).absolute_root(crowd_->system->clock());
  if (!root) return std::nullopt;
  return Place{.position = from_glm(glm::vec3(root->position)), .rotation = from_glm(root->rotation)};
}

void Motion::visit_keys(Ticks from, Ticks to, KeyChoice choice, void (*visit)(void*, const DataKey&),
                        void* context) const {
  constexpr const char* call = "Motion::for_each_key";
  if (!crowd_->has(agent_, call) || !crowd_->is_asked_in_time(from, to, call)) return;
  const anim::Character& character = std::as_const(*crowd_->system).agent(agent_).character();
  MetThings<DataKey> met;
  const auto note = [&](const anim::DataKeyEvent& key) {
    met.add({.name = key.name, .clip = detail::id_of(character, key.clip), .time = key.time, .weight = key.weight});
  };
  motion_of(*crowd_, agent_).for_each_data_key(from, to, note, static_cast<anim::KeyChoice>(choice));
  met.tell(visit, context);
}

void Motion::visit_ends(Ticks from, Ticks to, void (*visit)(void*, const ClipEnd&), void* context) const {
  constexpr const char* call = "Motion::for_each_end";
  if (!crowd_->has(agent_, call) || !crowd_->are_near(from, to, call)) return;
  const anim::Character& character = std::as_const(*crowd_->system).agent(agent_).character();
  MetThings<ClipEnd> met;
  const auto note = [&](const anim::ClipEnd& end) {
    met.add({.clip = detail::id_of(character, end.clip), .time = end.time, .weight = end.weight});
  };
  motion_of(*crowd_, agent_).for_each_end(from, to, note);
  met.tell(visit, context);
}

}  // namespace throng
