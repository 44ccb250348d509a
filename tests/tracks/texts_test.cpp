#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tracks/track_file.h"

namespace throng::texts_test {
namespace {

using testing::HasSubstr;

/// Somebody who walks along y: `step` units a frame, with a head at `z`.
std::string walker(double step, double z, int frames = 40) {
  std::string text;
  for (int i = 0; i < frames; ++i) {
    text += "4 " + std::to_string(100 + i) + " 2 " + std::to_string(step * i) +
            (z > 0.0 ? " " + std::to_string(z + (i % 2) * z / 100.0) : "") + "\n";
  }
  return text;
}

TEST(ArchiveText, TakesRateAndUnitFromComments) {
  const auto tracks =
      read_as("a.txt",
              "# PeTrack project: a.pet\n# framerate: 50 fps\n# id frame x/cm y/cm z/cm\n1 100 250 100 175\n"
              "1 101 250 102 176\n2 100 0 0 160\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->format, "text of the Jülich archive");
  EXPECT_EQ(tracks->rows_a_second, 50.0);
  EXPECT_EQ(tracks->persons[0].rows[0].seconds, 2.0);
  EXPECT_NEAR(file_place(*tracks, tracks->persons[0].rows[1]).y, 1.02, 1e-6);
  EXPECT_NEAR(tracks->persons[0].stature, 1.75F, 0.02F);
  EXPECT_EQ(tracks->persons[0].rows[0].y, 0.0F);
}

TEST(ArchiveText, TellsCentimetresByHeads) {
  const auto centimetres = read_as("a.txt", walker(5.0, 175.0));
  ASSERT_TRUE(centimetres) << centimetres.error().message;
  EXPECT_THAT(all_said(*centimetres), HasSubstr("Places are in centimetres: heads are"));
  EXPECT_NEAR(centimetres->persons[0].stature, 1.76F, 0.02F);
  EXPECT_NEAR(file_place(*centimetres, centimetres->persons[0].rows[39]).y, 1.95, 1e-6);
  const auto metres = read_as("a.txt", walker(0.05, 1.75));
  ASSERT_TRUE(metres) << metres.error().message;
  EXPECT_THAT(all_said(*metres), HasSubstr("Places are in metres: heads are"));
}

TEST(ArchiveText, TellsCentimetresBySpeedWhereThereAreNoHeads) {
  const auto centimetres = read_as("a.txt", walker(5.0, 0.0));
  ASSERT_TRUE(centimetres) << centimetres.error().message;
  EXPECT_THAT(all_said(*centimetres), HasSubstr("Places are in centimetres: in metres, people would go 125 m/s"));
  const auto metres = read_as("a.txt", walker(0.05, 0.0));
  ASSERT_TRUE(metres) << metres.error().message;
  EXPECT_THAT(all_said(*metres), HasSubstr("Places are taken as metres"));
}

TEST(ArchiveText, TakesSixteenFramesASecondWherePeopleWouldRunWithTwentyFive) {
  const auto slow = read_as("a.txt", walker(0.05, 1.7));
  const auto fast = read_as("a.txt", walker(0.09, 1.7));
  ASSERT_TRUE(slow && fast);
  EXPECT_DOUBLE_EQ(slow->rows_a_second, 25.0);
  EXPECT_DOUBLE_EQ(fast->rows_a_second, 16.0);
  EXPECT_THAT(all_said(*fast), HasSubstr("does not say its frame rate: 16 a second are taken"));
  const auto told = read_as("a.txt", walker(0.09, 1.7), {.fps = 30.0});
  ASSERT_TRUE(told);
  EXPECT_NEAR(told->rows_a_second, 30.0, 1e-6);
}

TEST(ArchiveText, SaysThatHeightsCannotBeThoseOfHeads) {
  const auto tracks = read_as("a.txt", "# framerate: 25\n# id frame x/m y/m z/m\n1 0 0 0 4.5\n1 1 0 0.04 4.5\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_THAT(all_said(*tracks), HasSubstr("z cannot be the height of heads"));
  EXPECT_EQ(tracks->persons[0].stature, 0.0F);
  EXPECT_EQ(tracks->persons[0].rows[0].y, 4.5F);
}

TEST(ArchiveText, ReadsWhatJuPedSimWroteAsText) {
  const auto tracks = read_as("a.txt",
                              "# description: my simulation\n# framerate: 8.00\n# geometry: geo.xml\n"
                              "#ID\tFR\tX\tY\tZ\tA\tB\tANGLE\tCOLOR\n"
                              "1\t0\t1\t2\t0\t0.3\t0.25\t0\t255\n1\t8\t2\t2\t0\t0.3\t0.25\t0\t255\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->format, "JuPedSim text");
  EXPECT_EQ(tracks->persons[0].rows[1].seconds, 1.0);
  EXPECT_EQ(tracks->persons[0].stature, 0.0F);
  EXPECT_NEAR(tracks->persons[0].rows[0].heading, std::numbers::pi / 2.0, 1e-6);
}

/// Five people in rows of the frame, the id and the place; they walk 0.5 a row, 2 apart. Ids and frames are as apart as
/// `between` says.
std::string frame_first(int between, std::string_view separator) {
  std::string text;
  for (int frame = 0; frame < 12; ++frame) {
    for (int person = 0; person < 5; ++person) {
      if (frame < person) continue;
      for (const double number : {780.0 + between * frame, 1.0 + person, 0.5 * frame, 2.0 * person}) {
        text += std::to_string(number) + std::string(separator);
      }
      text.back() = '\n';
    }
  }
  return text;
}

TEST(FrameFirst, IsToldByWhoseRowsFollowEachOtherNearBy) {
  const auto tracks = read_as("biwi_eth.txt", frame_first(10, "\t"));
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->format, "text with the frame first, as of ETH/UCY");
  ASSERT_EQ(tracks->persons.size(), 5U);
  EXPECT_EQ(tracks->persons[0].id, "1");
  EXPECT_EQ(tracks->persons[0].rows.size(), 12U);
  EXPECT_NEAR(tracks->rows_a_second, 2.5, 1e-9);
  EXPECT_NEAR(file_place(*tracks, tracks->persons[0].rows[3]).x, 1.5, 1e-6);
  const auto every_frame = read_as("a.txt", frame_first(1, " "));
  ASSERT_TRUE(every_frame) << every_frame.error().message;
  EXPECT_EQ(every_frame->persons.size(), 5U);
  EXPECT_GT(every_frame->rows_a_second, 15.0);
}

TEST(FrameFirst, IsNotTakenWhereTheIdIsFirst) {
  for (const std::string& text :
       std::vector<std::string>{walker(0.05, 0.0), "5 1 0 0\n5 2 0.1 0\n6 1 3 0\n6 2 3.1 0\n", "1 100 0 0\n"}) {
    const auto tracks = read_as("a.txt", text);
    ASSERT_TRUE(tracks) << tracks.error().message;
    EXPECT_EQ(tracks->format, "text of the Jülich archive") << text;
  }
}

TEST(FourNumbers, HaveSecondsWhereTimesAreNotWhole) {
  const auto tracks = read_as("a.txt", "7 0.0 0 0\n7 0.4 0.5 0\n7 0.8 1 0\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_NEAR(tracks->last_seconds, 0.8, 1e-9);
}

TEST(StreetMatrix, HasHeightsBetweenXAndYAndARowEveryFortyHundredths) {
  const auto tracks = read_as("obsmat.txt",
                              "   7.0e+00   1.0e+00  -2.5e+00   0.0e+00   5.0e+00   6.0e-02   0.0e+00  -1.1e+00   \n"
                              "   1.7e+01   1.0e+00  -2.0e+00   0.0e+00   4.0e+00   6.0e-02   0.0e+00  -1.1e+00   \n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->format, "ETH/UCY matrix (obsmat)");
  EXPECT_EQ(tracks->persons[0].id, "1");
  EXPECT_DOUBLE_EQ(tracks->rows_a_second, 2.5);
  EXPECT_EQ(tracks->persons[0].rows[0].seconds, 0.28);
  EXPECT_EQ(file_place(*tracks, tracks->persons[0].rows[1]), glm::dvec2(-2.0, 4.0));
  EXPECT_THAT(all_said(*tracks), HasSubstr("25.0 frames are a second"));
  EXPECT_TRUE(read_as("obsmat.txt", "1 1 0 0 0 1 0\n11 1 1 0 0 1 0\n"));
}

TEST(Ndjson, ReadsTrajnetWithItsScenes) {
  const auto tracks =
      read_as("a.ndjson",
              "{\"scene\": {\"id\": 0, \"p\": 5, \"s\": 0, \"e\": 20, \"fps\": 2.0, \"tag\": [1, []]}}\n"
              "{\"track\": {\"f\": 0, \"p\": 5, \"x\": 1.25, \"y\": -2}}\n"
              "{\"track\": {\"f\": 10, \"p\": 5, \"x\": 2, \"y\": -2}}\n"
              "{\"track\": {\"f\": 10, \"p\": 5, \"x\": 9, \"y\": 9, \"prediction_number\": 0}}\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->format, "trajnet ndjson");
  ASSERT_EQ(tracks->row_count, 2U);
  EXPECT_EQ(tracks->persons[0].id, "5");
  EXPECT_DOUBLE_EQ(tracks->rows_a_second, 2.0);
  EXPECT_EQ(file_place(*tracks, tracks->persons[0].rows[0]), glm::dvec2(1.25, -2.0));
  EXPECT_EQ(file_place(*tracks, tracks->persons[0].rows[1]), glm::dvec2(2.0, -2.0));
}

TEST(Ndjson, TakesTheIdOfWhoHasANameToo) {
  const auto tracks = read_as("a.jsonl",
                              "{\"id\": 1, \"name\": \"Max\", \"time\": 0, \"x\": 1, \"y\": 2}\n"
                              "{\"name\": \"Max\", \"id\": 2, \"time\": 0, \"x\": 9, \"y\": 2}\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  ASSERT_EQ(tracks->persons.size(), 2U);
  EXPECT_EQ(tracks->persons[0].id, "1");
  EXPECT_EQ(tracks->persons[1].id, "2");
}

TEST(Ndjson, ReadsRowsWithOtherNames) {
  const auto tracks =
      read_as("a.jsonl",
              "{\"time\": 0.5, \"agent\": \"ann\", \"pos_x\": 1, \"pos_y\": 2, \"tags\": {\"a\": [1]}}\n"
              "{\"time\": 1.0, \"agent\": \"ann\", \"pos_x\": 1.5, \"pos_y\": 2}\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->persons[0].id, "ann");
  EXPECT_EQ(tracks->persons[0].rows[0].seconds, 0.5);
}

constexpr const char* fcd_head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- made by SUMO -->\n<fcd-export>\n";

TEST(Fcd, ReadsPeopleAndTurnsAnglesFromNorth) {
  const auto tracks =
      read_as("fcd.xml",
              std::string(fcd_head) +
                  "<timestep time=\"0.00\"><vehicle id=\"car\" x=\"50\" y=\"50\" angle=\"0\"/>"
                  "<person id=\"p&amp;1\" x=\"1\" y=\"2\" z=\"0.5\" angle=\"90\" speed=\"1\"/></timestep>\n"
                  "<timestep time=\"1.00\"><person id=\"p&amp;1\" x=\"2\" y=\"2\" z=\"0.5\" angle=\"0\"/></timestep>\n"
                  "</fcd-export>\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->format, "SUMO FCD");
  ASSERT_EQ(tracks->persons.size(), 1U);
  EXPECT_EQ(tracks->persons[0].id, "p&1");
  EXPECT_EQ(tracks->persons[0].rows[0].y, 0.5F);
  EXPECT_NEAR(tracks->persons[0].rows[0].heading, std::numbers::pi / 2.0, 1e-6);      // east
  EXPECT_NEAR(std::abs(tracks->persons[0].rows[1].heading), std::numbers::pi, 1e-6);  // north is -Z
}

TEST(Fcd, MayEndEarlyWhereRowsMayBeSkipped) {
  const std::string text = std::string(fcd_head) +
                           "<timestep time=\"0.00\"><person id=\"a\" x=\"1\" y=\"2\"/></timestep>\n"
                           "<timestep time=\"1.00\"><person id=\"a\" x=\"2\" y=\"2\"/><person id=\"b\" x=";
  EXPECT_THAT(error_of("a.xml", text), HasSubstr("or take what is there with --lenient"));
  const auto tracks = read_as("a.xml", text, {.lenient = true});
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->row_count, 2U);
  EXPECT_THAT(all_said(*tracks), HasSubstr("The file ends early, in line 5; its rows up to there are read."));
  EXPECT_FALSE(read_as("a.xml", "<fcd-export></timestep>", {.lenient = true}));
}

TEST(Fcd, ForgetsManyVehiclesWhenTheFirstPersonComes) {
  std::string text = std::string(fcd_head) + "<timestep time=\"0\">\n";
  for (int i = 0; i < 10'000; ++i)
    text += "<vehicle id=\"v" + std::to_string(i) + "\" x=\"50\" y=\"50\" angle=\"0\"/>\n";
  text +=
      "<person id=\"a\" x=\"1\" y=\"2\" angle=\"0\"/>\n<vehicle id=\"late\" x=\"5\" y=\"5\"/></timestep></fcd-export>";
  const auto tracks = read_as("fcd.xml", text);
  ASSERT_TRUE(tracks) << tracks.error().message;
  ASSERT_EQ(tracks->persons.size(), 1U);
  EXPECT_EQ(tracks->row_count, 1U);
}

TEST(Fcd, ReadsVehiclesWhereThereAreNoPeople) {
  const auto xml =
      read_as("fcd.xml", std::string(fcd_head) +
                             "<timestep time=\"0\"><vehicle id=\"a\" x=\"0\" y=\"0\" angle=\"90\"/></timestep>"
                             "</fcd-export>");
  ASSERT_TRUE(xml) << xml.error().message;
  EXPECT_EQ(xml->format, "SUMO FCD of vehicles");
  const auto table =
      read_as("fcd.csv",
              "timestep_time;person_angle;person_id;person_x;person_y;vehicle_angle;vehicle_id;vehicle_x;"
              "vehicle_y\n0.00;;;;;\n0.50;;;;;90;v0;3;4\n");
  ASSERT_TRUE(table) << table.error().message;
  EXPECT_EQ(table->format, "SUMO FCD table of vehicles");
  EXPECT_EQ(table->persons[0].id, "v0");
}

TEST(Fcd, ReadsPeopleOfATable) {
  const auto tracks =
      read_as("fcd.csv",
              "timestep_time;vehicle_angle;vehicle_id;vehicle_x;vehicle_y;person_angle;person_id;person_x;"
              "person_y\n0.00;0;car;9;9;;;;\n0.00;;;;;90;ann;1;2\n1.00;;;;;90;ann;2;2\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->format, "SUMO FCD table");
  ASSERT_EQ(tracks->persons.size(), 1U);
  EXPECT_EQ(tracks->persons[0].rows.size(), 2U);
  EXPECT_NEAR(tracks->persons[0].rows[0].heading, std::numbers::pi / 2.0, 1e-6);
}

constexpr const char* vadere_rows =
    "#IDXCOL=2,DATACOL=6,SEP=' '\n"
    "pedestrianId simTime endTime-PID1 startX-PID1 startY-PID1 endX-PID1 endY-PID1 targetId-PID2\n"
    "1 0.4 1.0 2.0 7.0 2.0 6.5 8\n1 1.0 1.5 2.0 6.5 2.0 6.0 8\n";

TEST(Viswalk, ReadsATableBelowItsComments) {
  const auto tracks = read_as("a.pp",
                              "\xEF\xBB\xBF$VISION\r\n* File: C:\\Station.inpx\r\n* Comment: 1;2;3\r\n*\r\n"
                              "* No;SimSec;CoordCentX;CoordCentY\r\n$PEDESTRIAN:NO;SIMSEC;COORDCENTX;COORDCENTY\r\n"
                              "3;0.20;1.5;2.5\r\n3;0.40;1.7;2.5\r\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  ASSERT_EQ(tracks->persons.size(), 1U);
  EXPECT_EQ(tracks->persons[0].id, "3");
  EXPECT_NEAR(tracks->persons[0].rows[0].seconds, 0.2, 1e-9);
  EXPECT_EQ(error_of("a.pp", "$VISION\n* x\n$PEDESTRIAN:NO;SIMSEC;COORDCENTX;COORDCENTY\n3;0.2;a;2\n"),
            "a.pp: line 4: \"a\" is not a number; put x in metres there, or skip such rows with --lenient");
}

TEST(Vadere, ReadsBothEndsOfStepsAndTheScenarioBesideThem) {
  const TrackFolder folder;
  folder.file(
      "run.scenario",
      "{\"scenario\": {\"topography\": {\"attributes\": {\"bounds\": {\"x\": 0, \"y\": 0, \"width\": 8, "
      "\"height\": 10}, \"boundingBoxWidth\": 0.5, \"bounded\": true}, \"obstacles\": [{\"shape\": {\"type\": "
      "\"POLYGON\", \"points\": [{\"x\": 1, \"y\": 1}, {\"x\": 2, \"y\": 1}, {\"x\": 2, \"y\": 2}]}}, {\"shape\": "
      "{\"type\": \"RECTANGLE\", \"x\": 3, \"y\": 3, \"width\": 1, \"height\": 2}}], \"targets\": [{\"shape\": "
      "{\"x\": 6, \"y\": 1, \"width\": 1, \"height\": 1, \"type\": \"RECTANGLE\"}}]}}}");
  const auto tracks = read_trajectories(folder.file("postvis.traj", vadere_rows), {});
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->format, "Vadere");
  ASSERT_EQ(tracks->persons.size(), 1U);
  ASSERT_EQ(tracks->persons[0].rows.size(), 3U);
  EXPECT_EQ(tracks->persons[0].rows[2].seconds, 1.5);
  EXPECT_EQ(file_place(*tracks, tracks->persons[0].rows[2]), glm::dvec2(2.0, 6.0));
  EXPECT_EQ(found(*tracks, TrackOddity::duplicate), 0U);
  EXPECT_EQ(tracks->plan.obstacles.size(), 2U);
  EXPECT_EQ(tracks->plan.exits.size(), 1U);
  ASSERT_EQ(tracks->plan.floors.size(), 1U);
  const glm::vec2 corner = tracks->plan.floors[0].outline[0];
  EXPECT_EQ(tracks->origin.x + static_cast<double>(corner.x), 0.5);
  EXPECT_EQ(tracks->origin.y - static_cast<double>(corner.y), 0.5);
}

TEST(Vadere, TakesStepsWithoutTheirEndsAsRows) {
  const auto tracks =
      read_as("a.traj", "pedestrianId simTime endTime-PID1 startX-PID1 startY-PID1\n1 1 2 3 4\n1 2 3 3 5\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  ASSERT_EQ(tracks->row_count, 2U);
  EXPECT_EQ(file_place(*tracks, tracks->persons[0].rows[1]), glm::dvec2(3.0, 5.0));
}

TEST(Vadere, ReadsRowsOfSteps) {
  const auto tracks = read_as("a.traj", "timeStep pedestrianId x-PID1 y-PID1\n1 1 2.0 3.0\n2 1 2.5 3.0\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_DOUBLE_EQ(tracks->rows_a_second, 2.5);
}

}  // namespace
}  // namespace throng::texts_test
