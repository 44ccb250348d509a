// Requests of a person that change the rules by which a crowd dresses.

#include "app/window/wardrobe_requests.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/people/wardrobe/cast_rules_text.h"
#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "app/window/character_reporter.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::wardrobe_requests_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A person in a folder of their own, with a dressed crowd.
class WardrobeRequests : public test::TemporaryFolder {
 protected:
  WardrobeRequests() : show_(test::show_of(test::demo("--agents 100 --wardrobe on"))) {
    fs::current_path(folder_);
    read_standard_rules(show_->stage(), 0, report_);
    report();
  }
  ~WardrobeRequests() override { fs::current_path(before_); }

  /// Returns why the rules cannot be taken; nothing where they are.
  std::string refusal_of(const Result<SetRules>& rules) {
    const Status taken = rules ? show_->take(*rules) : rules.error();
    report();
    return taken ? "" : taken.error().message;
  }
  const Stage& stage() const { return show_->stage(); }
  void report() { report_wardrobe(show_->stage(), 0, report_); }
  const fs::path before_ = fs::current_path();
  std::unique_ptr<Show> show_;
  WardrobeReport report_;
};

TEST_F(WardrobeRequests, GiveTheCrowdOtherBodies) {
  EXPECT_GT(report_.holding, 5);
  CastTuning children = report_.tuning;
  ASSERT_EQ(children.bodies.back().name, "child");
  children.bodies[0].weight = children.bodies[1].weight = 0.0F;
  children.things = 0.0F;
  EXPECT_EQ(refusal_of(tuned({0, children}, stage())), "");
  EXPECT_EQ(report_.tuning, children);
  EXPECT_LT(report_.holding, 5) << "who takes pictures brings a camera";
  for (std::size_t agent = 0; agent < 100; ++agent) EXPECT_EQ(show_->stage().crowd().looks().bodies[agent], 2);
  EXPECT_NE(report_.standard, report_.tuning);
}

TEST_F(WardrobeRequests, SaveWhatWasTunedAndReadItAgainAsItWasEditedByHand) {
  CastTuning other = report_.tuning;
  other.seed = 9;
  EXPECT_EQ(refusal_of(tuned({0, other}, stage())), "");
  EXPECT_EQ(refusal_of(saved({"mine"}, stage(), 0)), "");
  auto edited = read_cast_rules("mine.cast.json");
  ASSERT_TRUE(edited) << edited.error().message;
  EXPECT_EQ(edited->seed, 9U);
  edited->bodies.front().share = 3.0F;
  ASSERT_TRUE(write_cast_rules("mine.cast.json", *edited));
  EXPECT_EQ(refusal_of(loaded({}, stage(), 0)), "") << "from the file in force";
  EXPECT_EQ(report_.tuning.bodies.front().weight, 3.0F);
}

TEST_F(WardrobeRequests, SayInOneLineWhyAFileCannotBeReadAndChangeNothing) {
  const CastTuning before = report_.tuning;
  EXPECT_THAT(refusal_of(loaded({"none"}, stage(), 0)), HasSubstr("none.cast.json"));
  CastRules wrong = show_->stage().clothing()[0].rules;
  wrong.styles.front().wears.front().parts.front().name = "toga";
  ASSERT_TRUE(write_cast_rules("wrong.cast.json", wrong));
  const std::string words = refusal_of(loaded({"wrong"}, stage(), 0));
  EXPECT_THAT(words, testing::StartsWith("wrong.cast.json: style"));
  EXPECT_THAT(words, HasSubstr("toga"));
  EXPECT_EQ(report_.tuning, before);
}

TEST_F(WardrobeRequests, SayWhyAFileCannotBeWritten) {
  fs::create_directory("mine.cast.json");
  EXPECT_THAT(refusal_of(saved({"mine"}, stage(), 0)), HasSubstr("mine.cast.json"));
  EXPECT_TRUE(fs::is_empty("mine.cast.json"));
}

}  // namespace
}  // namespace throng::app::wardrobe_requests_test
