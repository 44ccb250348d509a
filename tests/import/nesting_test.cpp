#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/import/test_files.h"

namespace throng::import::testing::nesting_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

TEST(NestedInput, IsRefusedWhereNothingNeedsItsDepth) {
  const TemporaryFolder folder;
  const std::string refusal = message_of(folder.write("deep.gltf", "{\"extras\": " + std::string(1'000'000, '[')));
  EXPECT_THAT(refusal, HasSubstr("its text is nested deeper than 128 levels; export it again as glTF 2.0"));
}

TEST(NestedInput, MayBeAChainOfNodesOfAnyLength) {
  constexpr std::size_t links = 20'000;
  json document = editable_document();
  json& nodes = document["nodes"];
  const std::size_t first = nodes.size();
  const json below = nodes[0]["children"];
  nodes[0]["children"] = json::array({first});
  for (std::size_t link = first + 1; link < first + links; ++link) nodes.push_back({{"children", json::array({link})}});
  nodes.push_back({{"children", below}});
  const TemporaryFolder folder;
  const anim::ImportedFile file = import_good(folder.write("chain.gltf", document.dump()));
  ASSERT_EQ(file.models.size(), 1U);
  EXPECT_EQ(file.models.front().skeleton.bone_count(),
            import_good(folder.write("plain.gltf", editable_document().dump())).models.front().skeleton.bone_count());
}

}  // namespace
}  // namespace throng::import::testing::nesting_test
