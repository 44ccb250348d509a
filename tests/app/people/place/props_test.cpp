#include "app/people/place/props.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include <gmock/gmock.h>

#include "tests/app/temporary_folder.h"

namespace throng::app::test::props_test {
namespace {

using testing::HasSubstr;

constexpr const char* committed = THRONG_SOURCE_DIR "/assets/places.glb";

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class Props : public TemporaryFolder {
 protected:
  std::string error_of(const std::string& bytes) const {
    const std::filesystem::path file = folder_ / "places.glb";
    std::ofstream(file, std::ios::binary) << bytes;
    const auto props = read_props(file);
    return props ? "" : props.error().message;
  }
};

TEST_F(Props, AreReadWithAllTheirLevels) {
  const auto props = read_props(committed);
  ASSERT_TRUE(props) << props.error().message;
  EXPECT_GE(props->size(), 30U);
  for (const render::SceneryMeshData& prop : *props) {
    EXPECT_FALSE(prop.name.empty());
    ASSERT_FALSE(prop.lods.empty()) << prop.name;
    EXPECT_EQ(prop.lods.front().error, 0.0F) << prop.name;
    for (const render::SceneryVertex& v : prop.vertices) {
      EXPECT_NEAR(std::hypot(v.normal[0], v.normal[1], v.normal[2]), 1.0F, 1e-5F) << prop.name;
    }
  }
}

TEST_F(Props, OfAMissingFileAreRefusedWithItsName) {
  const auto props = read_props(folder_ / "nothing.glb");
  ASSERT_FALSE(props);
  EXPECT_THAT(props.error().message, HasSubstr("nothing.glb"));
}

TEST_F(Props, OfAFileThatEndsEarlyAreRefused) {
  const std::string whole = bytes_of(committed);
  for (const std::size_t length : {0UL, 3UL, 15UL, 19UL, 400UL, 30'000UL, whole.size() / 2, whole.size() - 1}) {
    EXPECT_THAT(error_of(whole.substr(0, length)), HasSubstr("places.glb: the file of props is damaged")) << length;
  }
}

TEST_F(Props, OfAnotherFileAreRefused) {
  EXPECT_THAT(error_of("no glTF at all, but a text that is long enough"), HasSubstr("no binary glTF"));
  EXPECT_THAT(error_of(bytes_of(THRONG_SOURCE_DIR "/assets/mannequin.glb")), HasSubstr("damaged"));
}

TEST_F(Props, WhateverIsChangedInTheDescriptionNothingOutsideOfTheFileIsRead) {
  const std::string whole = bytes_of(committed);
  for (std::size_t at = 20; at < 9'000; at += 61) {
    std::string changed = whole;
    changed[at] = changed[at] == '9' ? '1' : '9';
    error_of(changed);  // sanitizers look
  }
}

TEST_F(Props, WithATriangleBeyondTheirCornersAreRefused) {
  std::string changed = bytes_of(committed);
  changed[changed.size() - 1] = changed[changed.size() - 2] = '\xFF';  // the last index of the last mesh
  changed[changed.size() - 3] = changed[changed.size() - 4] = '\xFF';
  EXPECT_THAT(error_of(changed), HasSubstr("a corner that is not there"));
}

}  // namespace
}  // namespace throng::app::test::props_test
