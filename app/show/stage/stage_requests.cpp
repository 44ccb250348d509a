#include "app/show/stage/stage_requests.h"

#include <string>
#include <utility>

#include "app/people/wardrobe/cast_rules_text.h"
#include "app/settings/option_values.h"
#include "app/show/stage/stage.h"
#include "engine/base/text/plain_text.h"

namespace throng::app {

anim::Status has_character(const Stage& stage, CharacterNumber character) {
  const std::size_t count = stage.people().size();
  if (character < count) return anim::Done{};
  return anim::Error{"there is no character " + std::to_string(character) + ", only 0 to " + std::to_string(count - 1)};
}

anim::Status has_agent(const Stage& stage, std::uint32_t agent) {
  const std::size_t count = stage.crowd().size();
  if (agent < count) return anim::Done{};
  return anim::Error{"there is no agent " + std::to_string(agent) + ", only 0 to " + std::to_string(count - 1)};
}

anim::Status carry_out(const SetShare& share, Stage& stage) {
  if (anim::Status there = has_character(stage, share.character); !there) return there;
  if (!is_share(share.share)) return anim::Error{"a share must be above 0 and at most " + shortest_text(most_share)};
  stage.set_roles(share.character, stage.people()[share.character].roles.clips, share.share);
  return anim::Done{};
}

anim::Status carry_out(const SetRoles& roles, Stage& stage) {
  if (anim::Status there = has_character(stage, roles.character); !there) return there;
  const CharacterSource& person = stage.people()[roles.character];
  if (!has_clips(person, roles.clips)) return anim::Error{person.name + " has no such clip"};
  stage.set_roles(roles.character, roles.clips);
  return anim::Done{};
}

anim::Status carry_out(const SetRules& rules, Stage& stage) {
  if (anim::Status there = has_character(stage, rules.character); !there) return there;
  auto read = rules_of_text(rules.rules);
  anim::Status set = read ? stage.set_cast_rules(rules.character, std::move(*read), rules.file) : read.error();
  if (set || rules.file.empty()) return set;
  return anim::Error{plain_text(rules.file) + ": " + set.error().message};
}

anim::Status carry_out(const Select& select, Stage& stage) {
  if (select.agent) {
    if (anim::Status there = has_agent(stage, *select.agent); !there) return there;
  }
  stage.select(select.agent);
  return anim::Done{};
}

anim::Status carry_out(const Push& push, Stage& stage) {
  if (anim::Status there = has_agent(stage, push.agent); !there) return there;
  return stage.animated().push_over(push.agent, push.direction);
}

anim::Status carry_out(const Hold& hold, Stage& stage) {
  if (!hold.agent) return stage.animated().let_go_of_clip(), anim::Done{};
  if (anim::Status there = has_agent(stage, *hold.agent); !there) return there;
  stage.animated().hold_clip(*hold.agent, hold.seconds);
  return anim::Done{};
}

anim::Status carry_out(const Seek& seek, Stage& stage) {
  const bool has_clock = stage.crowd().tracks() != nullptr && !stage.trajectories()->is_live;
  if (!has_clock) return anim::Error{"the crowd follows no file, so it goes to no other time of one"};
  if (seek.clock != stage.crowd().tracks()->clock()) stage.set_track_clock(seek.clock);
  return anim::Done{};
}

}  // namespace throng::app
