// The rules bite: each is given a small tree that breaks it, beside one that does not.
#include "tests/house/house_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::house::house_rules_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

Tree one(const std::string& path, const std::string& text) { return {source_file(path, text)}; }

TEST(Floors, RefuseAnIncludeOfAHigherFloor) {
  const Tree tree = one("engine/anim/asset/clip.h", "#pragma once\n\n#include \"engine/anim/kernel/blend.h\"\n");
  EXPECT_THAT(includes_that_climb(tree), ElementsAre(StartsWith("engine/anim/asset/clip.h:3: includes")));
}

TEST(Floors, AllowOnesOwnFloorAndLowerOnes) {
  const Tree tree = one("engine/anim/kernel/blend.h",
                        "#include \"engine/anim/kernel/lanes.h\"\n#include \"engine/anim/asset/clip.h\"\n");
  EXPECT_THAT(includes_that_climb(tree), IsEmpty());
}

TEST(Floors, KeepRoomsOfOneHeightApart) {
  const Tree tree = one("engine/anim/import/import.cpp", "#include \"engine/anim/kernel/lanes/rotations.h\"\n");
  EXPECT_THAT(includes_that_climb(tree), testing::SizeIs(1));
}

TEST(Floors, LieInsideARoomToo) {
  const std::string table = "#include \"engine/anim/kernel/kernels.h\"\n";
  EXPECT_THAT(includes_that_climb(one("engine/anim/kernel/pose/blend.cpp", table)), testing::SizeIs(1));
  EXPECT_THAT(includes_that_climb(one("engine/anim/bake/bake.cpp", table)), IsEmpty());
}

TEST(Floors, OfTheProgramAreKeptToo) {
  EXPECT_THAT(includes_that_climb(one("app/show/stage/stage.h", "#include \"app/window/panel/overlay.h\"\n")),
              testing::SizeIs(1));
  EXPECT_THAT(includes_that_climb(one("app/main.cpp", "#include \"app/window/demo.h\"\n")), IsEmpty());
}

TEST(Files, AreOpenedInOneFolderAlone) {
  const std::string reads = "  std::ifstream file(path);\n";
  EXPECT_THAT(files_opened_elsewhere(one("app/show/show.cpp", reads)), ElementsAre(StartsWith("app/show/show.cpp:1:")));
  EXPECT_THAT(files_opened_elsewhere(one("engine/anim/pack/pack.cpp", "int f = ::open(path, O_RDONLY);\n")),
              testing::SizeIs(1));
  EXPECT_THAT(files_opened_elsewhere(one("assets/sheet/sheet.cpp", "FILE* f = fopen(path, mode);\n")),
              testing::SizeIs(1));
  EXPECT_THAT(files_opened_elsewhere(one("engine/base/files/input_file.cpp", reads)), IsEmpty());
  EXPECT_THAT(files_opened_elsewhere(one("app/show/show.cpp", "  Status open(const Options& options);\n")), IsEmpty());
}

TEST(Json, IsParsedInOneFileAlone) {
  const std::string parses = "  auto tree = nlohmann::json::parse(text);\n";
  EXPECT_THAT(files_opened_elsewhere(one("engine/anim/import/document.cpp", parses)), testing::SizeIs(1));
  EXPECT_THAT(files_opened_elsewhere(one("engine/base/json/json_tree.h", parses)), IsEmpty());
}

TEST(Room, IsMissedWhereItHasNoFile) {
  EXPECT_THAT(rooms_without_files(one("app/show/stage/stage.h", "")),
              AllOf(Contains(StartsWith("app/window/panel/")), Not(Contains(StartsWith("app/show/stage/")))));
}

TEST(Room, HoldsAtMost60Files) {
  Tree tree;
  for (int i = 0; i < 60; ++i) tree.push_back(source_file("app/show/stage/" + std::to_string(i) + ".h", ""));
  EXPECT_THAT(rooms_too_full(tree), IsEmpty());
  tree.push_back(source_file("app/show/stage/61.h", ""));
  EXPECT_THAT(rooms_too_full(tree), ElementsAre(StartsWith("app/show/stage:61:")));
}

