#include "engine/anim/asset/reference_frames.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/base/elementary.h"

namespace throng::anim {

namespace {

/// An exactly rigid skeleton, with skins bound to it.
struct RigidCandidate {
  Skeleton skeleton;
  std::vector<Skin> skins;
};

// Exporters of 32-bit floats are off by less (4e-5 in the worst of twenty characters), and no scale is so small
// on purpose. shows_the_same then measures the real effect of the rounding.
constexpr double rounding = 1e-4;
constexpr double scale_key_rounding = 2e-5;

/// Returns rotation, origin and uniform positive scale of a matrix that has nothing else.
std::optional<ReferenceFrame> as_frame(const glm::dmat4& matrix) {
  const glm::dmat3 linear(matrix);
  const double determinant = glm::determinant(linear);
  if (!(determinant > 0.0)) return std::nullopt;
  const double scale = cube_root(determinant);
  const glm::dmat3 rotation = linear / scale;
  const glm::dmat3 gram = glm::transpose(rotation) * rotation;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      if (!(std::abs(gram[column][row] - (column == row ? 1.0 : 0.0)) <= rounding)) return std::nullopt;
    }
  }
  return ReferenceFrame{
      .rotation = glm::normalize(glm::quat_cast(rotation)), .origin = glm::dvec3(matrix[3]), .scale = scale};
}

glm::dmat4 as_matrix(const ReferenceFrame& frame) {
  return compose({.rotation = frame.rotation, .position = frame.origin, .scale = glm::dvec3(frame.scale)});
}

bool scale_is(const Track<glm::vec3>& track, const glm::vec3& expected) {
  const bool cubic = track.interpolation == Interpolation::cubic_spline;
  for (std::size_t i = 0; i < track.values.size(); ++i) {
    const bool tangent = cubic && i % 3 != 1;
    const glm::dvec3 offset(track.values[i] - (tangent ? glm::vec3(0.0F) : expected));
    const double largest = std::max({std::abs(offset.x), std::abs(offset.y), std::abs(offset.z)});
    if (!(largest <= scale_key_rounding * static_cast<double>(std::abs(expected.x)))) return false;
  }
  return true;
}

bool scales_stand_still(const Skeleton& skeleton, const std::vector<Clip>& clips) {
  for (const Clip& clip : clips) {
    for (const BoneTracks& tracks : clip.tracks) {
      if (!scale_is(tracks.scale, skeleton.bones[static_cast<std::size_t>(tracks.bone)].rest.scale)) return false;
    }
  }
  return true;
}

/// Makes a copy of a skeleton rigid. A step that returns false found that it is not.
class RigidMaker {
 public:
  explicit RigidMaker(const Skeleton& general) : skeleton_(general), placed_(general.bones.size(), false) {}

  std::optional<RigidCandidate> make(std::vector<Skin> skins) {
    if (!clean_bones() || !set_rest_frames()) return std::nullopt;
    skeleton_.rigid = true;
    skeleton_.palette.clear();
    for (int bone = 0; bone < skeleton_.bone_count(); ++bone) skeleton_.palette.push_back({.bone = bone});
    if (!std::ranges::all_of(skins, [&](Skin& skin) { return bind(skin); })) return std::nullopt;
    return RigidCandidate{.skeleton = std::move(skeleton_), .skins = std::move(skins)};
  }

 private:
  bool clean_bones() {
    for (Bone& bone : skeleton_.bones) {
      const auto local = as_frame(compose(rest_transform(bone)));
      const auto prefix = as_frame(bone.prefix);
      if (!local || !prefix) return false;
      bone.rest.scale = glm::vec3(static_cast<float>(local->scale));
      if (bone.prefix != glm::dmat4(1.0)) bone.prefix = as_matrix(*prefix);
    }
    return true;
  }

  /// Sets frames and scales to the rest pose, which stays for bones that no skin binds.
  bool set_rest_frames() {
    const ReferencePose rest = reference_pose(skeleton_, nullptr, 0.0);
    for (std::size_t bone = 0; bone < rest.globals.size(); ++bone) {
      const auto frame = as_frame(rest.globals[bone]);
      if (!frame) return false;
      skeleton_.references[bone] = *frame;
    }
    return true;
  }

