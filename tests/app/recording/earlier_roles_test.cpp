// Recordings of a version that knew fewer roles.

#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "app/recording/bytes.h"
#include "app/recording/items.h"
#include "app/recording/recorded_character.h"
#include "engine/anim/import/json/json.h"

namespace throng::app::earlier_roles_test {
namespace {

constexpr std::size_t earlier_role_count = 9;

RoleClips nine_clips() {
  RoleClips clips = no_clips();
  for (std::size_t role = 0; role < earlier_role_count; ++role) clips[role] = static_cast<int>(role);
  return clips;
}

TEST(EarlierRoles, OfARequestLeaveTheNewOnesWithoutAClip) {
  std::string payload;
  append_number(payload, std::uint32_t{3});
  for (std::int32_t clip = 0; clip < static_cast<std::int32_t>(earlier_role_count); ++clip)
    append_number(payload, clip);
  const auto request = read_request(RecordKind::roles, payload);
  ASSERT_TRUE(request);
  EXPECT_EQ(std::get<RecordedRoles>(*request).character, 3U);
  EXPECT_EQ(std::get<RecordedRoles>(*request).clips, nine_clips());
}

TEST(EarlierRoles, OfAHeaderLeaveTheNewOnesWithoutAClip) {
  const auto read = [](const std::string& roles, std::optional<std::string>& complaint) {
    const auto json = parse_json(R"([{"file": "a.glb", "fingerprint": "f", "roles": )" + roles +
                                 R"(, "bones": ["hips"], "level_counts": [1], "share": 1}])");
    EXPECT_TRUE(json);
    return read_characters(json->elements(), complaint);
  };
  std::optional<std::string> complaint;
  const auto characters = read("[0, 1, 2, 3, 4, 5, 6, 7, 8]", complaint);
  EXPECT_EQ(complaint, std::nullopt);
  ASSERT_EQ(characters.size(), 1U);
  EXPECT_EQ(characters.front().roles, nine_clips());
  read("[0, 1, 2]", complaint);
  EXPECT_NE(complaint.value_or("").find("roles"), std::string::npos) << complaint.value_or("");
}

}  // namespace
}  // namespace throng::app::earlier_roles_test
