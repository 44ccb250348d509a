#include "assets/wardrobe/part.h"

namespace throng::wardrobe {

std::vector<Part> hand_things() { return {}; }

}  // namespace throng::wardrobe
