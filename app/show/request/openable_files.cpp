#include "app/show/request/openable_files.h"

#include "app/character/cast_files.h"
#include "app/show/request/crowd_file.h"
#include "engine/tracks/read.h"

namespace throng::app {

bool are_walls(const std::filesystem::path& file) {
  const std::filesystem::path ending = file.extension();
  return ending == ".wkt" || ending == ".scenario" || ending == ".floor";
}

bool is_crowd(const std::filesystem::path& file) {
  return is_crowd_file(file) || (!is_model_file(file) && looks_like_trajectories(file.string()));
}

bool is_openable(const std::filesystem::path& file) { return is_model_file(file) || are_walls(file) || is_crowd(file); }

}  // namespace throng::app
