#include "app/character/role_table.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace throng::app::role_table_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::vector<std::string> names{"Idle", "Walking_A", "Walking_B", "Running_A", "Cheer"};

std::string refusal_of(const std::vector<RoleChoice>& choices) {
  RoleClips clips = no_clips();
  const Status chosen = choose_clips(choices, names, clips);
  EXPECT_EQ(clips, no_clips()) << "nothing has changed";
  return chosen ? "(taken)" : chosen.error().message;
}

TEST(ChooseClips, PutsTheChoicesOverWhatWasThere) {
  RoleClips clips = no_clips();
  clips[index_of(Role::walk)] = 1;
  clips[index_of(Role::cheer)] = 4;
  ASSERT_TRUE(choose_clips(std::vector<RoleChoice>{{Role::walk, "Walking_B"}, {Role::cheer, "none"}}, names, clips));
  EXPECT_EQ(clips[index_of(Role::walk)], 2);
  EXPECT_EQ(clips[index_of(Role::cheer)], no_clip);
}

TEST(ChooseClips, NamesTheNearestOfAnUnknownClipAndTakesNothing) {
  EXPECT_EQ(refusal_of({{Role::stand, "Idle"}, {Role::walk, "walking"}}),
            "walk=walking: the model has no such clip; nearest are Walking_A, Walking_B, Idle");
}

TEST(AllChoices, NameEveryRole) {
  RoleClips clips = no_clips();
  clips[index_of(Role::run)] = 3;
  const std::vector<RoleChoice> choices = all_choices(clips, names);
  ASSERT_EQ(choices.size(), role_count);
  EXPECT_EQ(choices[index_of(Role::run)], (RoleChoice{Role::run, "Running_A"}));
  EXPECT_EQ(choices[index_of(Role::sit)], (RoleChoice{Role::sit, "none"}));
}

/// A folder with a model, and a configuration of its own.
struct RoleFileTest : testing::Test {
  fs::path folder = fs::temp_directory_path() / ("throng_roles_" + std::to_string(getpid()));
  fs::path model = folder / "models" / "Fox.glb";
  fs::path beside = folder / "models" / "Fox.glb.throng.json";
  fs::path own = folder / "config" / "throng" / "Fox.glb.throng.json";

  RoleFileTest() {
    fs::create_directories(folder / "models");
    setenv("XDG_CONFIG_HOME", (folder / "config").c_str(), 1);
  }
  ~RoleFileTest() override {
    fs::remove_all(folder);
    unsetenv("XDG_CONFIG_HOME");
  }

  static void put(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }
  std::string refusal_of_table(const std::string& text) const {
    put(beside, text);
    const auto read = RoleFile(model).read();
    return read ? "(taken)" : read.error().message;
  }
};

TEST_F(RoleFileTest, IsReadAsItWasWritten) {
  const std::vector<RoleChoice> choices{{Role::walk, "Walk \"quickly\""}, {Role::sit, "none"}};
  const auto written = RoleFile(model).write(choices);
  ASSERT_TRUE(written);
  EXPECT_EQ(*written, beside);
  const auto read = RoleFile(model).read();
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, choices);
}

TEST_F(RoleFileTest, SaysTheBonesOfTheBodyAndKeepsThemWhenRolesAreWritten) {
  put(beside, R"({"version": 1, "rig": {"hips": "Bone.003", "leftFoot": "ankle"}})");
  const std::vector<RigChoice> rig{{anim::BodyRole::hips, "Bone.003"}, {anim::BodyRole::left_foot, "ankle"}};
  EXPECT_EQ(*RoleFile(model).read_rig(), rig);
  EXPECT_TRUE(RoleFile(model).read()->empty());
  ASSERT_TRUE(RoleFile(model).write(std::vector<RoleChoice>{{Role::walk, "Walk"}}));
  EXPECT_EQ(*RoleFile(model).read_rig(), rig);
  ASSERT_TRUE(RoleFile(model).write_rig(std::span(rig).first(1)));
  EXPECT_EQ(RoleFile(model).read_rig()->size(), 1U);
  EXPECT_EQ(*RoleFile(model).read(), (std::vector<RoleChoice>{{Role::walk, "Walk"}}));
}

TEST_F(RoleFileTest, RefusesPartsThatNoBodyHas) {
  const auto refusal = [&](const std::string& text) {
    put(beside, text);
    const auto read = RoleFile(model).read_rig();
    return read ? "(taken)" : read.error().message;
  };
  EXPECT_THAT(refusal(R"({"version": 1, "rig": {"tail": "Tail"}})"), HasSubstr("\"rig\" has no part \"tail\""));
  EXPECT_THAT(refusal(R"({"version": 1, "rig": {"hips": 3}})"), HasSubstr("\"hips\" must be the name of a bone"));
  EXPECT_THAT(refusal(R"({"version": 1, "rig": []})"), HasSubstr("\"rig\" must be an object"));
}

