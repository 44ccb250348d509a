#include "app/people/wardrobe/clothing.h"

#include <gtest/gtest.h>

namespace throng::app::clothing_test {
namespace {

CharacterSource source_with(std::size_t parts) {
  CharacterSource source;
  source.file = "model.glb";
  for (std::size_t i = 0; i < parts; ++i) {
    anim::ModelPart& part = source.model.parts.emplace_back();
    part.name = "part " + std::to_string(i);
    part.slot = "top";
  }
  return source;
}

TEST(Clothing, IsOfAsManyPartsAsCanBeHeldAgainstEachOtherInTime) {
  EXPECT_TRUE(clothing_of(source_with(1000)));
  const auto clothing = clothing_of(source_with(1001));
  ASSERT_FALSE(clothing);
  EXPECT_EQ(clothing.error().message, "model.glb: it has 1001 parts to wear, and 1000 are the most; split the model");
}

}  // namespace
}  // namespace throng::app::clothing_test
