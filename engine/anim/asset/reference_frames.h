#pragma once

#include <vector>

#include "engine/anim/asset/model.h"

namespace throng::anim {

/// Decides between the rigid and the general path and sets references, palette, Skin::palette_entries and
/// Skin::bind_to_model (see Skeleton).
///
/// A skeleton is rigid if no clip changes a scale, every static scale is uniform and positive, and every inverse bind
/// is a rotation, a translation and one uniform scale a skin. All skins then agree on one frame a joint.
/// Real files are rigid up to their exporter's rounding. This rounding is taken off bones and clips if the palettes of
/// the rest pose and of every clip change by at most half of the tolerance for poses.
/// The palette's model space is the scene's, with the first skin's root joint where the rest pose has it.
/// Meshes hang below `attached_bones`; the general palette gets an entry without inverse bind for each.
void set_reference_frames(Skeleton& skeleton, std::vector<Skin>& skins, std::vector<Clip>& clips,
                          const std::vector<int>& attached_bones);

/// Returns the palette entry of `bone` for meshes that hang below it.
int plain_palette_entry(const Skeleton& skeleton, int bone);

}  // namespace throng::anim
