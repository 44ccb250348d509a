#include "assets/wardrobe/part.h"

namespace throng::wardrobe {

std::vector<Part> long_hair() { return {}; }

}  // namespace throng::wardrobe
