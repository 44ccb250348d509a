#include "assets/wardrobe/part.h"

namespace throng::wardrobe {

std::vector<Part> faces() { return {}; }

}  // namespace throng::wardrobe
