#pragma once

#include <vector>

#include "engine/anim/asset/model.h"

namespace throng::import {

/// Decides between the rigid and the general path and sets references, palette, Skin::palette_entries and
/// Skin::bind_to_model (see anim::Skeleton).
///
/// Rigid: no clip changes a scale, every static scale is uniform and positive, and every inverse bind is a rotation, a
/// translation and one uniform scale a skin, so that all skins agree on one frame a joint. Real files are so up to the
/// rounding of their exporter; it is taken off bones and clips if the palettes of the rest pose and of every clip stay
/// within half of what poses are held to. The model space of the palette is the scene's, with the first skin's root
/// joint where the rest pose has it.
/// `attached_bones`: meshes hang below these; the general palette gets an entry without inverse bind for each.
void set_reference_frames(anim::Skeleton& skeleton, std::vector<anim::Skin>& skins, std::vector<anim::Clip>& clips,
                          const std::vector<int>& attached_bones);

/// The palette entry of `bone` for what is attached to it.
int plain_palette_entry(const anim::Skeleton& skeleton, int bone);

}  // namespace throng::import
