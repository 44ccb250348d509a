#pragma once

#include <memory>
#include <vector>

#include "app/show/request/request.h"
#include "app/show/show_parts.h"
#include "engine/base/result.h"

/// Requests for which a show needs more than its stage: files, meshes, cameras. Errors: they cannot be; then nothing
/// has changed.
namespace throng::app {

anim::Status carry_out(const Apply& values, ShowParts& show);
anim::Status carry_out(const SetBody& body, ShowParts& show);
anim::Status carry_out(const SetBones& bones, ShowParts& show);
anim::Status carry_out(const SetPlacement& placement, ShowParts& show);
anim::Status carry_out(const LoadModels& models, ShowParts& show);
anim::Status carry_out(const SetCast& cast, ShowParts& show);
anim::Status carry_out(const GoBack& back, ShowParts& show);
/// The others are about the stage alone.
anim::Status carry_out(const SetShare& share, Stage& stage);
anim::Status carry_out(const SetRoles& roles, Stage& stage);
anim::Status carry_out(const SetRules& rules, Stage& stage);
anim::Status carry_out(const Select& select, Stage& stage);
anim::Status carry_out(const Push& push, Stage& stage);
anim::Status carry_out(const Hold& hold, Stage& stage);
anim::Status carry_out(const Seek& seek, Stage& stage);
template <typename OfStage>
anim::Status carry_out(const OfStage& asked, ShowParts& show) {
  return carry_out(asked, *show.stage);
}

/// These do what Show's functions of these names do.
anim::Status open_viewer(const ViewRequest& request, ShowParts& show);
anim::Status replace_characters(std::vector<CharacterSource> characters, ShowParts& show);
anim::Status replace_trajectories(std::shared_ptr<const Trajectories> trajectories, ShowParts& show);

}  // namespace throng::app
