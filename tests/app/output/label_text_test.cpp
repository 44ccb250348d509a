#include "app/output/label_text.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"
#include "tests/app/temporary_folder.h"

namespace throng::app::label_text_test {
namespace {

using nlohmann::json;

LabelFrame frame_of_one() {
  LabelFrame frame;
  frame.number = 12;
  frame.seconds = 0.2;
  frame.size = {640, 360};
  frame.metres_a_step = 0.002;
  frame.camera = LabelCamera(render::view_of({}, 640.0F / 360.0F), frame.size);
  LabelledPerson& person = frame.people.emplace_back();
  person.agent = 7;
  person.id = "the \"first\"";
  person.role = "walk";
  person.clip = "Walking_A";
  person.box = {10, 20, 30, 60};
  person.whole_box = {0, 20, 30, 61};
  person.share_visible = 0.75;
  person.position = {1.0F, -0.00001F, 2.5F};
  person.joints = {{{0.5F, 1.0F, 2.0F}, {320.25F, 100.0F}, Seen::visible}, {}};
  return frame;
}

TEST(LineOfAFrame, IsJsonWithTheKeysThatTheReadmeHas) {
  const json line = json::parse(line_of(frame_of_one()));
  EXPECT_EQ(line.at("frame"), 12);
  EXPECT_EQ(line.at("time"), 0.2);
  EXPECT_FALSE(line.contains("file_time"));
  EXPECT_EQ(line.at("size"), json({640, 360}));
  EXPECT_EQ(line.at("mask"), "mask_000012.png");
  EXPECT_EQ(line.at("depth"), "depth_000012.png");
  EXPECT_EQ(line.at("depth_step"), 0.002);
  const json& person = line.at("people").at(0);
  EXPECT_EQ(person.at("id"), "the \"first\"");
  EXPECT_EQ(person.at("label"), 8);
  EXPECT_EQ(person.at("role"), "walk");
  EXPECT_EQ(person.at("clip"), "Walking_A");
  EXPECT_EQ(person.at("box"), json({10, 20, 20, 40}));
  EXPECT_EQ(person.at("whole_box"), json({0, 20, 30, 41}));
  EXPECT_EQ(person.at("visible"), 0.75);
  EXPECT_EQ(person.at("cut_off"), true);
  EXPECT_EQ(person.at("position"), json({1, 0, 2.5}));
  EXPECT_EQ(person.at("joints"), json::parse("[[0.5,1,2,320.25,100,2],[0,0,0,0,0,0]]"));
  EXPECT_EQ(person.at("coco").size(), 17U);
  std::ifstream readme(THRONG_SOURCE_DIR "/app/output/README.md");
  const std::string page{std::istreambuf_iterator<char>(readme), {}};
  for (const json& keys : {line, person}) {
    for (const auto& [key, value] : keys.items()) EXPECT_THAT(page, testing::HasSubstr("`" + key)) << key;
  }
}

TEST(LineOfAFrame, HasACameraThatPutsWhatIsAheadIntoTheMiddle) {
  const LabelFrame frame = frame_of_one();
  const json camera = json::parse(line_of(frame)).at("camera");
  const render::Camera taken;
  const glm::vec3 ahead = taken.position + 10.0F * render::forward(taken);
  std::array<double, 3> seen{}, pixel{};
  for (std::size_t row = 0; row < 3; ++row) {
    const json& numbers = camera.at("world_to_camera").at(row);
    for (std::size_t column = 0; column < 4; ++column) {
      const double place = column < 3 ? static_cast<double>(ahead[static_cast<int>(column)]) : 1.0;
      seen.at(row) += numbers.at(column).get<double>() * place;
    }
  }
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      pixel.at(row) += camera.at("K").at(row).at(column).get<double>() * seen.at(column);
    }
  }
  EXPECT_NEAR(pixel[0] / pixel[2], 320, 0.01);
  EXPECT_NEAR(pixel[1] / pixel[2], 180, 0.01);
  EXPECT_NEAR(pixel[2], 10, 1e-3);
  EXPECT_EQ(camera.at("world_to_camera").at(3), json({0, 0, 0, 1}));
}

TEST(ConventionsOfLabels, NameTheJointsOfEachCharacter) {
  const auto show = test::show_of(test::demo("--agents 2"));
  const LabelMaker maker(show->stage());
  const json all = json::parse(label_conventions(show->stage().characters(), maker.coco()).dump());
  EXPECT_EQ(all.at("coco").size(), 17U);
  EXPECT_EQ(all.at("coco_guessed"), 5);
  const json& character = all.at("characters").at(0);
  EXPECT_EQ(character.at("joints").size(), show->stage().characters().front().character->skeleton.bones.size());
  EXPECT_EQ(character.at("parents").size(), character.at("joints").size());
  EXPECT_EQ(character.at("parents").at(0), -1);
  EXPECT_THAT(character.at("joints"), testing::Contains(character.at("coco_bones").at(5)));
  EXPECT_EQ(all.at("characters").back().at("is_thing"), true);
}

class IdsOfLabels : public test::TemporaryFolder {};

TEST_F(IdsOfLabels, AreThoseOfTheFileOfARecordedCrowd) {
  const std::string file = (folder_ / "people.csv").string();
  std::ofstream(file) << "id,time,x,y\nb9,0,0,0\na7,0,3,0\nb9,1,1,0\na7,1,4,0\n";
  const auto show = test::show_of(test::demo("--trajectories " + file));
  EXPECT_EQ(id_of_agent(show->stage(), 0), "b9");
  EXPECT_EQ(id_of_agent(show->stage(), 1), "a7");
  EXPECT_EQ(id_of_agent(test::show_of(test::demo("--agents 2"))->stage(), 1), "1");
}

}  // namespace
}  // namespace throng::app::label_text_test
