#include "assets/wardrobe/part.h"

namespace throng::wardrobe {

std::vector<Part> headgear() { return {}; }

}  // namespace throng::wardrobe
