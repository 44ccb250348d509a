#pragma once

#include "throng/ids.h"
#include "throng/math.h"
#include "throng/result.h"
#include "throng/standard.h"
#include "throng/ticks.h"

namespace throng {

namespace detail {
struct CharacterData;
}

/// Describes a clip.
struct ClipInfo {
  std::string_view name{};
  Ticks duration{};
  bool loops = false;  ///< its first and last poses agree
  /// Metres a second at which feet do not slide; 0: the clip is no gait. A clip that walks in place has a speed too,
  /// but moves no agent: see LoadOptions::walk_in_place.
  double ground_speed = 0.0;
};

/// An image that a part of a surface shows, or reads numbers from. Its spans are empty where there is none.
struct TextureView {
  std::span<const std::uint8_t> texels{};  ///< RGBA, top row first
  int width = 0;
  int height = 0;
  std::span<const std::array<float, 2>> coords{};  ///< one a vertex
};

/// Says how a part of a surface is seen through.
enum class AlphaMode : unsigned char {
  opaque,  ///< alpha is not read
  mask,    ///< what has less alpha than MeshView::alpha_cutoff is not drawn
  blend    ///< it is seen through as far as its alpha is below 1
};

/// The change that a morph of weight 1 makes to a vertex. It is added before the palette poses the vertex.
struct MorphDelta {
  std::uint32_t vertex = 0;
  std::uint32_t morph = 0;  ///< index of Character::morph_names
  Vec3 position{};          ///< metres, in the space of the palette
  Vec3 normal{};
};

/// A part of a character's surface, for a renderer of one's own. Spans have one element a vertex, and live as long as
/// the character. A vertex at `position` is drawn at the sum of weight * (palette[entry] * position).
///
/// A host that brings its own mesh of the file needs none of this: Crowd::write_joints with JointOutput::skin writes
/// the matrices of a skin, in the order of its joints.
struct MeshView {
  std::string_view name{};
  std::span<const Vec3> positions{};  ///< in the space of the palette
  std::span<const Vec3> normals{};
  std::span<const std::array<float, 2>> texture_coords{};           ///< of the base colour; or empty
  std::span<const std::array<std::uint16_t, 4>> palette_entries{};  ///< strongest first
  std::span<const std::array<float, 4>> weights{};                  ///< sum to 1
  std::span<const std::uint32_t> indices{};                         ///< triangles, counter-clockwise front
  std::array<float, 4> base_color{1.0F, 1.0F, 1.0F, 1.0F};          ///< linear
  std::span<const std::uint8_t> base_color_texels{};                ///< RGBA, sRGB, top row first; or empty
  int texture_width = 0;
  int texture_height = 0;
  std::span<const std::array<float, 4>> tangents{};  ///< unit, and the side of the bitangent, -1 or 1; empty: no normal
                                                     ///< texture
  std::span<const std::array<float, 4>> colors{};    ///< linear RGBA, times the base colour; or empty
  std::span<const MorphDelta> morph_deltas{};        ///< of vertices that morphs move: by vertex, then by morph
  AlphaMode alpha = AlphaMode::opaque;
  float alpha_cutoff = 0.0F;
  bool double_sided = false;
  bool unlit = false;  ///< it shows its base colour, whatever the light
  // Factors multiply what textures show (glTF 2.0, 3.9).
  float metallic = 1.0F;
  float roughness = 1.0F;
  TextureView metallic_roughness_texture{};  ///< linear: roughness in green, metallic in blue
  float normal_scale = 1.0F;
  TextureView normal_texture{};  ///< linear, in the space of `tangents`
  float occlusion_strength = 1.0F;
  TextureView occlusion_texture{};  ///< linear, in red
  std::array<float, 3> emission{};  ///< linear, 1: as bright as white of the screen
  TextureView emission_texture{};   ///< sRGB
};

/// A skeleton with its clips, ready to play, and all that is measured on them. It is read-only: copies are as cheap
/// as pointers, and crowds on different threads can share one. An empty one has no bones and no clips, and no crowd
/// takes it.
class Character {
 public:
  Character() = default;
  explicit Character(std::shared_ptr<const detail::CharacterData> data) : data_(std::move(data)) {}
  explicit operator bool() const { return data_ != nullptr; }

