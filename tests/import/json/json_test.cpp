#include "engine/base/json/json.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::json_test {
namespace {

using testing::HasSubstr;

std::string printed_again(std::string_view text) { return parse_json(text)->dump(); }

std::string refusal_of(std::string_view text) {
  const auto json = parse_json(text);
  return json ? "(taken)" : json.error().message;
}

TEST(Json, PrintsObjectsInTheOrderOfTheirMembers) {
  Json json = {{"zebra", 1}, {"ape", {{"kept", true}}}};
  json["middle"] = std::array{1, 2};
  json["ape"]["lost"] = nullptr;
  EXPECT_EQ(json.dump(), R"({"zebra":1,"ape":{"kept":true,"lost":null},"middle":[1,2]})");
  EXPECT_EQ(Json({{"a", Json::array({1, "b"})}, {"c", Json::object()}}).dump(2),
            "{\n  \"a\": [\n    1,\n    \"b\"\n  ],\n  \"c\": {}\n}");
}

TEST(Json, IsMadeOfListsAndOfValuesThatMayBeMissing) {
  EXPECT_EQ(Json(std::vector<std::string>{"a", "b"}).dump(), R"(["a","b"])");
  EXPECT_EQ(Json({{"none", std::optional<int>()}, {"one", std::optional(1)}}).dump(), R"({"none":null,"one":1})");
}

TEST(Json, KeepsEveryBitOfWholeNumbers) {
  for (const char* const number : {"0", "-1", "18446744073709551615", "-9223372036854775808", "9007199254740993"}) {
    EXPECT_EQ(printed_again(number), number);
  }
  EXPECT_EQ(Json(std::numeric_limits<std::uint64_t>::max()).dump(), "18446744073709551615");
  EXPECT_EQ(parse_json("5")->dump(), Json(5).dump());
  EXPECT_EQ(*parse_json("5"), Json(std::uint8_t{5})) << "whatever the type";
}

TEST(Json, PrintsTheShortestDigitsThatAreTheSameDouble) {
  for (const char* const number : {"0.1", "1e+300", "-0.0", "1.0", "5e-324", "0.30000000000000004"}) {
    EXPECT_EQ(printed_again(number), number);
  }
  EXPECT_EQ(Json(0.1F).dump(), "0.10000000149011612") << "a float is the double that it is";
  EXPECT_EQ(Json(0.1F).get<float>(), 0.1F);
  EXPECT_EQ(Json(std::numeric_limits<double>::infinity()).dump(), "null");
}

TEST(Json, SaysWhetherANumberIsWholeAndFits) {
  const Json json = *parse_json("[255, -1, 256, 1.0, 18446744073709551615]");
  const auto element = [&](std::size_t index) { return json.elements()[index]; };
  EXPECT_TRUE(element(0).is<std::uint8_t>());
  EXPECT_FALSE(element(1).is<std::uint8_t>());
  EXPECT_FALSE(element(2).is<std::uint8_t>());
  EXPECT_FALSE(element(3).is<int>()) << "it has a fraction, if of nothing";
  EXPECT_FALSE(element(4).is<std::int64_t>());
  EXPECT_TRUE(element(4).is<double>());
  EXPECT_TRUE(element(2).is_whole(-1, 256));
  EXPECT_FALSE(element(2).is_whole(-1, 255));
  EXPECT_FALSE(json.are_whole(-1, 256));
  EXPECT_FALSE(json.is<std::vector<std::string>>());
}

TEST(Json, HasNullWhereItHasNoMember) {
  const Json json = {{"there", 1}};
  EXPECT_TRUE(json["missing"].is_null());
  EXPECT_TRUE(json["there"]["deeper"].is_null());
  EXPECT_TRUE(json["there"].elements().empty());
  EXPECT_EQ(json.value("there", 5), 1);
  EXPECT_EQ(json.value("missing", 5), 5);
  EXPECT_EQ(json.value("there", std::string("no text")), "no text");
}

TEST(Json, EscapesWhatMustBeAndReplacesWhatIsNotUtf8) {
  EXPECT_EQ(Json("a\"\\\n\x01/ä").dump(), R"("a\"\\\n\u0001/ä")");
  EXPECT_EQ(Json("a\xff").dump(), "\"a\xEF\xBF\xBD\"");
  EXPECT_EQ(parse_json(R"("\u00e4\ud83d\ude00")")->get<std::string>(), "ä😀");
  EXPECT_THAT(refusal_of("\"a\xff\""), HasSubstr("is not JSON"));
}

TEST(Json, TakesTheLastOfMembersOfOneKeyInThePlaceOfTheFirst) {
  EXPECT_EQ(printed_again(R"({"a": 1, "b": 2, "a": [3]})"), R"({"a":[3],"b":2})");
}

TEST(Json, SaysWhereTextStopsBeingJson) {
  EXPECT_EQ(refusal_of("{\n  \"a\": 1,\n  oops\n}"), "is not JSON at line 3, column 3");
  EXPECT_EQ(refusal_of(""), "is not JSON at line 1, column 1");
  EXPECT_EQ(refusal_of("[1] 2"), "is not JSON at line 1, column 5");
  EXPECT_EQ(refusal_of("[1e999]"), "has a number that is too large at line 1, column 6");
}

TEST(Json, RefusesWhatIsNestedTooDeepOrTooLong) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_EQ(refusal_of(nested(most_json_depth)), "(taken)");
  EXPECT_EQ(refusal_of(nested(most_json_depth + 1)), "is nested deeper than 64 levels");
  EXPECT_EQ(refusal_of(std::string(1'000'000, '[')), "is nested deeper than 64 levels");
  std::string wide = "[0";
  for (std::size_t value = 0; value < most_json_values; ++value) wide += ",0";
  EXPECT_EQ(refusal_of(wide + "]"), "has more than 1048576 values");
  std::string members = "{";
  for (std::size_t key = 0; key <= most_json_members; ++key) members += '"' + std::to_string(key) + "\":0,";
  EXPECT_EQ(refusal_of(members + "\"\":0}"), "has an object of more than 1000 members");
  EXPECT_EQ(refusal_of(std::string(most_json_bytes + 1, ' ')), "is longer than 16777216 bytes");
}

}  // namespace
}  // namespace throng::json_test
