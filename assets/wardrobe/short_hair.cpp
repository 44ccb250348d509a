#include "assets/wardrobe/part.h"

namespace throng::wardrobe {

std::vector<Part> short_hair() { return {}; }

}  // namespace throng::wardrobe