  /// Returns the number of places for clips, with places that without() left empty.
  std::uint32_t clip_count() const;
  /// Returns whether the clip is there, and has not left.
  bool has(ClipId clip) const;
  /// Describes a clip; the description of an absent clip or an empty place is empty.
  ClipInfo clip(ClipId clip) const;
  /// Returns the clip of this name; an invalid id if there is none.
  ClipId find_clip(std::string_view name) const;
  /// Returns the clip that plays a role, as far as the names of the clips tell: find_role("walk") is Walk, Walking_A or
  /// Armature|walk_cycle. An invalid id if no name tells. The plainest name wins, and a run stands in for a walk.
  /// Roles: stand, look_around, walk, jog, run, wave, cheer, clap, sit, talk, phone, call, drink, take_picture, lean,
  /// sit_on_step; the gaits walk_back, step_left, step_right, shuffle, step_in_place, veer_left, veer_right; for an arm
  /// carry, hold_up, hold_phone, lead, led, push, stick. Another role is a misuse.
  ClipId find_role(std::string_view role) const;

  /// Returns this character with the clips of `more`, for example of another file, which are not copied. Empty
  /// places are filled first. Names of data keys and curves keep their indices, and new ones follow. This
  /// character gives the surface and all that depends on it; added clips move its morphs if `more` has equal morphs.
  /// Takes a moment, on any thread, while crowds play both: see Crowd::replace. Errors: the skeleton is another one, by
  /// bones, parents or bind pose; a clip has the name of a clip that is there.
  Result<Character> with_clips(const Character& more) const;
  /// Returns this character without a clip. Its place is empty until another clip comes, and ids of the clip name
  /// nothing from then on. Other clips keep their ids. The memory of clips that came together is let go with the last
  /// of them, when no crowd, character or snapshot has it. Errors: it has no such clip, or no other.
  Result<Character> without(ClipId clip) const;

  int bone_count() const;
  std::string_view bone_name(int bone) const;
  /// Returns the index of the bone's parent, which is lower than its own; -1 for a root.
  int bone_parent(int bone) const;
  std::optional<int> find_bone(std::string_view name) const;
  /// Returns how many levels of detail its bones have, 1 to 4. Level 0 has all bones.
  int level_count() const;

  /// Returns the entries of a palette at a bone level.
  std::uint32_t palette_entries(int level = 0) const;
  /// Returns the frames with which packed_palette.glsl unpacks the entries of a packed palette: where the joint rests,
  /// in the space of the palette, and the metres of one unit of a place. One for each entry of level 0; none if its
  /// palettes cannot be packed, and are matrices. They are a table of vec4 for the device, shared by all agents.
  std::vector<std::array<float, 4>> packing_frames() const;
  /// Returns, for each entry of a palette, the entry that a vertex reads in a palette of a bone level: itself where the
  /// bone is kept, else the entry of its nearest kept ancestor. A host that draws bone levels looks entries up in it.
  std::vector<std::uint16_t> entries_at_level(int level) const;
  /// Returns the height of the standing character, in metres.
  double height() const;
  /// Returns a sphere that holds the surface in every pose of its clips, in model space: move it by the agent's place.
  /// An agent is in view for level of detail while this sphere is. It is measured on samples of the surface and of
  /// time, and a tenth larger. Processes may lead the surface beyond it, for example a rag-doll that falls: see
  /// Crowd::bounds.
  BoundingSphere bounds() const;
  /// Returns a box that holds the surface in the poses of one clip, without its root motion, in model space. It poses
  /// the clip 60 times a second, at most 10,000 times, and so takes milliseconds. An absent clip has none.
  BoundingBox bounds(ClipId clip) const;
  /// Returns the names of the data keys of all its clips. DataKey::name is an index. A glTF file has them among the
  /// extras of an animation, in seconds: {"throng_data_keys": [{"time": 0.31, "name": "draw_sword"}]}. A loop without
  /// data keys gets "footstep_left" and "footstep_right", where its feet come down.
  std::span<const std::string> data_key_names() const;
  /// Returns the names of the curves of all its clips. Motion::curve takes an index.
  std::span<const std::string> curve_names() const;

