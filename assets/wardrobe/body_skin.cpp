#include "assets/wardrobe/body_skin.h"

#include "assets/wardrobe/make.h"

namespace throng::wardrobe {

const mannequin::Skin& body_skin() { return man_skin(); }

}  // namespace throng::wardrobe
