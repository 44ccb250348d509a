#include "app/show/replayed_requests.h"

#include <string>
#include <utility>

#include "app/character/cast_files.h"
#include "app/wardrobe/cast_rules_text.h"

namespace throng::app {
namespace {

bool is_there(std::uint32_t agent, const Show& show) { return agent < show.stage().crowd().size(); }

anim::Status asked(const Tuning& tuning, Show& show) {
  const anim::Status applied = show.apply(tuning);
  return applied ? applied : anim::Status(anim::Error{"its values cannot be: " + applied.error().message});
}

anim::Status asked(const RecordedSelection& selection, Show& show) {
  if (selection.agent && !is_there(*selection.agent, show)) return anim::Error{"selects an agent that is not there"};
  show.hands().select(selection.agent);
  return anim::Done{};
}

anim::Status asked(const RecordedPush& push, Show& show) {
  if (!is_there(push.agent, show)) return anim::Error{"pushes an agent that is not there"};
  return show.hands().push(push.agent, push.direction);
}

anim::Status asked(const RecordedRoles& roles, Show& show) {
  const auto people = show.stage().people();
  if (roles.character >= people.size() || !has_clips(people[roles.character], roles.clips)) {
    return anim::Error{"plays a clip that is not there"};
  }
  show.set_roles(roles.character, roles.clips);
  return anim::Done{};
}

anim::Status asked(const RecordedHold& hold, Show& show) {
  if (!hold.agent) {
    show.hands().let_go_of_clip();
    return anim::Done{};
  }
  if (!is_there(*hold.agent, show)) return anim::Error{"holds the clip of an agent that is not there"};
  show.hands().hold_clip(*hold.agent, hold.seconds);
  return anim::Done{};
}

anim::Status asked(const RecordedRewind& /*rewind*/, Show& show) {
  const anim::Status gone = show.rewind();
  return gone ? gone : anim::Status(anim::Error{"cannot go back in time: " + gone.error().message});
}

anim::Status asked(const RecordedBoneOrder& order, Show& show) {
  if (order.character >= show.stage().people().size()) {
    return anim::Error{"orders the bones of a character that is not there"};
  }
  const anim::Status set = show.set_bone_lod(order.character, order.choice);
  return set ? set : anim::Status(anim::Error{"its order of bones cannot be: " + set.error().message});
}

anim::Status asked(const RecordedCharacters& others, Show& show) {
  auto cast = load_cast(entries_of(others.characters), show.load_options());
  if (!cast) return cast.error();
  if (cast->characters.size() != others.characters.size()) return anim::Error{"has a folder among its characters"};
  for (std::size_t i = 0; i < cast->characters.size(); ++i) {
    anim::Status became = become_recorded(others.characters[i], cast->characters[i]);
    if (!became) return became;
  }
  return show.replace_characters(std::move(cast->characters));
}

anim::Status asked(const RecordedRig& rig, Show& show) {
  if (rig.character >= show.stage().people().size())
    return anim::Error{"gives a body to a character that is not there"};
  const anim::Status set = show.set_rig(rig.character, rig.choices);
  return set ? set : anim::Status(anim::Error{"its parts of a body cannot be: " + set.error().message});
}

anim::Status asked(const RecordedPlacement& placement, Show& show) {
  if (placement.character >= show.stage().people().size()) return anim::Error{"places a character that is not there"};
  const auto placed = show.set_placement(placement.character, placement.choice);
  return placed ? anim::Status(anim::Done{})
                : anim::Status(anim::Error{"its size and place cannot be: " + placed.error().message});
}

anim::Status asked(const RecordedRules& recorded, Show& show) {
  if (recorded.character >= show.stage().people().size()) return anim::Error{"dresses a character that is not there"};
  auto rules = rules_of_text(recorded.rules);
  const anim::Status set = rules ? set_cast_rules(show, recorded.character, std::move(*rules)) : rules.error();
  return set ? set : anim::Status(anim::Error{"its rules of who wears what cannot be: " + set.error().message});
}

anim::Status asked(const RecordedShare& share, Show& show) {
  if (share.character >= show.stage().people().size()) {
    return anim::Error{"gives a share to a character that is not there"};
  }
  show.set_share(share.character, share.share);
  return anim::Done{};
}

}  // namespace

anim::Status repeat(const RecordedRequest& request, Show& show) {
  return std::visit([&](const auto& each) { return asked(each, show); }, request);
}

}  // namespace throng::app
