#include "engine/base/json/json_object.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::json_object_test {
namespace {

class JsonObjects : public testing::Test {
 protected:
  /// Reads a state of a machine, say, and returns the first complaint.
  std::string complaint(std::string_view text) {
    const Json json = *parse_json(text);
    std::optional<std::string> first;
    const JsonObject object("state 2", json, {"name", "speed", "loop", "count", "marks", "tags"}, first);
    object.text("name", name_);
    object.number("speed", speed_, 0, 4);
    object.flag("loop", loop_);
    object.whole("count", count_, 1, 8);
    object.wholes("marks", marks_, 0, 9);
    object.texts("tags", tags_);
    object.need({"name"});
    return first.value_or("");
  }

  std::string name_ = "none";
  double speed_ = 1;
  bool loop_ = false;
  int count_ = 3;
  std::vector<int> marks_;
  std::vector<std::string> tags_;
};

TEST_F(JsonObjects, ReadMembersAndKeepWhatIsNotSaid) {
  EXPECT_EQ(complaint(R"({"name": "walk", "speed": 2, "marks": [0, 9], "tags": ["a"]})"), "");
  EXPECT_EQ(name_, "walk");
  EXPECT_EQ(speed_, 2);
  EXPECT_EQ(count_, 3);
  EXPECT_THAT(marks_, testing::ElementsAre(0, 9));
  EXPECT_THAT(tags_, testing::ElementsAre("a"));
}

TEST_F(JsonObjects, NameTheObjectTheKeyAndWhatIsExpected) {
  EXPECT_EQ(complaint("[]"), "state 2 must be an object");
  EXPECT_EQ(complaint("{}"), "state 2: \"name\" is missing");
  EXPECT_EQ(complaint(R"({"nmae": 1})"),
            "state 2 has an unknown key \"nmae\"; it knows name, speed, loop, count, marks, tags");
  EXPECT_EQ(complaint(R"({"name": 5})"), "state 2: \"name\" must be a text");
  EXPECT_EQ(complaint(R"({"name": "a", "speed": 5})"), "state 2: \"speed\" must be a number, 0 to 4");
  EXPECT_EQ(complaint(R"({"name": "a", "loop": 0})"), "state 2: \"loop\" must be true or false");
  EXPECT_EQ(complaint(R"({"name": "a", "count": 1.5})"), "state 2: \"count\" must be a whole number, 1 to 8");
  EXPECT_EQ(complaint(R"({"name": "a", "marks": [10]})"),
            "state 2: \"marks\" must be an array of whole numbers, 0 to 9");
  EXPECT_EQ(complaint(R"({"name": "a", "tags": "b"})"), "state 2: \"tags\" must be an array of texts");
}

TEST_F(JsonObjects, KeepTheirValuesAndTheFirstComplaintWhereSomethingIsWrong) {
  EXPECT_EQ(complaint(R"({"name": 5, "speed": 9})"), "state 2: \"name\" must be a text");
  EXPECT_EQ(name_, "none");
  EXPECT_EQ(speed_, 1);
}

TEST(JsonTables, HaveTheVersionThatIsRead) {
  const auto complaint = [](std::string_view text) {
    const Json json = *parse_json(text);
    std::optional<std::string> first;
    JsonObject("", json, {"version", "names"}, first).version(2);
    return first.value_or("");
  };
  EXPECT_EQ(complaint(R"({"names": 1, "version": 2})"), "");
  EXPECT_EQ(complaint("[]"), "it must be an object");
  EXPECT_EQ(complaint(R"({"version": 2, "count": 1})"), "it has an unknown key \"count\"; it knows version, names");
  EXPECT_EQ(complaint(R"({"version": "2"})"), "\"version\" must be 2");
  EXPECT_EQ(complaint("{}"), "\"version\" must be 2");
}

}  // namespace
}  // namespace throng::json_object_test
