// Casts with shares, in recordings and out of them.

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "tests/app/program_run.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::replay_cast_test {
namespace {

namespace fs = std::filesystem;
using test::demo;
using test::show_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const fs::path features = fs::path(THRONG_SOURCE_DIR) / "tests/data/features";

class CastShow : public test::RecordedRun {
 protected:
  CastShow() {
    fs::create_directories(folder_ / "people");
    for (const char* const name : {"a.glb", "b.glb"}) {
      fs::copy_file(features / "plain.glb", folder_ / "people" / name);
    }
    std::ofstream(folder_ / "people/broken.glb") << "no glTF";
    std::ifstream stream(features / "data-uri.gltf");
    nlohmann::json clips = nlohmann::json::parse(stream);
    for (const char* const key : {"meshes", "skins", "materials"}) clips.erase(key);
    for (nlohmann::json& node : clips["nodes"]) {
      node.erase("mesh");
      node.erase("skin");
    }
    std::ofstream(folder_ / "people/moves.gltf") << clips.dump();
  }
  std::string people() const { return (folder_ / "people").string(); }
  std::string cast() const { return "--agents 30 --scene grid --cast " + people() + "*2," + plain() + "*3"; }
  static std::string plain() { return (features / "linear-trs.glb").string(); }

  static std::vector<std::ptrdiff_t> members(const Show& show) {
    std::vector<std::ptrdiff_t> members(show.stage().people().size());
    for (const std::uint8_t number : show.stage().crowd().characters()) ++members[number];
    return members;
  }
};

TEST_F(CastShow, HasAsManyAgentsOfEachAsItsShareAsksFor) {
  const auto show = show_of(demo(cast()));
  EXPECT_THAT(members(*show), ElementsAre(6, 6, 18));
  EXPECT_THAT(show->notice(), HasSubstr("broken.glb"));
  EXPECT_TRUE(show->take(SetShare{2, 1.0}));
  EXPECT_THAT(members(*show), ElementsAre(10, 10, 10));
}

TEST_F(CastShow, IsRepeatedWithItsSharesAndTheClipsBesideIt) {
  record(*show_of(demo(cast())), 30, [](Show& show, int frame) {
    if (frame == 10) test::ask(show, SetShare{1, 4.0});
    if (frame == 20) test::change(show, [](Tuning& tuning) { tuning.variety = false; });
  });
  EXPECT_EQ(repeated(""), file_.string() + ": all 30 frames are equal, the last of 30 agents");
}

TEST_F(CastShow, IsRepeatedWhereItWasDropped) {
  record(*show_of(demo("--agents 12 --scene grid")), 20, [this](Show& show, int frame) {
    if (frame != 5) return;
    const std::vector<std::string> dropped{people(), plain()};
    const Status replaced = show.take(LoadModels{dropped});
    EXPECT_TRUE(replaced) << replaced.error().message;
    EXPECT_THAT(members(show), ElementsAre(4, 4, 4));
    EXPECT_THAT(show.notice(), HasSubstr("broken.glb"));
  });
  EXPECT_EQ(repeated(""), file_.string() + ": all 20 frames are equal, the last of 12 agents");
}

TEST_F(CastShow, OfAnotherFolderNamesNobodyThatWasLeftOutBefore) {
  const auto show = show_of(demo(cast()));
  ASSERT_TRUE(show->take(LoadModels{std::vector{plain()}}));
  EXPECT_THAT(show->notice(), testing::Not(HasSubstr("broken.glb")));
}

TEST_F(CastShow, RefusesARecordingWithAShareThatIsNone) {
  record(*show_of(demo(cast())), 2, [](Show&, int) {});
  std::string other = bytes();
  const std::string share = "\"share\":3.0";
  ASSERT_NE(other.find(share), std::string::npos);
  put(test::with_true_checksum(other.replace(other.find(share), share.size(), "\"share\":-3.")));
  EXPECT_THAT(repeated(""), HasSubstr("in its header"));
}

TEST_F(CastShow, IsInTheStatistics) {
  const ProgramRun run = run_program({"--headless=none", "--frames", "1", "--agents", "50", "--scene", "grid", "--cast",
                                      people() + "*2," + plain() + "*3", "--stats", "-"});
  ASSERT_EQ(run.exit_status, 0) << run.errors;
  const nlohmann::json characters = nlohmann::json::parse(run.output).at("characters");
  ASSERT_EQ(characters.size(), 3U);
  EXPECT_EQ(characters[2]["name"], plain());
  EXPECT_EQ(characters[2]["share"], 3.0);
  EXPECT_EQ(characters[2]["agents"], 30);
  EXPECT_EQ(characters[0]["agents"], 10);
  EXPECT_EQ(characters[0]["scale"], 1.0);
  EXPECT_THAT(characters[0]["placement"].get<std::string>(), HasSubstr(" m tall"));
  EXPECT_THAT(run.errors, HasSubstr("broken.glb"));
}

TEST_F(CastShow, MayBeAFolderInPlaceOfAModel) {
  const ProgramRun run = run_program({"--headless=none", "--frames", "1", "--agents", "4", people()});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  const ProgramRun none = run_program({"--headless=none", "--frames", "1", folder_.string()});
  EXPECT_EQ(none.exit_status, 1);
  EXPECT_THAT(none.errors, HasSubstr("the folder holds no .glb, .gltf or .pack file"));
}

}  // namespace
}  // namespace throng::app::replay_cast_test
