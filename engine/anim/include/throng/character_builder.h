#pragma once

#include "throng/character.h"

namespace throng {

namespace detail {
struct BuilderData;
}

/// A bone of a character to be built.
struct BoneToBuild {
  std::string_view name{};
  int parent = -1;        ///< the index of a bone that was added before; -1: a root
  LocalTransform rest{};  ///< against its parent; a clip without keys for the bone leaves it there
  /// The matrix from the space of the meshes to the bone as it was bound; without one, the rest pose is the bind pose.
  std::optional<Mat4> inverse_bind{};
  /// The part of the body that it is, in the words of VRM 1.0: "hips", "leftUpperLeg"; empty: its name may tell.
  std::string_view role{};
};

/// The form of a track between two keys (glTF 2.0, appendix C).
enum class KeyForm : unsigned char {
  linear,       ///< goes straight to the next value; rotations turn the shorter way
  step,         ///< keeps the value until the next key
  cubic_spline  ///< has three values a key: in-tangent, value, out-tangent
};

/// The keys of one property of a bone, in the space of its parent. Before the first and after the last, the nearest
/// holds.
template <typename Value>
struct BoneKeys {
  std::span<const float> seconds{};  ///< ascending, from 0 to the clip's duration
  std::span<const Value> values{};   ///< one a time, three with KeyForm::cubic_spline
  KeyForm form = KeyForm::linear;
};

/// Builds a character out of a host's own data, for engines with formats of their own. It bakes as load() does: levels
/// of bones, rows, footsteps, rigs. Units are metres unless LoadOptions::scale says otherwise; +Y is up, and the
/// character faces +Z.
///
/// Every call copies what it is given. Calls do not fail: build() names the first fault of all.
class CharacterBuilder {
 public:
  /// `name` is the skeleton's, for messages.
  explicit CharacterBuilder(std::string_view name);
  CharacterBuilder(CharacterBuilder&& other) noexcept;
  CharacterBuilder& operator=(CharacterBuilder&& other) noexcept;
  ~CharacterBuilder();

  /// Adds a bone, and returns its index in the builder. The character orders bones by level of detail: find_bone()
  /// tells their indices there.
  int add_bone(const BoneToBuild& bone);

  /// Adds a clip that lasts so many seconds, and returns its number, which is that of its ClipId too. A character
  /// without clips has "rest", of its rest pose.
  int add_clip(std::string_view name, double seconds);
  void set_translations(int clip, int bone, const BoneKeys<Vec3>& keys);
  void set_rotations(int clip, int bone, const BoneKeys<Quat>& keys);  ///< of any length but 0
  void set_scales(int clip, int bone, const BoneKeys<Vec3>& keys);
  /// Names a moment of a clip, which Motion::for_each_key() tells. A loop without data keys gets its footsteps.
  void add_data_key(int clip, std::string_view name, double seconds);
  /// Adds a number over the time of a clip, which Motion::curve() tells: one value a time, linear in between.
  void add_curve(int clip, std::string_view name, std::span<const float> seconds, std::span<const float> values);

  /// Adds a part of the surface. It is as Character::mesh() shows one, but its vertices stand in the bind pose, in
  /// model space, and `palette_entries` are indices of bones in the builder. Meshes are optional: with them, levels of
  /// detail are measured on the surface instead of the joints, and rag-dolls are as thick as it is. Morph deltas are
  /// left out.
  void add_mesh(const MeshView& mesh);

  /// Builds the character; `characters` has one. The builder stays as it is. Takes a moment, on any thread.
  /// Errors: a sentence that names the first bone, clip or mesh that is at fault; as load().
  Result<LoadedFile> build(const LoadOptions& options = {}) const;

 private:
  std::unique_ptr<detail::BuilderData> data_;
};

}  // namespace throng