  std::size_t mesh_count() const;
  MeshView mesh(std::size_t index) const;
  /// Returns the names of the morphs that its clips animate. MorphDelta::morph is an index.
  std::span<const std::string> morph_names() const;

  /// Returns why it cannot look, stand on uneven ground, reach or fall, one sentence each.
  std::span<const std::string> missing_rigs() const;

  const detail::CharacterData* data() const { return data_.get(); }
  const std::shared_ptr<const detail::CharacterData>& shared() const { return data_; }

 private:
  std::shared_ptr<const detail::CharacterData> data_;
};

/// The bone that plays a part of the body.
struct BoneRole {
  std::string_view role{};  ///< in the words of VRM 1.0: "hips", "leftUpperLeg", "leftFoot", "rightToes"
  std::string_view bone{};  ///< its name in the file
};

struct LoadOptions {
  double scale = 0.0;        ///< metres a unit of the file; 0: as the file's figure tells
  bool strict = false;       ///< refuses files that need repairs
  bool keep_meshes = false;  ///< keeps the surface, for Character::mesh
  /// Lets clips that walk in place move their agents, at ClipInfo::ground_speed in the direction of their steps.
  /// Without it Motion::displacement is 0 for them, and LoadedFile::notes names them.
  bool walk_in_place = false;
  /// Keeps the file's own keys of all clips, which take several times the memory of the rows that agents play. Without
  /// them, with_clips() rounds a clip once more if its bones come in another order. Clips that no rows can show as
  /// exactly as they should keep their keys in any case.
  bool keep_keys = false;
  /// Closes clips whose last key stands one step before their first would come again: they get that key, one step
  /// later. Without it they do not loop and get no footsteps, and LoadedFile::notes names them. A clip that travels
  /// stays as it is, and so do those of a pack, which has no keys.
  bool close_loops = false;
  /// Names bones that play parts of the body, where their names do not tell: Character::missing_rigs() says what is
  /// missing. Other bones keep what the file or their names say.
  std::span<const BoneRole> rig{};
  /// Bytes that reading a glTF file may hold at a time; 0: 64 MB and four times its files, and besides 1 GB of pixels,
  /// to which larger images are scaled down.
  std::uint64_t memory_limit = 0;
  /// Reads a pack into memory of its own instead of mapping it. A mapped file may only be replaced by renaming another
  /// file to its name, as `throng bake` does: if a program cuts or overwrites it, this program ends.
  bool copy_pack = false;
};

/// The characters of a file. `notes` says in sentences what was repaired, how the model was placed, and which clips
/// walk in place or just miss to be loops.
struct LoadedFile {
  std::vector<Character> characters;  ///< at least one, the largest first
  std::vector<std::string> notes;
};

/// Loads a .glb, a .gltf or a pack (`throng bake`). A pack is mapped, and stays so as long as one of its characters
/// lives, unless LoadOptions::copy_pack is set. Reads files only below the model's own folder. May be called from any
/// thread, while others play.
/// Errors: one sentence with the file, the object and what to do; also if the library was built without glTF or packs.
Result<LoadedFile> load(const std::string& path, const LoadOptions& options = {});

/// A file that a host holds in memory: of an archive, a network, or the assets of a mobile app.
struct FileInMemory {
  std::string_view name{};  ///< as the model names it in its uris; of the model itself, for messages
  std::span<const std::byte> bytes{};
};

/// Does load() for files in memory, and reads no other: the first is the model or pack, the others are what it names,
/// such as buffers and images. All bytes are copied, and may go when it returns.
Result<LoadedFile> load(std::span<const FileInMemory> files, const LoadOptions& options = {});

/// Saves characters as one pack, which load() opens in a moment: skeletons, clips as they play, what is measured on
/// them, and rigs. Surfaces go with it where LoadOptions::keep_meshes kept them, and keys where keep_keys did. The file
/// is whole or as it was, and a name that ends in ".pack" is usual. Takes a moment, on any thread.
/// Errors: there is no character, one is empty, the file cannot be written, or the library was built without packs.
Status save(const std::string& path, std::span<const Character> characters);

}  // namespace throng