TEST(Floors, LetNobodyOfTheLibraryIncludeTheImporter) {
  const Tree tree = one("engine/anim/asset/clip.cpp", "#include \"engine/anim/import/import.h\"\n");
  EXPECT_THAT(includes_that_climb(tree), testing::SizeIs(1));
}

TEST(Floors, RefuseARoomThatIsNotPlanned) {
  const Tree tree = one("engine/anim/agent/agent.h", "#include \"engine/anim/attic/box.h\"\n");
  EXPECT_THAT(includes_that_climb(tree), testing::SizeIs(1));
}

TEST(Floors, RefuseTheProgramInsideTheEngine) {
  const Tree tree = one("engine/render/camera.cpp", "#  include \"app/settings/settings.h\"\n");
  EXPECT_THAT(includes_that_climb(tree), ElementsAre(HasSubstr("app/settings/settings.h")));
}

TEST(Joint, IsRefusedFromEitherSide) {
  const Tree tree{source_file("engine/render/camera.h", "#include \"engine/anim/base/units.h\"\n"),
                  source_file("engine/anim/lod/lod.h", "#include \"engine/render/camera.h\"\n"),
                  source_file("engine/tracks/read.h", "#include \"engine/render/camera.h\"\n"),
                  source_file("engine/base/text/joined.h", "#include \"engine/anim/base/units.h\"\n"),
                  source_file("engine/crowd/sorted_draws.h",
                              "#include \"throng/render/crowd_batch.h\"\n#include \"throng/render/renderer.h\"\n"),
                  source_file("engine/crowd/examples/drawn_crowd.cpp", "#include \"throng/render/renderer.h\"\n")};
  EXPECT_THAT(includes_that_join(tree), testing::SizeIs(5));
}

TEST(Joint, IsNotThePanel) {
  EXPECT_THAT(includes_that_join(one("app/window/panel/overlay.h", "#include \"app/show/stage/stage.h\"\n")),
              testing::SizeIs(1));
  EXPECT_THAT(includes_that_join(one("app/window/panel/overlay.h", "#include \"app/show/report/frame_report.h\"\n")),
              IsEmpty());
}

TEST(Joint, IsWhatAppIsFor) {
  const Tree tree =
      one("app/show/stage/stage.h", "#include \"engine/anim/lod/lod.h\"\n#include \"engine/render/camera.h\"\n");
  EXPECT_THAT(includes_that_join(tree), IsEmpty());
}

TEST(Parts, AreRefusedWhereTheyAreNotNamed) {
  const Tree tree{source_file("engine/anim/asset/model.cpp", "#include <tiny_gltf.h>\n"),
                  source_file("app/window/demo.cpp", "#include <imgui.h>\n")};
  EXPECT_THAT(parts_seen_elsewhere(tree), testing::SizeIs(2));
}

TEST(Parts, AreSeenWhereTheyAreNamed) {
  const Tree tree{source_file("engine/anim/import/document.h", "#include <tiny_gltf.h>\n"),
                  source_file("app/window/panel/overlay.cpp", "#include <imgui.h>\n")};
  EXPECT_THAT(parts_seen_elsewhere(tree), IsEmpty());
}

TEST(Main, MayNotCompute) {
  EXPECT_THAT(maths_in_main(one("app/main.cpp", "#include <cmath>\n")), testing::SizeIs(1));
  EXPECT_THAT(maths_in_main(one("app/main.cpp", "#include \"engine/anim/lod/lod.h\"\n")), testing::SizeIs(1));
  EXPECT_THAT(maths_in_main(one("app/main.cpp", "const float half = 1 / 2.0F;\n")), testing::SizeIs(1));
}

TEST(Main, MayParseAndDispatch) {
  EXPECT_THAT(maths_in_main(one("app/main.cpp", "#include <variant>\n#include \"app/window/demo.h\"\n")), IsEmpty());
}

