// A post process of your own (paper 2.1.2): one entity on top of what an agent's channels make, here of a kind of your
// own that works on the whole pose.

#include <algorithm>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/agent/noise_process.h"
#include "engine/anim/entity/entity_run.h"
#include "tests/anim/agent/crowd_rig.h"

namespace throng::anim::user_post_process_test {
namespace {

// 1. The block: a header that every entity begins with, then what is yours.
struct alignas(64) Tilt {
  AnimationStateHeader state;
  Handle source;
  std::int32_t bone;
  float radians;
};
static_assert(sizeof(Tilt) == entity_header_bytes);

std::span<Handle> source_of(std::byte* block, const EntityLayout&) {
  return {&reinterpret_cast<Tilt*>(block)->source, 1};
}

void pass_on_velocity(const EntityInStore& entity, const SourcesInStore& sources) {
  auto& state = entity.as<Tilt>().state;
  state.delta_time = Ticks{};
  for (int axis = 0; axis < 3; ++axis) state.linear_velocity[axis] = sources[0].linear_velocity[axis];
}

// 2. The work, in the local store, on a PU: no allocation, no lock, nothing but the block and the pose.
void tilt_bone(const EntityInStore& entity, const PoseView& pose) {
  const auto& tilt = entity.as<Tilt>();
  if (tilt.radians == 0.0F || tilt.bone >= pose.bone_count) return;  // dropped by level of detail
  pose.set_rotation(tilt.bone, pose.rotation(tilt.bone) * glm::angleAxis(tilt.radians, glm::vec3(1.0F, 0.0F, 0.0F)));
}

// 3. The kind: what the scheduler must know.
const EntityKind tilt_kind = {
    .name = "tilt", .sources = source_of, .advance = advance_each<pass_on_velocity>, .pose_whole = tilt_bone};

// 4. The post process makes the entity and says what it reads.
class TiltProcess final : public PostProcess {
 public:
  TiltProcess(EntityPools::Kind kind, int bone, float radians) : kind_(kind), bone_(bone), radians_(radians) {}

  Handle attach(const EntityBuilder& build, Handle source) override {
    if (!entity_.valid()) entity_ = build.create(kind_);
    auto& tilt = build.as<Tilt>(entity_);
    tilt.source = source;
    tilt.bone = bone_;
    tilt.radians = radians_;
    return entity_;
  }
  void visit_handles(const std::function<void(Handle&)>& visit) override {
    if (entity_.valid()) visit(entity_);
  }
  void destroy_entities(const EntityBuilder& build) override {
    if (entity_.valid()) build.destroy(entity_);
    entity_ = {};
  }
  std::unique_ptr<PostProcess> clone() const override { return std::make_unique<TiltProcess>(*this); }

 private:
  EntityPools::Kind kind_;
  int bone_;
  float radians_;
  Handle entity_;
};

constexpr int neck = 5;

struct Dancer {
  explicit Dancer(const SystemOptions& options = {})
      : crowd(options), tilts(*crowd->characters().add_entity_kind(tilt_kind)) {
    crowd->agent(0).play({.clip = 1});
  }
  void tilt(float radians) {
    const Status added = crowd->agent(0).add_post_process(std::make_unique<TiltProcess>(tilts, neck, radians));
    EXPECT_TRUE(added) << added.error().message;
  }
  CrowdRig crowd;
  EntityPools::Kind tilts;
};

bool is_below(int bone, int ancestor) {
  const std::vector<Bone>& bones = test_character()->skeleton.bones;
  while (bone > ancestor) bone = bones[static_cast<std::size_t>(bone)].parent;
  return bone == ancestor;
}

TEST(UserPostProcess, TweaksItsBoneAndThoseBelowAndLeavesTheOthersTheirBits) {
  Dancer plain;
  Dancer tilted;
  tilted.tilt(0.5F);
  plain.crowd.step(10);
  tilted.crowd.step(10);
  const std::vector<int> unlike = tilted.crowd.bones_unlike(plain.crowd);
  EXPECT_FALSE(unlike.empty());
  for (int bone = 0; bone < test_character()->skeleton.bone_count(); ++bone) {
    EXPECT_EQ(std::ranges::find(unlike, bone) != unlike.end(), is_below(bone, neck)) << bone;
  }
}

TEST(UserPostProcess, TwoThatAreIdentitiesGiveTheSameBitsAsNone) {
  Dancer plain;
  Dancer processed;
  processed.tilt(0.0F);
  ASSERT_TRUE(processed.crowd->agent(0).add_post_process(
      std::make_unique<NoiseProcess>(NoiseProcess::Settings{.amplitude = 0.0F})));
  plain.crowd.step(60);
  processed.crowd.step(60);
  EXPECT_EQ(processed.crowd.entities(), 3U);
  EXPECT_EQ(processed.crowd->figures().pose_hash(), plain.crowd->figures().pose_hash());
}

TEST(UserPostProcess, SeveralAreAppliedOneOnTopOfTheOther) {
  Dancer once;
  Dancer there_and_back;
  Dancer plain;
  once.tilt(0.5F);
  there_and_back.tilt(0.5F);
  there_and_back.tilt(-0.5F);
  for (Dancer* dancer : {&once, &there_and_back, &plain}) dancer->crowd.step();
  const auto far_from_plain = [&](const Dancer& dancer) {
    float farthest = 0.0F;
    for (std::size_t i = 0; i < plain.crowd.joints().size(); ++i) {
      farthest = std::max(farthest, glm::distance(plain.crowd.joints()[i], dancer.crowd.joints()[i]));
    }
    return farthest;
  };
  EXPECT_GT(far_from_plain(once), 0.01F);
  EXPECT_LT(far_from_plain(there_and_back), 1e-5F);
}

TEST(UserPostProcess, IsTheSameUnderEverySchedule) {
  Dancer fused({.schedule = Schedule::fused});
  Dancer levels({.schedule = Schedule::levels});
  for (Dancer* dancer : {&fused, &levels}) {
    dancer->tilt(0.5F);
    dancer->crowd->agent(0).play({.clip = 2, .fade = 20 * frame_ticks});
    dancer->crowd.step(40);
  }
  EXPECT_EQ(fused.crowd->figures().pose_hash(), levels.crowd->figures().pose_hash());
}

TEST(UserPostProcess, GoesAndGivesItsEntityBack) {
  Dancer plain;
  Dancer tilted;
  tilted.tilt(0.5F);
  plain.crowd.step(10);
  tilted.crowd.step(10);
  tilted.crowd->agent(0).remove_post_process(tilted.crowd->agent(0).post_process_id(0));
  plain.crowd.step();
  tilted.crowd.step();
  EXPECT_TRUE(tilted.crowd.bones_unlike(plain.crowd).empty());
  EXPECT_EQ(tilted.crowd->characters().pools(0).pool(tilted.tilts).alive_count(), 0U);
}

}  // namespace
}  // namespace throng::anim::user_post_process_test
