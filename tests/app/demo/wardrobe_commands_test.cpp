// Requests of a person that change the rules by which a crowd dresses.

#include "app/demo/wardrobe_commands.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/wardrobe/cast_rules_text.h"
#include "tests/app/recording/recorded_run.h"

namespace throng::app::wardrobe_commands_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A person in a folder of their own, with a dressed crowd.
class WardrobeCommandsTest : public test::TemporaryFolder {
 protected:
  WardrobeCommandsTest() : show_(test::show_of(test::demo("--agents 100 --wardrobe on"))) {
    fs::current_path(folder_);
    read_standard_rules(show_->stage(), 0, report_);
    report();
  }
  ~WardrobeCommandsTest() override { fs::current_path(before_); }

  bool obey(const WardrobeCommands& commands) {
    const bool is_other_file = obey_wardrobe(*show_, 0, commands, messages_);
    report();
    return is_other_file;
  }
  void report() { report_wardrobe(show_->stage(), 0, report_); }
  std::string said() const { return messages_.all().empty() ? std::string() : messages_.all().back().words; }
  const fs::path before_ = fs::current_path();
  std::unique_ptr<Show> show_;
  WardrobeReport report_;
  Messages messages_;
};

TEST_F(WardrobeCommandsTest, GiveTheCrowdOtherBodies) {
  EXPECT_GT(report_.holding, 5);
  CastTuning children = report_.tuning;
  ASSERT_EQ(children.bodies.back().name, "child");
  children.bodies[0].weight = children.bodies[1].weight = 0.0F;
  children.things = 0.0F;
  EXPECT_FALSE(obey({.cast = NewCast{0, children}, .save = {}, .load = {}}));
  EXPECT_EQ(report_.tuning, children);
  EXPECT_LT(report_.holding, 5) << "who takes pictures brings a camera";
  for (std::size_t agent = 0; agent < 100; ++agent) EXPECT_EQ(show_->stage().crowd().looks().bodies[agent], 2);
  EXPECT_NE(report_.standard, report_.tuning);
}

TEST_F(WardrobeCommandsTest, SaveWhatWasTunedAndReadItAgainAsItWasEditedByHand) {
  CastTuning tuned = report_.tuning;
  tuned.seed = 9;
  obey({.cast = NewCast{0, tuned}, .save = {}, .load = {}});
  EXPECT_TRUE(obey({.cast = {}, .save = "mine", .load = {}}));
  EXPECT_EQ(said(), "Wrote mine.cast.json");
  auto edited = read_cast_rules("mine.cast.json");
  ASSERT_TRUE(edited) << edited.error().message;
  EXPECT_EQ(edited->seed, 9U);
  edited->bodies.front().share = 3.0F;
  ASSERT_TRUE(write_cast_rules("mine.cast.json", *edited));
  EXPECT_TRUE(obey({.cast = {}, .save = {}, .load = ""}));
  EXPECT_EQ(said(), "Read mine.cast.json");
  EXPECT_EQ(report_.tuning.bodies.front().weight, 3.0F);
}

TEST_F(WardrobeCommandsTest, SayInOneLineWhyAFileCannotBeReadAndChangeNothing) {
  const CastTuning before = report_.tuning;
  EXPECT_FALSE(obey({.cast = {}, .save = {}, .load = "none"}));
  EXPECT_THAT(said(), HasSubstr("none.cast.json"));
  CastRules wrong = cast_rules_of(show_->stage(), 0);
  wrong.styles.front().wears.front().parts.front().name = "toga";
  ASSERT_TRUE(write_cast_rules("wrong.cast.json", wrong));
  EXPECT_FALSE(obey({.cast = {}, .save = {}, .load = "wrong"}));
  EXPECT_THAT(said(), testing::StartsWith("wrong.cast.json: style"));
  EXPECT_THAT(said(), HasSubstr("toga"));
  EXPECT_EQ(report_.tuning, before);
}

TEST_F(WardrobeCommandsTest, SayWhyAFileCannotBeWritten) {
  fs::create_directory("mine.cast.json");
  EXPECT_FALSE(obey({.cast = {}, .save = "mine", .load = {}}));
  EXPECT_THAT(said(), HasSubstr("mine.cast.json"));
  EXPECT_TRUE(fs::is_empty("mine.cast.json"));
}

}  // namespace
}  // namespace throng::app::wardrobe_commands_test
