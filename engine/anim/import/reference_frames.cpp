#include "engine/anim/import/reference_frames.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>

#include <glm/gtc/matrix_transform.hpp>

#include "engine/anim/asset/reference_pose.h"

namespace throng::import {

namespace {

using anim::ReferenceFrame;
using anim::Skeleton;
using anim::Skin;

// Inverse binds are stored in 32-bit floats and were computed from matrices in them: what they say is exact to this
// share of the frame's own size and of the skeleton's. A tenth of what poses are held to.
constexpr double tolerance = 5e-6;

/// Rotation, origin and uniform positive scale of a matrix that is nothing else.
std::optional<ReferenceFrame> as_frame(const glm::dmat4& matrix) {
  const glm::dmat3 linear(matrix);
  const double determinant = glm::determinant(linear);
  if (!(determinant > 0.0)) return std::nullopt;
  const double scale = std::cbrt(determinant);
  const glm::dmat3 rotation = linear / scale;
  const glm::dmat3 gram = glm::transpose(rotation) * rotation;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      if (std::abs(gram[column][row] - (column == row ? 1.0 : 0.0)) > 2.0 * tolerance) return std::nullopt;
    }
  }
  return ReferenceFrame{
      .rotation = glm::normalize(glm::quat_cast(rotation)), .origin = glm::dvec3(matrix[3]), .scale = scale};
}

glm::dmat4 as_matrix(const ReferenceFrame& frame) {
  return anim::compose({.rotation = frame.rotation, .position = frame.origin, .scale = glm::dvec3(frame.scale)});
}

bool agree(const glm::dmat4& a, const glm::dmat4& b, double scale, double extent) {
  for (int column = 0; column < 4; ++column) {
    const double limit = tolerance * (column < 3 ? scale : std::max(extent, scale));
    for (int row = 0; row < 3; ++row) {
      if (!(std::abs(a[column][row] - b[column][row]) <= limit)) return false;
    }
  }
  return true;
}

bool scale_is(const anim::Track<glm::vec3>& track, const glm::vec3& expected) {
  const bool cubic = track.interpolation == anim::Interpolation::cubic_spline;
  for (std::size_t i = 0; i < track.values.size(); ++i) {
    const bool tangent = cubic && i % 3 != 1;
    const glm::vec3 offset = track.values[i] - (tangent ? glm::vec3(0.0F) : expected);
    const auto largest = static_cast<double>(std::max({std::abs(offset.x), std::abs(offset.y), std::abs(offset.z)}));
    if (largest > 1e-6 * std::max(1.0, static_cast<double>(expected.x))) return false;
  }
  return true;
}

bool scales_stand_still(const Skeleton& skeleton, const std::vector<anim::Clip>& clips) {
  for (const anim::Clip& clip : clips) {
    for (const anim::BoneTracks& tracks : clip.tracks) {
      if (!scale_is(tracks.scale, skeleton.bones[static_cast<std::size_t>(tracks.bone)].rest.scale)) return false;
    }
  }
  return true;
}

/// Tries the rigid path; what it has set is only of use if it succeeds.
class RigidFrames {
 public:
  explicit RigidFrames(Skeleton& skeleton) : skeleton_(skeleton), placed_(skeleton.bones.size(), false) {}

  bool set(std::vector<Skin>& skins) {
    if (!set_rest_frames()) return false;
    return std::ranges::all_of(skins, [&](Skin& skin) { return add_skin(skin); });
  }

 private:
  /// Frames and scales of the rest pose, which remain for bones that no skin binds.
  bool set_rest_frames() {
    const anim::ReferencePose rest = anim::reference_pose(skeleton_, nullptr, 0.0);
    skeleton_.references.clear();
    for (std::size_t b = 0; b < rest.globals.size(); ++b) {
      const anim::Bone& bone = skeleton_.bones[b];
      const auto frame = as_frame(rest.globals[b]);
      const auto local = as_frame(anim::compose(anim::rest_transform(bone)));
      if (!frame || !local || !as_frame(bone.prefix)) return false;
      skeleton_.references.push_back(*frame);
      extent_ = std::max(extent_, glm::length(frame->origin));
    }
    return true;
  }

  bool add_skin(Skin& skin) {
    const auto bind_to_model = as_frame(vertex_space(skin));
    if (!bind_to_model) return false;
    skin.bind_to_model = as_matrix(*bind_to_model);
    for (std::size_t joint = 0; joint < skin.bones.size(); ++joint) {
      if (!place(skin, joint, bind_to_model->scale)) return false;
    }
    return true;
  }

