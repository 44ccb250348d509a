#include "app/character/drawn_import.h"

namespace throng::app {

Result<anim::ImportedFile> import_to_draw(const std::string& path, import::ImportOptions options) {
  options.channels = {{"_SHAPE", 3}, {"_HAIR", 2}, {"_FACE", 4}, {"_TRIM", 1}};
  return import::import_file(path, options);
}

}  // namespace throng::app
