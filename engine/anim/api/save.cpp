#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "engine/anim/api/character_data.h"
#include "engine/anim/base/misuse.h"
#include "engine/base/text/plain_text.h"

#if defined(THRONG_HAS_PACK)
#include "engine/anim/pack/pack.h"
#include "engine/base/files/output_file.h"
#endif

namespace throng {

#if defined(THRONG_HAS_PACK)
namespace {

/// Returns the name of a character's skeleton, with a number if a character before has that name.
std::string name_among(const std::vector<pack::CharacterToPack>& others, const std::string& wanted) {
  std::string name = wanted;
  const auto is_taken = [&] { return std::ranges::count(others, name, &pack::CharacterToPack::name) > 0; };
  for (int number = 2; is_taken(); ++number) name = wanted + " " + std::to_string(number);
  return name;
}

/// Adds a character with its model, which stands in its place already.
void add_to(pack::FileToPack& file, const detail::CharacterData& data) {
  anim::Model& model = file.file.models.emplace_back(data.body->model);
  model.skeleton = data.baked->skeleton;
  std::string name = name_among(file.characters, model.skeleton.name);
  pack::CharacterToPack& character = file.characters.emplace_back();
  character.name = std::move(name);
  character.prepared.placement.height = data.baked->height;
  character.character = data.baked;
  character.ragdoll = data.body->rigs.ragdoll();
}

}  // namespace

Status save(const std::string& path, std::span<const Character> characters) {
  if (characters.empty()) return anim::refuse({"save", "there is no character: a pack has at least one"});
  pack::FileToPack file{.name = plain_text(std::filesystem::path(path).stem().string()), .file = {}, .characters = {}};
  for (const Character& character : characters) {
    if (!character) return anim::refuse({"save", "a character is empty"});
    add_to(file, *character.data());
  }
  const std::vector<std::byte> pack = pack::write_pack({&file, 1});
  return write_whole_file(path, {reinterpret_cast<const char*>(pack.data()), pack.size()});
}
#else
Status save(const std::string& path, std::span<const Character>) {
  return Error{plain_text(path) + ": this build of the library writes no packs"};
}
#endif

}  // namespace throng