  bool bind(Skin& skin) {
    const auto bind_to_model = as_frame(vertex_space(skin));
    if (!bind_to_model) return false;
    skin.bind_to_model = as_matrix(*bind_to_model);
    skin.palette_entries = skin.bones;
    for (std::size_t joint = 0; joint < skin.bones.size(); ++joint) {
      if (!place(skin, joint)) return false;
    }
    return true;
  }

  /// Returns where the skin's vertices are in the bind pose. A joint that an earlier skin has placed says so, else the
  /// rest pose of the root joint.
  glm::dmat4 vertex_space(const Skin& skin) const {
    const auto rank = [&](std::size_t joint) {
      const int bone = skin.bones[joint];
      return std::tuple(!placed_[static_cast<std::size_t>(bone)], bone);
    };
    std::size_t root = 0;
    for (std::size_t joint = 1; joint < skin.bones.size(); ++joint) {
      if (rank(joint) < rank(root)) root = joint;
    }
    const auto bone = static_cast<std::size_t>(skin.bones[root]);
    return as_matrix(skeleton_.references[bone]) * skin.inverse_binds[root];
  }

  /// Makes the joint's bind pose its frame. Its scale must be the rest pose's.
  bool place(const Skin& skin, std::size_t joint) {
    const auto bone = static_cast<std::size_t>(skin.bones[joint]);
    if (placed_[bone]) return true;
    if (!as_frame(skin.inverse_binds[joint])) return false;
    const auto frame = as_frame(skin.bind_to_model * glm::inverse(skin.inverse_binds[joint]));
    ReferenceFrame& reference = skeleton_.references[bone];
    if (!frame || std::abs(frame->scale - reference.scale) > rounding * reference.scale) return false;
    reference.rotation = frame->rotation;
    reference.origin = frame->origin;
    placed_[bone] = true;
    return true;
  }

  Skeleton skeleton_;
  std::vector<bool> placed_;
};

/// Compares the palette of one skin by the definition with a rigid skeleton's palette.
class PaletteComparison {
 public:
  void add(const glm::dmat4& expected, const glm::dmat4& shown) {
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 3; ++row) {
        largest_ = std::max(largest_, std::abs(expected[column][row]));
        error_ = std::max(error_, std::abs(expected[column][row] - shown[column][row]));
      }
    }
  }
  bool agrees() const { return error_ <= 0.5 * (1e-4 + 1e-5 * largest_); }

 private:
  double largest_ = 0.0;
  double error_ = 0.0;
};

bool poses_agree(const RigidCandidate& rigid, const Skeleton& general, const std::vector<Skin>& skins, const Clip* clip,
                 double seconds) {
  const ReferencePose expected = reference_pose(general, clip, seconds);
  std::vector<StateTransform> locals = expected.locals;
  for (std::size_t bone = 0; bone < locals.size(); ++bone) locals[bone].scale = rigid.skeleton.bones[bone].rest.scale;
  const ReferencePose shown = pose_from_locals(rigid.skeleton, std::move(locals));
  for (std::size_t skin = 0; skin < skins.size(); ++skin) {
    PaletteComparison comparison;
    for (std::size_t joint = 0; joint < skins[skin].bones.size(); ++joint) {
      const auto entry = static_cast<std::size_t>(skins[skin].palette_entries[joint]);
      const auto rigid_entry = static_cast<std::size_t>(rigid.skins[skin].palette_entries[joint]);
      comparison.add(expected.palette[entry], shown.palette[rigid_entry] * rigid.skins[skin].bind_to_model);
    }
    if (!comparison.agrees()) return false;
  }
  return true;
}

/// Takes the rounding off a general skeleton that is otherwise rigid; returns nothing for any other.
std::optional<RigidCandidate> make_rigid_candidate(const Skeleton& general, const std::vector<Skin>& skins,
                                                   const std::vector<Clip>& clips) {
  if (!scales_stand_still(general, clips)) return std::nullopt;
  return RigidMaker(general).make(skins);
}

