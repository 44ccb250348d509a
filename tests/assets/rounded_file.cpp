#include "tests/assets/rounded_file.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "assets/mannequin/glb.h"
#include "assets/mannequin/shape.h"
#include "tests/assets/character_file.h"

namespace throng::test {
namespace {

/// The step to which the generator rounds an accessor of the character, by what it is used for.
std::map<std::size_t, double> steps_by_accessor(const CharacterFile& file) {
  std::map<std::size_t, double> steps;
  const auto& attributes = file.primitive()["attributes"];
  steps[attributes["POSITION"]] = mannequin::position_step;
  steps[attributes["NORMAL"]] = mannequin::normal_step;
  steps[attributes["WEIGHTS_0"]] = mannequin::weight_step;
  steps[attributes["COLOR_0"]] = 1;
  steps[attributes["_SHAPE"]] = steps[attributes["_HAIR"]] = mannequin::shape_step;
  steps[file.json()["skins"][0]["inverseBindMatrices"]] = mannequin::offset_step;
  for (const auto& animation : file.json()["animations"]) {
    for (const auto& channel : animation["channels"]) {
      const auto& sampler = animation["samplers"][channel["sampler"].get<std::size_t>()];
      const bool rotation = channel["target"]["path"] == "rotation";
      steps[sampler["output"]] = rotation ? mannequin::rotation_step : mannequin::offset_step;
    }
  }
  return steps;
}

}  // namespace

void expect_rounded_alike(const std::vector<std::byte>& made, const std::string& name) {
  const std::vector<std::byte> committed =
      CharacterFile::read(std::filesystem::path(THRONG_SOURCE_DIR) / "assets" / name);
  if (made == committed) return;

  const CharacterFile ours(made);
  const CharacterFile theirs(committed);
  ASSERT_EQ(ours.json()["accessors"].size(), theirs.json()["accessors"].size()) << "regenerate assets/" << name;
  const auto steps = steps_by_accessor(ours);
  for (std::size_t accessor = 0; accessor < ours.json()["accessors"].size(); ++accessor) {
    const std::vector<double> a = ours.values(accessor);
    const std::vector<double> b = theirs.values(accessor);
    ASSERT_EQ(a.size(), b.size()) << "accessor " << accessor << ": regenerate assets/" << name;
    const double step = steps.contains(accessor) ? steps.at(accessor) : 0;
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
    EXPECT_LE(worst, step * 1.001) << "accessor " << accessor << ": regenerate assets/" << name;
  }
}

}  // namespace throng::test
