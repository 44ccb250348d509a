#include "app/character/clip_files.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/import/import.h"
#include "engine/anim/rig/rig_map.h"

namespace throng::app::clip_files_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

const std::string mannequin = THRONG_SOURCE_DIR "/assets/mannequin.glb";
const std::string other = THRONG_SOURCE_DIR "/tests/data/features/data-uri.gltf";

std::string refusal_of(const std::string& file, const std::vector<std::string>& clips) {
  anim::ImportedFile imported = *import::import_skins(file);
  const Status added = add_clips_to(file, clips, imported);
  return added ? "(added)" : added.error().message;
}

TEST(ClipFiles, AddTheirClipsUnderNamesThatNoOtherHas) {
  anim::ImportedFile file = *import::import_file(mannequin);
  const std::size_t clips = file.models.front().clips.size();
  ASSERT_TRUE(add_clips_to(mannequin, std::vector<std::string>{mannequin}, file));
  const std::vector<anim::Clip>& all = file.models.front().clips;
  ASSERT_EQ(all.size(), 2 * clips);
  EXPECT_EQ(all[clips].name, "mannequin " + all[0].name);
  EXPECT_EQ(std::set<std::string>(file.animations.begin(), file.animations.end()).size(), file.animations.size());
  EXPECT_EQ(file.animations[static_cast<std::size_t>(all.back().animation)], all.back().name);
  EXPECT_EQ(all[clips].tracks.size(), all[0].tracks.size());
  EXPECT_THAT(file.notes, Contains(HasSubstr("clips taken, with their keys as they are")));
}

TEST(ClipFiles, GetTheNameOfTheirFileAndNumbersWhereAllAreCalledMixamo) {
  anim::ImportedFile file = *import::import_file(mannequin);
  const std::size_t clips = file.models.front().clips.size();
  std::vector<ClipFile> clip_files = *read_clip_files({&mannequin, 1});
  for (anim::Clip& clip : clip_files.front().imported.models.front().clips) clip.name = "mixamo.com";
  ASSERT_TRUE(add_clips_from(pointers_to(clip_files), file, 0));
  const std::vector<anim::Clip>& all = file.models.front().clips;
  EXPECT_EQ(all[clips].name, "mannequin");
  EXPECT_EQ(all[clips + 1].name, "mannequin 2");
  EXPECT_EQ(all.back().name, "mannequin " + std::to_string(clips));
}

TEST(ClipFiles, GoToTheModelThatIsMeant) {
  anim::ImportedFile file = *import::import_file(mannequin);
  file.models.push_back(file.models.front());
  const std::size_t clips = file.models.front().clips.size();
  const std::vector<ClipFile> clip_files = *read_clip_files({&mannequin, 1});
  const auto taken = add_clips_from(pointers_to(clip_files), file, 1);
  ASSERT_TRUE(taken) << taken.error().message;
  EXPECT_EQ(*taken, std::vector<std::string>{mannequin});
  EXPECT_EQ(file.models[0].clips.size(), clips);
  EXPECT_EQ(file.models[1].clips.size(), 2 * clips);
}

TEST(ClipFiles, OfWhomNobodyFollowsAreRefused) {
  EXPECT_THAT(refusal_of(mannequin, {other}), HasSubstr("\"rig\", which is which"));
}

/// Turns all above the hips forward, as the trunk of an animal lies.
void put_on_four_feet(anim::Skeleton& skeleton) {
  const anim::RigMap rig = anim::find_rig(skeleton);
  const auto hips = static_cast<std::size_t>(rig.at(anim::BodyRole::hips));
  const glm::dvec3 pivot = skeleton.references[hips].origin;
  const glm::dquat forward = glm::angleAxis(1.6, glm::dvec3(1.0, 0.0, 0.0));
  std::vector<bool> is_trunk(skeleton.bones.size(), false);
  for (std::size_t bone = 0; bone < skeleton.bones.size(); ++bone) {
    const int parent = skeleton.bones[bone].parent;
    is_trunk[bone] = static_cast<int>(bone) == rig.at(anim::BodyRole::spine) ||
                     (parent >= 0 && is_trunk[static_cast<std::size_t>(parent)]);
    if (!is_trunk[bone]) continue;
    anim::ReferenceFrame& frame = skeleton.references[bone];
    frame.origin = pivot + forward * (frame.origin - pivot);
    frame.rotation = forward * frame.rotation;
  }
}

TEST(ClipFiles, OfABodyThatStandsAreRefusedByOneOnFourFeet) {
  anim::ImportedFile fox = *import::import_skins(mannequin);
  put_on_four_feet(fox.models.front().skeleton);
  std::vector<ClipFile> clips = *read_clip_files({&mannequin, 1});
  const auto refused = add_clips_from(pointers_to(clips), fox, 0);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("mannequin.glb: its body stands upright, and the trunk of "));
  EXPECT_THAT(refused.error().message, HasSubstr(" lies across its legs, as on four feet; give --clips-from clips of"));
  clips.front().must_fit = false;
  const auto taken = add_clips_from(pointers_to(clips), fox, 0);
  ASSERT_TRUE(taken) << taken.error().message;
  EXPECT_TRUE(taken->empty());
  EXPECT_THAT(fox.notes, Contains(HasSubstr("it plays none of the clips of")));
}

TEST(ClipFiles, OfABodyThatRestsBentAreDoubted) {
  std::vector<ClipFile> clips = *read_clip_files({&mannequin, 1});
  put_on_four_feet(clips.front().imported.models.front().skeleton);
  anim::ImportedFile person = *import::import_skins(mannequin);
  const auto taken = add_clips_from(pointers_to(clips), person, 0);
  ASSERT_TRUE(taken) << taken.error().message;
  ASSERT_FALSE(person.notes.empty());
  EXPECT_THAT(person.notes.front(), HasSubstr("its body rests bent and this one upright; look whether its clips"));
}

TEST(ClipFiles, ThatAreNotThereAreRefusedByName) {
  EXPECT_THAT(refusal_of(mannequin, {"no-such-file.glb"}), HasSubstr("no-such-file.glb"));
}

TEST(ClipFiles, OfACharacterAreNoClipsAlone) {
  EXPECT_FALSE(read_clips_alone(mannequin));
  EXPECT_FALSE(read_clips_alone("no-such-file.glb"));
}

}  // namespace
}  // namespace throng::app::clip_files_test
