#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "assets/mannequin/mesh.h"
#include "assets/wardrobe/finish.h"

namespace throng::wardrobe {

/// A body and the names of what it wears.
struct Outfit {
  Body body = Body::man;
  std::vector<std::string> parts;
};

/// Reads "woman,t_shirt,jeans". Nothing, and a sentence on stderr, where a name is none.
std::optional<Outfit> read_outfit(std::string_view text);

/// Joins the parts of an outfit, and the skin that they leave bare, into one mesh of the given level.
/// Regions that the mannequin does not know get a colour of their own, if `plain`.
mannequin::Mesh dressed(const Outfit& outfit, const std::vector<Finished>& parts, std::size_t level, bool plain);

}  // namespace throng::wardrobe
