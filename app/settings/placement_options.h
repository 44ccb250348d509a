#pragma once

#include "app/settings/option_values.h"

namespace throng::app {

/// These read VALUE, for all models, or NAME=VALUE, for the model of that name, with commas between several. A name is
/// a file's, with or without its ending, or a character's. A value for one model wins over the value for all.
ValueReader model_scales(anim::PlacementChoice& all, std::vector<ModelPlacement>& some);
ValueReader model_up_axes(anim::PlacementChoice& all, std::vector<ModelPlacement>& some);
ValueReader model_grounds(anim::PlacementChoice& all, std::vector<ModelPlacement>& some);

/// These two read a value for all models.
ValueReader up_axis(anim::UpAxis& target);
ValueReader ground_rule(anim::GroundRule& target);

}  // namespace throng::app