TEST(Length, IsRefusedAbove350Lines) {
  const auto lines = [](int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += "int a;\n";
    return text;
  };
  EXPECT_THAT(files_too_long(one("engine/a.cpp", lines(351))), ElementsAre(StartsWith("engine/a.cpp:351:")));
  EXPECT_THAT(files_too_long(one("engine/a.cpp", lines(350))), IsEmpty());
  EXPECT_THAT(files_too_long(one("engine/README.md", lines(351))), IsEmpty());
}

TEST(MachinePath, IsRefusedWhereverItStands) {
  const std::string home =
      "/ho"
      "me/someone/a";
  EXPECT_THAT(machine_paths(one("scripts/demo", "cd " + home + "\n")), ElementsAre(StartsWith("scripts/demo:1:")));
  EXPECT_THAT(machine_paths(one("engine/a.cpp", "open(\"" + home + "\");\n")), testing::SizeIs(1));
}

TEST(MachinePath, IsNotEveryPathWithSuchAFolder) {
  EXPECT_THAT(machine_paths(one("scripts/demo",
                                "cd build/ho"
                                "me/a && cd /usr/share\n")),
              IsEmpty());
}

TEST(Readme, IsMissedInAFolderThatHasNone) {
  const Tree tree{source_file("engine/anim/lod/lod.h", ""), source_file("engine/anim/base/units.h", ""),
                  source_file("engine/anim/base/README.md", ""), source_file("app/show/stage/stage.h", ""),
                  source_file("tests/house/floors.h", "")};
  EXPECT_THAT(folders_without_readme(tree), ElementsAre("app/show/stage", "engine/anim/lod"));
}

TEST(ReadmeProgram, IsRefusedFromTheFirstLineThatDiffers) {
  const auto readme = [](const std::string& code) {
    return source_file("README.md", "# Ours\n\n```cpp\n" + code + "```\n");
  };
  const SourceFile program = source_file("tests/library/readme_program.cpp", "int main() {\n}\n");
  EXPECT_THAT(readme_program_that_differs({readme("int main() {\n}\n"), program}), IsEmpty());
  EXPECT_THAT(readme_program_that_differs({readme("int main() {\n  return 0;\n}\n"), program}),
              ElementsAre(StartsWith("README.md:5: differs")));
  EXPECT_THAT(readme_program_that_differs({readme("int main() {\n"), program}), testing::SizeIs(1));
  EXPECT_THAT(readme_program_that_differs({readme(""), program}), testing::SizeIs(1));
  EXPECT_THAT(readme_program_that_differs({readme("int main() {\n}\n")}), testing::SizeIs(1));
}

TEST(PaperTable, NamesNeitherAFileNorATestThatIsNotThere) {
  const SourceFile test = source_file("tests/anim/player_test.cpp", "TEST(Player, Plays) {\n}\n");
  const SourceFile player = source_file("engine/anim/entity/player.h", "");
  const auto page = [](const std::string& row) { return source_file("engine/anim/README.md", row + "\n"); };
  EXPECT_THAT(
      paper_rows_without_file_or_test({test, player, page("| 2 | plays | `entity/player.h` | `Player.Plays` |")}),
      IsEmpty());
  EXPECT_THAT(
      paper_rows_without_file_or_test({test, player, page("| 2 | plays | `entity/reader.h` | `Player.Plays` |")}),
      ElementsAre("engine/anim/README.md:1: there is no file entity/reader.h"));
  EXPECT_THAT(
      paper_rows_without_file_or_test({test, player, page("| 2 | plays | `entity/player.h` | `Player.Sings` |")}),
      ElementsAre("engine/anim/README.md:1: there is no test Player.Sings"));
  EXPECT_THAT(paper_rows_without_file_or_test({test, player, page("nothing")}), testing::SizeIs(1));
}

}  // namespace
}  // namespace throng::house::house_rules_test
