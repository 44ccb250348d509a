// throng-bake: makes one pack of glTF files, with the library alone, for the build of a game.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "throng/throng.h"

using namespace throng;

namespace {

constexpr const char* usage =
    "usage: throng-bake [OPTION...] FILE... -o OUT.pack\n"
    "  Makes one pack of glTF files or packs, which throng::load() opens in a moment.\n"
    "  --scale X          metres a unit of the files; guessed without it\n"
    "  --keep-meshes      packs surfaces too, for Character::mesh()\n"
    "  --keep-keys        packs the files' own keys too, which take several times the bytes\n"
    "  --walk-in-place    lets clips that walk in place move their agents\n"
    "  --close-loops      closes clips whose last key stands one step before their first\n"
    "  --strict           refuses files that need repairs\n";

struct Request {
  std::vector<std::string> files;
  std::string pack;
  LoadOptions options;
};

/// Reads the command line; false where it is not as `usage` says.
bool read(int count, char** arguments, Request& request) {
  for (int i = 1; i < count; ++i) {
    const std::string_view word = arguments[i];
    const bool has_value = i + 1 < count;
    if (word == "-o" && has_value) {
      request.pack = arguments[++i];
    } else if (word == "--scale" && has_value) {
      char* end = nullptr;
      request.options.scale = std::strtod(arguments[++i], &end);
      if (*end != '\0') return false;
    } else if (word == "--keep-meshes") {
      request.options.keep_meshes = true;
    } else if (word == "--keep-keys") {
      request.options.keep_keys = true;
    } else if (word == "--walk-in-place") {
      request.options.walk_in_place = true;
    } else if (word == "--close-loops") {
      request.options.close_loops = true;
    } else if (word == "--strict") {
      request.options.strict = true;
    } else if (word.starts_with("-")) {
      return false;
    } else {
      request.files.emplace_back(word);
    }
  }
  return !request.files.empty() && !request.pack.empty();
}

int fail(const Error& error) { return std::fprintf(stderr, "%s\n", error.message.c_str()), 1; }

}  // namespace

int main(int count, char** arguments) {
  Request request;
  if (!read(count, arguments, request)) return std::fputs(usage, stderr), 2;
  std::vector<Character> characters;
  for (const std::string& file : request.files) {
    const auto loaded = load(file, request.options);
    if (!loaded) return fail(loaded.error());
    for (const std::string& note : loaded->notes) std::printf("%s: %s\n", file.c_str(), note.c_str());
    characters.insert(characters.end(), loaded->characters.begin(), loaded->characters.end());
  }
  if (const Status saved = save(request.pack, characters); !saved) return fail(saved.error());
  std::size_t clips = 0;
  for (const Character& character : characters) clips += character.clip_count();
  std::printf("%s: characters: %zu, clips: %zu\n", request.pack.c_str(), characters.size(), clips);
}
