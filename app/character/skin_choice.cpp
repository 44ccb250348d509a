#include "app/character/skin_choice.h"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

std::size_t count_characters(const anim::ImportedFile& file) {
  // Models are sorted by their vertices, so models without any come last.
  const auto has_mesh = [](const anim::Model& model) { return !model.meshes.empty(); };
  return static_cast<std::size_t>(std::ranges::count_if(file.models, has_mesh));
}

const std::string& mesh_name(const anim::Model& model) {
  const auto by_size = [](const anim::SkinnedMesh& mesh) { return mesh.positions.size(); };
  return std::ranges::max_element(model.meshes, {}, by_size)->name;
}

// An empty name, or a name that two models have, tells nothing.
bool tells(const std::vector<std::string>& names, std::size_t i) {
  return !names[i].empty() && std::ranges::count(names, names[i]) == 1;
}

bool has_skin(const anim::Model& model, const std::string& name) {
  return std::ranges::find(model.skins, name, &anim::Skin::name) != model.skins.end();
}

}  // namespace

CharacterFile character_file(const std::string& text) {
  std::error_code ignored;
  const std::size_t mark = text.rfind('#');
  if (mark == std::string::npos || std::filesystem::exists(text, ignored)) return {.path = text, .skin = {}};
  return {.path = text.substr(0, mark), .skin = text.substr(mark + 1)};
}

std::string with_skin(const std::string& file, const std::string& skin) {
  return skin.empty() || !character_file(file).skin.empty() ? file : file + "#" + skin;
}

std::vector<std::string> character_names(const anim::ImportedFile& file) {
  const std::size_t count = count_characters(file);
  std::vector<std::string> skins, meshes, names;
  for (std::size_t i = 0; i < count; ++i) {
    skins.push_back(file.models[i].skeleton.name);
    meshes.push_back(mesh_name(file.models[i]));
  }
  for (std::size_t i = 0; i < count; ++i) {
    names.push_back(tells(skins, i) ? skins[i] : tells(meshes, i) ? meshes[i] : std::to_string(i + 1));
  }
  return names;
}

Result<std::size_t> choose_model(const anim::ImportedFile& file, const std::string& skin) {
  const std::vector<std::string> names = character_names(file);
  if (skin.empty()) return std::size_t{0};
  const auto named = std::ranges::find(names, skin);
  if (named != names.end()) return static_cast<std::size_t>(named - names.begin());
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (has_skin(file.models[i], skin) || mesh_name(file.models[i]) == skin) return i;
  }
  std::size_t number = 0;
  const char* const end = skin.data() + skin.size();
  const auto [stop, error] = std::from_chars(skin.data(), end, number);
  if (error == std::errc{} && stop == end && number >= 1 && number <= names.size()) return number - 1;
  const std::string there = names.empty() ? "no character with a mesh" : joined(names, ", ", " and ");
  return Error{file.file + ": it has no skin \"" + skin + "\"; it has " + there};
}

}  // namespace throng::app