/// Says whether the candidate's palettes agree with the general ones, in the rest pose and at five times of every clip,
/// to half of the tolerance for poses: 1e-4, and 1e-5 of the palette's largest magnitude.
bool shows_the_same(const RigidCandidate& rigid, const Skeleton& general, const std::vector<Skin>& skins,
                    const std::vector<Clip>& clips) {
  constexpr int times = 5;
  if (!poses_agree(rigid, general, skins, nullptr, 0.0)) return false;
  for (const Clip& clip : clips) {
    for (int i = 0; i < times; ++i) {
      const double seconds = clip.start + clip.length() * i / (times - 1);
      if (!poses_agree(rigid, general, skins, &clip, seconds)) return false;
    }
  }
  return true;
}

/// The palette entries of the general path: one for each bone and inverse bind, sorted by bone.
class GeneralPalette {
 public:
  explicit GeneralPalette(const Skeleton& skeleton) : entries_of_bone_(skeleton.bones.size()) {}

  int find_or_add(int bone, const glm::dmat4& post) {
    auto& entries = entries_of_bone_[static_cast<std::size_t>(bone)];
    for (const int entry : entries) {
      if (palette_[static_cast<std::size_t>(entry)].post == post) return entry;
    }
    entries.push_back(static_cast<int>(palette_.size()));
    palette_.push_back({.bone = bone, .post = post});
    return entries.back();
  }

  /// Moves the entries to the skeleton and adapts the entry numbers of the skins.
  void store(Skeleton& skeleton, std::vector<Skin>& skins) const {
    std::vector<int> place(palette_.size());
    skeleton.palette.clear();
    for (const auto& entries : entries_of_bone_) {
      for (const int entry : entries) {
        place[static_cast<std::size_t>(entry)] = skeleton.palette_count();
        skeleton.palette.push_back(palette_[static_cast<std::size_t>(entry)]);
      }
    }
    for (Skin& skin : skins) {
      for (int& entry : skin.palette_entries) entry = place[static_cast<std::size_t>(entry)];
    }
  }

 private:
  std::vector<PaletteEntry> palette_;
  std::vector<std::vector<int>> entries_of_bone_;
};

void set_general(Skeleton& skeleton, std::vector<Skin>& skins, const std::vector<int>& attached_bones) {
  skeleton.rigid = false;
  skeleton.references.assign(skeleton.bones.size(), {});
  GeneralPalette palette(skeleton);
  for (Skin& skin : skins) {
    skin.bind_to_model = glm::dmat4(1.0);
    skin.palette_entries.clear();
    for (std::size_t joint = 0; joint < skin.bones.size(); ++joint) {
      skin.palette_entries.push_back(palette.find_or_add(skin.bones[joint], skin.inverse_binds[joint]));
    }
  }
  for (const int bone : attached_bones) palette.find_or_add(bone, glm::dmat4(1.0));
  palette.store(skeleton, skins);
}

}  // namespace

void set_reference_frames(Skeleton& skeleton, std::vector<Skin>& skins, std::vector<Clip>& clips,
                          const std::vector<int>& attached_bones) {
  set_general(skeleton, skins, attached_bones);
  auto rigid = make_rigid_candidate(skeleton, skins, clips);
  if (!rigid || !shows_the_same(*rigid, skeleton, skins, clips)) return;
  skeleton = std::move(rigid->skeleton);
  skins = std::move(rigid->skins);
  for (Clip& clip : clips) drop_scales(clip);
}

int plain_palette_entry(const Skeleton& skeleton, int bone) {
  if (skeleton.rigid) return bone;
  const auto plain = std::ranges::find_if(
      skeleton.palette, [&](const PaletteEntry& entry) { return entry.bone == bone && entry.post == glm::dmat4(1.0); });
  return static_cast<int>(plain - skeleton.palette.begin());
}

}  // namespace throng::anim
