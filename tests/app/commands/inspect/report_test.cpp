#include "app/commands/inspect/report.h"

#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/commands/inspect/text_table.h"
#include "engine/anim/import/import.h"

namespace throng::app::report_test {
namespace {

using testing::HasSubstr;

TEST(TextTable, PutsColumnsBelowEachOther) {
  TextTable table({"clip", "name", "keys"});
  table.add({"0", "Läufer", "5"});
  table.add({"11", "a", "1200"});
  EXPECT_EQ(table.text(1),
            " clip  name    keys\n"
            " 0     Läufer     5\n"
            " 11    a       1200\n");
}

/// Takes the models out of the file, as they are.
std::string report_of(anim::ImportedFile file) {
  std::vector<InspectedModel> models;
  for (anim::Model& model : file.models) {
    const anim::GuessedPlacement placed = anim::guess_placement(model);
    models.push_back({std::move(model), placed});
  }
  return inspection_text(file, models);
}

TEST(Inspection, SaysSizeClipsMaterialsAndGuesses) {
  const auto file = import::import_file(std::string(THRONG_SOURCE_DIR) + "/assets/mannequin.glb");
  ASSERT_TRUE(file) << file.error().message;
  const std::string text = report_of(*file);
  for (const char* part :
       {": 1 skeleton, ", "nothing to repair", "\n  1.", " m tall", "bone levels", "\n  rig: hips ", "played from",
        "root motion", "triangles", "base colour", "guessed: roles by the names of clips: stand "}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
}

TEST(Inspection, ListsMorphsAndTheClipsThatAnimateThem) {
  auto file = import::import_file(std::string(THRONG_SOURCE_DIR) + "/tests/data/features/plain.glb");
  ASSERT_TRUE(file) << file.error().message;
  anim::Model& model = file->models.front();
  EXPECT_THAT(report_of(*file), testing::Not(HasSubstr("morph")));
  model.morphs = {{.name = "mesh 0, target 2 \"smile\"", .node = 1, .target = 2, .rest_weight = 0.25}};
  model.meshes.front().morph_deltas.resize(3);
  model.clips.front().name = "talk";
  model.clips.front().morph_tracks = {
      {.interpolation = anim::Interpolation::linear, .morphs = {0}, .times = {0.0F}, .weights = {1.0F}}};
  EXPECT_THAT(report_of(*file), testing::ContainsRegex("target 2 \"smile\" +3 +0.25 +talk\n"));
}

TEST(Inspection, TellsWhatWasRepairedFromWhatWasLeftOut) {
  auto file = import::import_file(std::string(THRONG_SOURCE_DIR) + "/tests/data/features/plain.glb");
  ASSERT_TRUE(file) << file.error().message;
  file->repairs = {"node 1: its rotation has length 2, normalised", "image 0: left out, because it is missing"};
  const std::string text = report_of(*file);
  EXPECT_THAT(text, HasSubstr("2 repairs\n"));
  EXPECT_THAT(text, HasSubstr("\nrepaired: node 1: its rotation"));
  EXPECT_THAT(text, HasSubstr("\nleft out: image 0: left out, because"));
}

}  // namespace
}  // namespace throng::app::report_test
