// Every kind of material that a file can have, in one picture.

#include <gtest/gtest.h>

#include "tests/golden/golden_picture.h"
#include "tests/golden/material_spheres.h"
#include "tests/own_folder.h"

namespace throng::app::test::materials_golden_test {
namespace {

class MaterialsPicture : public testing::TestWithParam<ContextKind> {};

TEST_P(MaterialsPicture, OfTwelveSpheres) {
  const throng::test::OwnFolder folder;
  DemoOptions options = golden_options(GetParam());
  options.models = {write_material_spheres(folder.path()).string()};
  options.tuning.agents = 1;
  options.view = "still";
  options.frames = 3;
  expect_golden_picture("materials", options);
}

INSTANTIATE_TEST_SUITE_P(Headless, MaterialsPicture, testing::ValuesIn(golden_contexts()),
                         [](const auto& run) { return run.param == ContextKind::egl ? "Egl" : "OSMesa"; });

}  // namespace
}  // namespace throng::app::test::materials_golden_test