TEST(ChooseBones, GivesThePartToThatBoneAlone) {
  anim::Skeleton skeleton;
  skeleton.bones.resize(2);
  skeleton.bones[0].name = "Pelvis";
  skeleton.bones[1].name = "Torso";
  skeleton.bones[1].role = anim::BodyRole::hips;
  ASSERT_TRUE(choose_bones(std::vector<RigChoice>{{anim::BodyRole::hips, "Pelvis"}}, skeleton));
  EXPECT_EQ(skeleton.bones[0].role, anim::BodyRole::hips);
  EXPECT_EQ(skeleton.bones[1].role, std::nullopt);
  const Status refused = choose_bones(std::vector<RigChoice>{{anim::BodyRole::head, "pelvs"}}, skeleton);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "head=pelvs: the skeleton has no such bone; nearest are Pelvis, Torso");
}

TEST(ChooseBones, RefusesOneBoneForTwoPartsAndAFootAboveTheKnee) {
  anim::Skeleton skeleton;
  skeleton.bones.resize(3);
  for (int bone = 0; bone < 3; ++bone) {
    skeleton.bones[static_cast<std::size_t>(bone)].name = std::string(1, static_cast<char>('a' + bone));
    skeleton.bones[static_cast<std::size_t>(bone)].parent = bone - 1;
  }
  const auto refusal = [&](const std::vector<RigChoice>& choices) {
    const Status chosen = choose_bones(choices, skeleton);
    return chosen ? "(taken)" : chosen.error().message;
  };
  EXPECT_THAT(refusal({{anim::BodyRole::hips, "a"}, {anim::BodyRole::spine, "a"}}),
              HasSubstr("a cannot be both the hips and the spine"));
  EXPECT_EQ(refusal({{anim::BodyRole::left_lower_leg, "c"}, {anim::BodyRole::left_foot, "b"}}),
            "b cannot be the left foot: it is above c, the left lower leg");
  EXPECT_FALSE(skeleton.bones[1].role);
  EXPECT_EQ(refusal({{anim::BodyRole::left_lower_leg, "b"}, {anim::BodyRole::left_foot, "c"}}), "(taken)");
}

TEST_F(RoleFileTest, IsEmptyWhereThereIsNone) {
  const auto read = RoleFile(model).read();
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->empty());
}

TEST_F(RoleFileTest, OfTheBuiltInCharacterIsTheUsersOwn) {
  const auto written = RoleFile("").write(std::vector<RoleChoice>{{Role::walk, "jog"}});
  ASSERT_TRUE(written);
  EXPECT_EQ(*written, folder / "config" / "throng" / "mannequin.throng.json");
  EXPECT_EQ(RoleFile("").read()->size(), 1U);
}

TEST_F(RoleFileTest, IsTheUsersOwnWhereTheModelsFolderCannotBeWritten) {
  const RoleFile of_no_folder(folder / "nowhere" / "Fox.glb");
  const auto written = of_no_folder.write(std::vector<RoleChoice>{{Role::walk, "Run"}});
  ASSERT_TRUE(written);
  EXPECT_EQ(*written, own);
  EXPECT_EQ(of_no_folder.read()->size(), 1U);
}

TEST_F(RoleFileTest, SaysWhatIsWrongInIt) {
  const std::string file = beside.string() + ": ";
  EXPECT_EQ(refusal_of_table("{"),
            file + "is not JSON at line 1, column 2; delete it to go by the names of clips and bones again");
  EXPECT_EQ(refusal_of_table("[]"), file + "it must be an object");
  EXPECT_EQ(refusal_of_table("{}"), file + "\"version\" must be 1");
  EXPECT_EQ(refusal_of_table(R"({"version": 2})"), file + "\"version\" must be 1");
  EXPECT_EQ(refusal_of_table(R"({"version": 1, "clip": {}})"),
            file + "it has an unknown key \"clip\"; it knows version, clips, rig");
  EXPECT_EQ(refusal_of_table(R"({"version": 1, "clips": []})"),
            file + "\"clips\" must be an object of roles and clip names");
  EXPECT_EQ(refusal_of_table(R"({"version": 1, "clips": {"fly": "Idle"}})"),
            file + "\"clips\" has no role \"fly\"; it knows " + known_roles());
  EXPECT_EQ(refusal_of_table(R"({"version": 1, "clips": {"walk": 3}})"),
            file + "\"clips\": \"walk\" must be the name of a clip, or \"none\"");
  EXPECT_EQ(refusal_of_table(R"({"version": 1, "clips": {"walk": "Idle"}})"), "(taken)");
}

}  // namespace
}  // namespace throng::app::role_table_test
