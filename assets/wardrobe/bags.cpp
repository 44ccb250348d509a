#include "assets/wardrobe/part.h"

namespace throng::wardrobe {

std::vector<Part> bags() { return {}; }

}  // namespace throng::wardrobe
