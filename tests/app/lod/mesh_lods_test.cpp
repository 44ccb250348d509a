// The mesh LOD of an agent follows from the error that it shows on screen, and from nothing else.
#include "app/lod/mesh_lods.h"

#include <vector>

#include <gtest/gtest.h>

namespace throng::app::mesh_lods_test {
namespace {

class ChosenMeshes : public testing::Test {
 protected:
  ChosenMeshes() { lods_.set(0, {0.0F, 0.004F, 0.02F}); }

  std::vector<CharacterSource> characters_ = std::vector<CharacterSource>(2);
  MeshLods lods_{characters_};
  Tuning tuning_{.error_px = 1.0F};
};

TEST_F(ChosenMeshes, AreTheCoarsestThatAreOffByHalfOfTheLimitAtMost) {
  EXPECT_EQ(lods_.choose(tuning_, 0, 1000.0F), 0);
  EXPECT_EQ(lods_.choose(tuning_, 0, 126.0F), 0);
  EXPECT_EQ(lods_.choose(tuning_, 0, 124.0F), 1);
  EXPECT_EQ(lods_.choose(tuning_, 0, 26.0F), 1);
  EXPECT_EQ(lods_.choose(tuning_, 0, 24.0F), 2);
  EXPECT_EQ(lods_.choose(tuning_, 0, 0.0F), 2);
  EXPECT_FLOAT_EQ(lods_.error_px(0, 1, 124.0F), 0.496F);
}

TEST_F(ChosenMeshes, FollowTheLimit) {
  tuning_.error_px = 4.0F;
  EXPECT_EQ(lods_.choose(tuning_, 0, 499.0F), 1);
  tuning_.error_px = 0.0F;  // a budget without a limit: the usual one
  EXPECT_EQ(lods_.choose(tuning_, 0, 1000.0F), 0);
}

TEST_F(ChosenMeshes, AreTheFixedOneWhereTheTuningHasOne) {
  tuning_.mesh_lod = 1;
  EXPECT_EQ(lods_.choose(tuning_, 0, 1000.0F), 1);
  tuning_.mesh_lod = 3;
  EXPECT_EQ(lods_.choose(tuning_, 0, 1000.0F), 2) << "the coarsest that there is";
}

TEST_F(ChosenMeshes, MayBeOffByMoreWhereAProcessorDraws) {
  lods_.allow_more(3.0F);
  EXPECT_EQ(lods_.choose(tuning_, 0, 374.0F), 1);
}

TEST_F(ChosenMeshes, OfACharacterWithoutLodsAreTheFullOne) {
  EXPECT_EQ(lods_.choose(tuning_, 1, 1.0F), 0);
  EXPECT_EQ(lods_.error_px(1, 0, 100.0F), 0.0F);
}

TEST_F(ChosenMeshes, LeaveTheOtherHalfOfTheLimitToPoses) {
  EXPECT_FLOAT_EQ(pose_error_limit(tuning_), 0.5F);
  tuning_.mesh_lod = 0;
  EXPECT_FLOAT_EQ(pose_error_limit(tuning_), 1.0F);
}

}  // namespace
}  // namespace throng::app::mesh_lods_test
