#pragma once

#include <filesystem>
#include <vector>

#include "throng/render/image.h"

namespace throng::sheet {

/// Pictures of one width, one below the other.
class ContactSheet {
 public:
  void add(const render::Image& row) { rows_.push_back(row); }

  /// Rounded to five bits a channel, so that the file stays small. False, and a sentence on stderr, where it fails.
  bool write(const std::filesystem::path& file) const;

 private:
  std::vector<render::Image> rows_;
};

/// Pictures side by side.
render::Image beside(const std::vector<render::Image>& pictures);

/// What is the same with and without what is shown becomes one colour, so that paving does not fill the file.
void flatten_background(render::Image& picture, const render::Image& empty);

}  // namespace throng::sheet
