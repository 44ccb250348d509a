#include "app/show/request_history.h"

#include <utility>

#include "app/show/stage/stage.h"

namespace throng::app {
namespace {

/// Returns the choice that takes `choice` back, which is made of an order whose levels end at `level_counts`.
BoneLodChoice taken_back(const BoneLodChoice& choice, const std::vector<int>& level_counts) {
  BoneLodChoice back{.bones = std::vector<int>(choice.bones.size()), .level_counts = level_counts};
  for (std::size_t place = 0; place < choice.bones.size(); ++place) {
    back.bones.at(static_cast<std::size_t>(choice.bones[place])) = static_cast<int>(place);
  }
  return back;
}

class Answer {
 public:
  Answer(const Stage& stage, const Tuning& tuning) : stage_(stage), tuning_(tuning) {}

  std::optional<CrowdRequest> to(const Apply&) const { return Apply{tuning_}; }
  std::optional<CrowdRequest> to(const SetShare& asked) const {
    return SetShare{asked.character, person(asked.character).roles.share};
  }
  std::optional<CrowdRequest> to(const SetRoles& asked) const {
    return SetRoles{asked.character, person(asked.character).roles.clips};
  }
  std::optional<CrowdRequest> to(const SetBody& asked) const {
    return SetBody{asked.character, person(asked.character).rig};
  }
  std::optional<CrowdRequest> to(const SetBones& asked) const {
    const anim::Skeleton& skeleton = person(asked.character).character->skeleton;
    if (!check_bone_lod(skeleton, asked.choice)) return {};
    return SetBones{asked.character, taken_back(asked.choice, skeleton.level_bone_counts)};
  }
  std::optional<CrowdRequest> to(const SetPlacement& asked) const {
    return SetPlacement{asked.character, person(asked.character).placement.choice};
  }
  std::optional<CrowdRequest> to(const SetRules& asked) const {
    const CharacterSource& dressed = person(asked.character);
    return SetRules{asked.character, dressed.rules.value_or(""), asked.file.empty() ? "" : dressed.cast_rules};
  }
  std::optional<CrowdRequest> to(const LoadModels&) const { return SetCast{exactly(stage_.people())}; }
  std::optional<CrowdRequest> to(const SetCast&) const { return SetCast{exactly(stage_.people())}; }
  template <typename Passing>
  std::optional<CrowdRequest> to(const Passing&) const {
    return {};
  }

  bool has(CharacterNumber character) const { return character < stage_.people().size(); }

 private:
  const CharacterSource& person(CharacterNumber character) const { return stage_.people()[character]; }

  const Stage& stage_;
  const Tuning& tuning_;
};

template <typename Asked>
bool is_about_character(const Asked& asked, const Answer& answer) {
  if constexpr (requires { asked.character; }) return answer.has(asked.character);
  return true;
}

/// Returns whether a request alone has the effect that it has after an earlier one.
bool stands_for(const CrowdRequest& request, const CrowdRequest& earlier) {
  const auto compare = [&](const auto& asked) {
    using Asked = std::decay_t<decltype(asked)>;
    const auto* const before = std::get_if<Asked>(&earlier);
    if (before == nullptr || std::is_same_v<Asked, SetBones>) return false;  // an order is one of the order before
    if constexpr (requires { asked.character; }) return asked.character == before->character;
    return std::is_same_v<Asked, Apply>;
  };
  return std::visit(compare, request);
}

}  // namespace

std::optional<CrowdRequest> answer_to(const CrowdRequest& request, const Stage& stage, const Tuning& tuning) {
  const Answer answer(stage, tuning);
  const auto find = [&](const auto& asked) {
    return is_about_character(asked, answer) ? answer.to(asked) : std::nullopt;
  };
  return std::visit(find, request);
}

bool brings_characters(const CrowdRequest& request) {
  return std::holds_alternative<LoadModels>(request) || std::holds_alternative<SetCast>(request);
}

CrowdRequest as_made(const CrowdRequest& request, const Stage& stage) {
  return brings_characters(request) ? SetCast{exactly(stage.people())} : request;
}

void RequestHistory::add(Step step) {
  steps_.resize(made_);
  if (steps_.size() == most_steps) steps_.erase(steps_.begin());
  steps_.push_back(std::move(step));
  made_ = steps_.size();
}

void RequestHistory::add(CrowdRequest made, CrowdRequest answer, std::uint64_t change) {
  steps_.resize(made_);
  if (steps_.empty() || steps_.back().change != change) add(Step{.change = change});
  Step& step = steps_.back();
  if (!step.forth.empty() && stands_for(made, step.forth.back())) {
    step.forth.back() = std::move(made);
    return;
  }
  step.forth.push_back(std::move(made));
  step.back.insert(step.back.begin(), std::move(answer));
}

}  // namespace throng::app
