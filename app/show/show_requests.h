#pragma once

#include <memory>
#include <vector>

#include "app/show/request/request.h"
#include "app/show/show_parts.h"
#include "engine/base/result.h"

/// Requests for which a show needs more than its stage: files, meshes, cameras. Errors: they cannot be; then nothing
/// has changed.
namespace throng::app {

Status carry_out(const Apply& values, ShowParts& show);
Status carry_out(const SetBody& body, ShowParts& show);
Status carry_out(const SetBones& bones, ShowParts& show);
Status carry_out(const SetPlacement& placement, ShowParts& show);
Status carry_out(const LoadModels& models, ShowParts& show);
Status carry_out(const SetCast& cast, ShowParts& show);
Status carry_out(const GoBack& back, ShowParts& show);
/// The others are about the stage alone.
Status carry_out(const SetShare& share, Stage& stage);
Status carry_out(const SetRoles& roles, Stage& stage);
Status carry_out(const SetRules& rules, Stage& stage);
Status carry_out(const Select& select, Stage& stage);
Status carry_out(const Push& push, Stage& stage);
Status carry_out(const Hold& hold, Stage& stage);
Status carry_out(const Seek& seek, Stage& stage);
template <typename OfStage>
Status carry_out(const OfStage& asked, ShowParts& show) {
  return carry_out(asked, *show.stage);
}

/// These do what Show's functions of these names do.
Status open_viewer(const ViewRequest& request, ShowParts& show);
Status replace_characters(std::vector<CharacterSource> characters, ShowParts& show);
Status replace_trajectories(std::shared_ptr<const Trajectories> trajectories, ShowParts& show);

}  // namespace throng::app