  /// Where the skin's vertices are in the bind pose: by a joint that an earlier skin has placed, else by its root
  /// joint's rest pose.
  glm::dmat4 vertex_space(const Skin& skin) const {
    const auto first = [&](std::size_t joint) {
      const int bone = skin.bones[joint];
      return std::tuple(!placed_[static_cast<std::size_t>(bone)], bone);
    };
    std::size_t root = 0;
    for (std::size_t joint = 1; joint < skin.bones.size(); ++joint) {
      if (first(joint) < first(root)) root = joint;
    }
    const auto bone = static_cast<std::size_t>(skin.bones[root]);
    return as_matrix(skeleton_.references[bone]) * skin.inverse_binds[root];
  }

  bool place(const Skin& skin, std::size_t joint, double skin_scale) {
    const auto bone = static_cast<std::size_t>(skin.bones[joint]);
    ReferenceFrame& reference = skeleton_.references[bone];
    const glm::dmat4& inverse_bind = skin.inverse_binds[joint];
    if (!placed_[bone]) {
      if (!as_frame(inverse_bind)) return false;
      const auto frame = as_frame(skin.bind_to_model * glm::inverse(inverse_bind));
      if (!frame) return false;
      reference.rotation = frame->rotation;
      reference.origin = frame->origin;
      placed_[bone] = true;
    }
    const double extent = std::max(extent_, glm::length(reference.origin));
    return agree(as_matrix(reference) * inverse_bind, skin.bind_to_model, skin_scale, extent);
  }

  Skeleton& skeleton_;
  std::vector<bool> placed_;
  double extent_ = 0.0;  ///< metres, how far from the origin the rest pose reaches
};

void set_rigid_palette(Skeleton& skeleton, std::vector<Skin>& skins) {
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) skeleton.palette.push_back({.bone = bone});
  for (Skin& skin : skins) skin.palette_entries = skin.bones;
}

/// The entry of `bone` with `post`, added at the end where there is none.
int find_or_add(std::vector<anim::PaletteEntry>& palette, std::vector<std::vector<int>>& entries_of_bone, int bone,
                const glm::dmat4& post) {
  auto& entries = entries_of_bone[static_cast<std::size_t>(bone)];
  for (const int entry : entries) {
    if (palette[static_cast<std::size_t>(entry)].post == post) return entry;
  }
  entries.push_back(static_cast<int>(palette.size()));
  palette.push_back({.bone = bone, .post = post});
  return entries.back();
}

void set_general_palette(Skeleton& skeleton, std::vector<Skin>& skins, const std::vector<int>& attached_bones) {
  std::vector<anim::PaletteEntry> palette;
  std::vector<std::vector<int>> entries_of_bone(skeleton.bones.size());
  for (Skin& skin : skins) {
    for (std::size_t joint = 0; joint < skin.bones.size(); ++joint) {
      skin.palette_entries.push_back(
          find_or_add(palette, entries_of_bone, skin.bones[joint], skin.inverse_binds[joint]));
    }
  }
  for (const int bone : attached_bones) find_or_add(palette, entries_of_bone, bone, glm::dmat4(1.0));
  std::vector<int> place(palette.size());
  for (const auto& entries : entries_of_bone) {
    for (const int entry : entries) {
      place[static_cast<std::size_t>(entry)] = skeleton.palette_count();
      skeleton.palette.push_back(palette[static_cast<std::size_t>(entry)]);
    }
  }
  for (Skin& skin : skins) {
    for (int& entry : skin.palette_entries) entry = place[static_cast<std::size_t>(entry)];
  }
}

}  // namespace

void set_reference_frames(Skeleton& skeleton, std::vector<Skin>& skins, const std::vector<anim::Clip>& clips,
                          const std::vector<int>& attached_bones) {
  skeleton.palette.clear();
  skeleton.rigid = scales_stand_still(skeleton, clips) && RigidFrames(skeleton).set(skins);
  if (skeleton.rigid) {
    set_rigid_palette(skeleton, skins);
    return;
  }
  skeleton.references.assign(skeleton.bones.size(), {});
  for (Skin& skin : skins) skin.bind_to_model = glm::dmat4(1.0);
  set_general_palette(skeleton, skins, attached_bones);
}

int plain_palette_entry(const Skeleton& skeleton, int bone) {
  if (skeleton.rigid) return bone;
  const auto plain = std::ranges::find_if(skeleton.palette, [&](const anim::PaletteEntry& entry) {
    return entry.bone == bone && entry.post == glm::dmat4(1.0);
  });
  return static_cast<int>(plain - skeleton.palette.begin());
}

}  // namespace throng::import
