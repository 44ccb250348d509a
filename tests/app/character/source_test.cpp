#include "app/character/source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/asset/synthetic_model.h"

namespace throng::app::source_test {
namespace {

using testing::ElementsAre;

TEST(CharacterSource, RepeatsNoClipThatHoldsStillBesideOnesThatMove) {
  anim::ImportedFile file;
  file.models = {anim::synthetic_model(5, 3)};
  file.models[0].clips[1].tracks.clear();  // the bind pose, as Mixamo keeps it in a character's file
  const auto source = make_character(file, 0, {.path = "made.glb", .name = "made"});
  ASSERT_TRUE(source) << source.error().message;
  EXPECT_THAT(source->roles.others, ElementsAre(0, 2));
}

TEST(CharacterSource, RepeatsAStillClipWhereThereIsNoOther) {
  anim::ImportedFile file;
  file.models = {anim::synthetic_model(5, 1)};
  file.models[0].clips[0].tracks.clear();
  const auto source = make_character(file, 0, {.path = "made.glb", .name = "made"});
  ASSERT_TRUE(source) << source.error().message;
  EXPECT_THAT(source->roles.others, ElementsAre(0));
}

}  // namespace
}  // namespace throng::app::source_test
