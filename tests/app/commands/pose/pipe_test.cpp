#include "app/commands/pose/pipe.h"

#include <gtest/gtest.h>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/asset/synthetic_model.h"

namespace throng::app::pipe_test {
namespace {

/// A model whose clip has its first key at 100 s.
anim::Model late_model() {
  anim::Model model = anim::synthetic_model(20, 1);
  anim::Clip& clip = model.clips.front();
  for (anim::BoneTracks& tracks : clip.tracks) {
    for (float& time : tracks.rotation.times) time += 100.0F;
    for (float& time : tracks.translation.times) time += 100.0F;
  }
  clip.start += 100.0;
  clip.duration += 100.0;
  return model;
}

TEST(PosePipe, KeepsTheTimeOfTheFile) {
  const anim::Model model = late_model();
  const anim::Clip& clip = model.clips.front();
  PosePipe pipe(anim::StreamKind::keyframe);
  for (const double seconds : {0.0, 50.0, 100.0, 100.3, 100.9, clip.duration}) {
    const auto pose = pipe.pose(model, &clip, seconds);
    ASSERT_TRUE(pose) << pose.error().message;
    const anim::ReferencePose expected = anim::reference_pose(model.skeleton, &clip, seconds);
    for (std::size_t entry = 0; entry < expected.palette.size(); ++entry) {
      EXPECT_LT(glm::distance(pose->palette[entry][3], expected.palette[entry][3]), 1e-4) << seconds;
    }
  }
}

}  // namespace
}  // namespace throng::app::pipe_test
