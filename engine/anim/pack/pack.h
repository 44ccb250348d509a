#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "throng/character.h"

#include "engine/anim/asset/model.h"
#include "engine/anim/asset/skeleton_order.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/pack/sections.h"
#include "engine/anim/rig/ragdoll_rig.h"
#include "engine/anim/survey/placement_guess.h"
#include "engine/base/files/input_file.h"
#include "engine/base/result.h"

namespace throng::pack {

/// Holds the changes of a model before it was baked, in this order: it was turned forward (anim::face_forward),
/// placed and, where a person chose another order of its bones, reordered.
struct Preparation {
  anim::GuessedPlacement placement;
  std::optional<anim::BoneOrder> order;
};

/// Holds a character that was baked from a model.
struct BakedModel {
  Preparation prepared;
  std::optional<anim::RagdollRig> ragdoll;  ///< empty: it is built of the model
  anim::Character character;
};

/// Holds a character that a pack is to have.
struct CharacterToPack {
  std::string name;
  Preparation prepared;
  std::shared_ptr<const anim::Character> character;
  std::vector<std::byte> surface;                ///< for the device, in the renderer's form; or empty
  std::optional<anim::RagdollRig> ragdoll = {};  ///< of a model that is packed without the surface it was built of
};

/// Holds a file that a pack is to have, and the characters that were baked from the first of its models.
struct FileToPack {
  std::string name;                         ///< by which the pack names it
  anim::ImportedFile file;                  ///< at least one model
  std::vector<CharacterToPack> characters;  ///< 1 to file.models.size()
  std::uint64_t made_of = 0;                ///< what fingerprint_of() says of its sources; 0: not asked for
  bool with_keys = false;                   ///< packs all keys of its clips too, which Pack::imported needs
};

/// Returns the image of a pack. The same input gives the same bytes.
std::vector<std::byte> write_pack(std::span<const FileToPack> files);

/// Returns a number that is another one, as good as surely, when a byte of one of the files is another.
Result<std::uint64_t> fingerprint_of(std::span<const std::string> files);

/// Says whether a file is a pack, by its first bytes, or by its name that ends in ".pack". An unreadable file is none.
bool is_pack(const std::string& path);
bool is_pack(const FileInMemory& file);

/// Says where the bytes of a pack lie while it is used.
enum class PackBytes : unsigned char {
  mapped,  ///< in the file; another program replaces it by renaming a file to its name, and ends this one if it cuts it
  copied   ///< in memory of their own; the file may change
};

/// Everything that baking makes of the models of one or several files, in one file. Its bytes stay where they are as
/// long as anything that was taken from it lives: streams, texels and surfaces are used where they lie.
class Pack {
 public:
  /// Opens a pack and checks every byte of it. The error is one sentence with the file and what to do: it is cut short
  /// or damaged, or another version or another machine made it. A pack is trusted as a program is: a pack that was made
  /// to deceive, with a checksum that fits, is not found out.
  static Result<Pack> open(const std::string& path, PackBytes bytes = PackBytes::mapped);
  /// Opens a copy of a pack in memory.
  static Result<Pack> open(const FileInMemory& file);

  std::size_t file_count() const { return files_.size(); }
  const std::string& file_name(std::size_t file) const { return files_[file].name; }
  /// Returns FileToPack::made_of.
  std::uint64_t made_of(std::size_t file) const { return files_[file].made_of; }
  /// Returns the names of the models of a file that were baked. They are the first of its models; at least one.
  std::span<const std::string> names(std::size_t file) const { return files_[file].names; }

  /// Returns a baked character, ready to play. Its streams lie in the pack.
  Result<anim::Character> character(std::size_t file = 0, std::size_t model = 0) const;
  /// Returns a baked character, with the changes of its model.
  Result<BakedModel> baked(std::size_t file, std::size_t model) const;
  /// Returns the model that a character was baked from: with its size, its place and its order of bones. Of its
  /// keys it has what anim::keep_surveyed_keys keeps. Its texels lie in the pack.
  Result<anim::Model> model(std::size_t file, std::size_t model, const BakedModel& baked) const;
  /// Returns the surface that was packed with a character, which `lender()` keeps; empty if there is none.
  std::span<const std::byte> surface(std::size_t file, std::size_t model) const;
  const std::shared_ptr<const void>& lender() const { return lender_; }

  /// Returns a file as import made it, with all models and all keys. The error says that it was packed without them.
  Result<anim::ImportedFile> imported(std::size_t file) const;
  /// Returns the same without its models.
  const anim::ImportedFile& header(std::size_t file) const { return files_[file].header; }

 private:
  struct PackedFile {
    std::string name;
    std::uint32_t models = 0;
    std::vector<std::string> names;  // of the baked ones
    std::uint64_t made_of = 0;
    anim::ImportedFile header;
  };

  explicit Pack(std::string path) : path_(std::move(path)) {}
  static Result<Pack> of_bytes(const std::string& path, Result<MappedFile> bytes);
  std::span<const std::byte> section(SectionKind kind, std::size_t file, std::size_t model) const;
  template <typename... Values>
  Status read(SectionKind kind, std::size_t file, std::size_t model, Values&... values) const;
  Status read_files();
  Error damaged() const;

  std::string path_;
  std::span<const std::byte> bytes_;
  std::span<const Section> sections_;
  std::shared_ptr<const void> lender_;
  std::vector<PackedFile> files_;
};

}  // namespace throng::pack
