#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/import/import.h"
#include "tests/import/test_files.h"

// Every broken file, treated as its manifest demands.

namespace throng::import::testing::malformed_test {
namespace {

struct Case {
  std::string file;
  std::string must;
  std::string what;
};

void PrintTo(const Case& broken, std::ostream* out) { *out << broken.file << " (" << broken.what << ")"; }

std::vector<Case> read_manifest() {
  std::vector<Case> cases;
  const nlohmann::json manifest = read_json(data_path("malformed/MANIFEST.json"));
  for (const auto& [file, entry] : manifest.items()) {
    cases.push_back({.file = file, .must = entry["must"], .what = entry["what"]});
  }
  return cases;
}

class Malformed : public ::testing::TestWithParam<Case> {};

TEST_P(Malformed, IsTreatedAsTheManifestDemands) {
  const std::string path = data_path("malformed/" + GetParam().file).string();
  const auto file = import_file(path);
  if (GetParam().must == "accept") {
    EXPECT_TRUE(file.has_value()) << (file ? "" : file.error().message);
  } else if (GetParam().must == "reject") {
    EXPECT_FALSE(file.has_value());
  }
  if (file) return;
  EXPECT_THAT(file.error().message, ::testing::StartsWith(path + ": "));
  EXPECT_THAT(file.error().message, ::testing::Not(::testing::HasSubstr("\n")));
  EXPECT_LT(file.error().message.size(), path.size() + 400);
}

INSTANTIATE_TEST_SUITE_P(Manifest, Malformed, ::testing::ValuesIn(read_manifest()),
                         [](const auto& instance) { return as_test_name(instance.param.file); });

TEST(MalformedManifest, NamesEveryFile) {
  std::vector<std::string> named;
  for (const Case& broken : read_manifest()) named.push_back(broken.file);
  EXPECT_THAT(named, ::testing::UnorderedElementsAreArray(model_files(data_path("malformed"))));
}

}  // namespace
}  // namespace throng::import::testing::malformed_test
