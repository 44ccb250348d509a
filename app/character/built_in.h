#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/character/source.h"
#include "engine/anim/pack/pack.h"

namespace throng::app {

/// The pack of the built-in character and all parts that it may wear, which the build makes beside the program. So a
/// start neither imports nor bakes nor simplifies a model.
inline constexpr const char* built_in_pack_name = "built_in.pack";

/// The name of the built-in character.
inline constexpr const char* built_in_name = "mannequin (built in)";

/// Loads the character that comes with the program, from the folders that --data leads.
Result<CharacterSource> load_built_in(const std::string& data_option, const LoadOptions& options = {});

/// The files that the built-in character is made of.
struct BuiltInFiles {
  std::filesystem::path mannequin;
  std::filesystem::path wardrobe;  ///< empty: there is none
};

/// Finds them in the folders that --data leads. A wardrobe that is not needed may be missing.
Result<BuiltInFiles> find_built_in(const std::string& data_option, bool needs_wardrobe);

/// Adds the parts of another file, whose skeleton has the same joints at rest, to the parts of a character's model.
/// Errors: the file cannot be imported, it has no parts, or the character lacks one of their joints.
Status add_parts(anim::Model& model, const std::string& character, const std::filesystem::path& file);

/// Imports and bakes the built-in character, with the order of its bones that `kept` has, if any. It has the parts of
/// the wardrobe if LoadOptions::wardrobe says so.
Result<CharacterSource> make_built_in(const BuiltInFiles& files, const LoadOptions& options,
                                      const BoneLodFile* kept = nullptr);

/// Takes the character out of a pack beside the program or the files. Returns nothing if no pack was made of these very
/// files, or if the options ask for other values than were baked.
std::optional<CharacterSource> take_built_in(const BuiltInFiles& files, const LoadOptions& options);

/// Returns the built-in character, with all parts of its wardrobe, as a pack takes it: without a person's choices for
/// it.
Result<pack::FileToPack> built_in_to_pack(const BuiltInFiles& files);

}  // namespace throng::app
