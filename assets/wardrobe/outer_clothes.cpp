#include "assets/wardrobe/part.h"

namespace throng::wardrobe {

std::vector<Part> outer_clothes() { return {}; }

}  // namespace throng::wardrobe
