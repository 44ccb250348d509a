#include "app/show/opened_crowd.h"

#include <utility>

#include "app/character/built_in.h"

namespace throng::app {
namespace {

Result<LoadedCast> load_as_it_is(std::span<const ChosenCharacter> characters, const std::string& data,
                                 LoadOptions options) {
  const auto entries = entries_of(characters);
  if (!entries.empty()) return load_cast(entries, options);
  options.clips_from = characters.front().clip_files;
  options.placement = characters.front().placement;
  auto built_in = load_built_in(data, options);
  if (!built_in) return built_in.error();
  if (const Status seen = check_extent(*built_in, built_in->name); !seen) return seen.error();
  LoadedCast cast;
  cast.characters.push_back(std::move(*built_in));
  return cast;
}

}  // namespace

Result<LoadedCast> load_crowd(std::span<const ChosenCharacter> characters, const std::string& data,
                              const LoadOptions& options) {
  auto cast = load_as_it_is(characters, data, options);
  if (!cast) return cast.error();
  if (cast->characters.size() != characters.size()) {
    return Error{"a \"model\" of the crowd file stands for several characters; name each of them, as FILE#NAME"};
  }
  for (std::size_t i = 0; i < characters.size(); ++i) {
    if (const Status became = become(characters[i], cast->characters[i]); !became) return became.error();
  }
  return cast;
}

}  // namespace throng::app
