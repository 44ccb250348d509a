#include "app/show/recording/recording.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/show/recording/reader.h"
#include "app/show/recording/writer.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::recording_test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::uint64_t high_bits(std::uint64_t hash) { return hash << 48U; }

ChosenCharacter person() {
  return {.file = "person.glb",
          .fingerprint = "0123456789abcdef",
          .share = 0.75,
          .clip_files = {"walks.glb"},
          .placement = {.scale = 0.01, .up = anim::UpAxis::z, .ground = anim::GroundRule::feet},
          .clips = {{Role::walk, "Walking_A"}, {Role::wave, no_clip_name}},
          .bones = {"hips", "head"},
          .level_counts = {2, 1},
          .rig = {{anim::BodyRole::left_foot, "ankle \"l\""}},
          .rules = "{\"version\":1}"};
}

RoleClips clips() {
  RoleClips clips = no_clips();
  clips[2] = 7;
  return clips;
}

RecordingHeader header() {
  RecordingHeader header{.characters = {person()}, .tuning = {}, .width = 640, .height = 360};
  header.tuning.agents = 3;
  header.tuning.system.cost.tile = 99.5;
  return header;
}

RecordedFrame frame(Ticks delta) {
  return {.delta = delta,
          .view = {.camera = {.position = {1.5F, 2.0F, -3.0F}, .yaw = 0.1F}, .width = 640, .height = 360},
          .pose_hash = 77};
}

template <typename Asked>
Asked asked(RecordingReader& reader) {
  return std::get<Asked>(std::get<CrowdRequest>(*reader.next()));
}

class Recordings : public test::TemporaryFolder {
 protected:
  /// Two frames of three agents, with one of everything between them.
  void write_recording() const {
    auto writer = RecordingWriter::create(file_, header());
    ASSERT_TRUE(writer) << writer.error().message;
    (*writer)->add(frame(Ticks{10}), std::vector{high_bits(1), high_bits(2), high_bits(3)});
    Tuning tuning = header().tuning;
    tuning.agents = 2;
    tuning.time_scale = 0.3F;
    const std::vector<CrowdRequest> requests{
        Apply{tuning},
        Select{1},
        Select{},
        Push{.agent = 1, .direction = {0.25F, 0.1F, -1.0F}},
        SetRoles{.character = 0, .clips = clips()},
        Hold{.agent = 2, .seconds = 0.7F},
        Hold{},
        GoBack{3},
        SetShare{.character = 1, .share = 1.0 / 3.0},
        SetBones{.character = 0, .choice = {.bones = {1, 0}, .level_counts = {2, 1}}},
        SetBody{.character = 0, .parts = person().rig},
        SetPlacement{.character = 0, .choice = person().placement},
        SetRules{.character = 0, .rules = "", .file = "none.cast.json"},
        SetCast{{person(), person()}}};
    for (const CrowdRequest& request : requests) (*writer)->add(request);
    (*writer)->add(frame(Ticks{}), std::vector{high_bits(1), high_bits(9)});
    ASSERT_TRUE((*writer)->finish());
  }

  std::string bytes() const {
    std::ifstream stream(file_, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void put(const std::string& contents) const { std::ofstream(file_, std::ios::binary) << contents; }

  /// Reads to the end, or to what is wrong.
  std::string complaint() const {
    const auto reader = RecordingReader::open(file_);
    if (!reader) return reader.error().message;
    for (;;) {
      const auto item = (*reader)->next();
      if (!item) return item.error().message;
      if (std::holds_alternative<RecordedEnd>(*item)) return "(all read)";
    }
  }

  fs::path file_ = folder_ / "run.rec";
};

TEST_F(Recordings, ReadBackAsTheyWereWritten) {
  write_recording();
  const auto opened = RecordingReader::open(file_);
  ASSERT_TRUE(opened) << opened.error().message;
  RecordingReader& reader = **opened;
  EXPECT_EQ(reader.header().tuning, header().tuning);
  EXPECT_EQ(reader.header().characters, header().characters);
  EXPECT_EQ(reader.header().height, 360);

  const auto first = std::get<RecordedFrame>(*reader.next());
  EXPECT_EQ(first.delta, Ticks{10});
  EXPECT_EQ(first.view.camera, frame(Ticks{10}).view.camera);
  EXPECT_EQ(first.pose_hash, 77U);
  EXPECT_THAT(reader.agent_hashes(), ElementsAre(1, 2, 3));

  Tuning tuning = header().tuning;
  tuning.agents = 2;
  tuning.time_scale = 0.3F;
  EXPECT_EQ(asked<Apply>(reader).tuning, tuning);
  EXPECT_EQ(asked<Select>(reader).agent, 1U);
  EXPECT_EQ(asked<Select>(reader).agent, std::nullopt);
  EXPECT_EQ(asked<Push>(reader).direction, glm::vec3(0.25F, 0.1F, -1.0F));
  EXPECT_EQ(asked<SetRoles>(reader).clips, clips());
  const auto held = asked<Hold>(reader);
  EXPECT_EQ(held.agent, 2U);
  EXPECT_EQ(held.seconds, 0.7F);
  EXPECT_EQ(asked<Hold>(reader).agent, std::nullopt);
  EXPECT_EQ(asked<GoBack>(reader).moment, 3U);
  EXPECT_EQ(asked<SetShare>(reader).share, 1.0 / 3.0);
  const auto order = asked<SetBones>(reader);
  EXPECT_THAT(order.choice.bones, ElementsAre(1, 0));
  EXPECT_THAT(order.choice.level_counts, ElementsAre(2, 1));
  EXPECT_EQ(asked<SetBody>(reader).parts, person().rig);
  EXPECT_EQ(asked<SetPlacement>(reader).choice, person().placement);
  const auto rules = asked<SetRules>(reader);
  EXPECT_EQ(rules.rules, "");
  EXPECT_EQ(rules.file, "none.cast.json");
  EXPECT_THAT(asked<SetCast>(reader).characters, ElementsAre(person(), person()));
  EXPECT_EQ(std::get<RecordedFrame>(*reader.next()).delta, Ticks{});
  EXPECT_THAT(reader.agent_hashes(), ElementsAre(1, 9));
  EXPECT_EQ(std::get<RecordedEnd>(*reader.next()).frames, 2U);
}

TEST_F(Recordings, AreNotThereUntilTheyAreWhole) {
  auto writer = RecordingWriter::create(file_, header());
  ASSERT_TRUE(writer);
  (*writer)->add(frame(Ticks{10}), std::vector{high_bits(1)});
  EXPECT_FALSE(fs::exists(file_));
  ASSERT_TRUE((*writer)->finish());
  EXPECT_TRUE(fs::exists(file_));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(Recordings, OfARunThatCrashedStayBesideAndSayHowFarTheyGo) {
  {
    auto writer = RecordingWriter::create(file_, header());
    ASSERT_TRUE(writer);
    (*writer)->add(frame(Ticks{10}), std::vector{high_bits(1)});
  }
  file_ = fs::directory_iterator(folder_)->path();
  EXPECT_EQ(file_.extension(), ".part");
  EXPECT_THAT(complaint(), HasSubstr("is cut short after frame 1"));
}

TEST_F(Recordings, AreRefusedWhereTheyCannotBeWritten) {
  EXPECT_THAT(RecordingWriter::create(folder_ / "none" / "run.rec", header()).error().message,
              HasSubstr("cannot be written"));
  EXPECT_THAT(RecordingWriter::create(folder_, header()).error().message, HasSubstr("it is a folder"));
}

TEST_F(Recordings, OfAnotherKindAreRefusedInWords) {
  EXPECT_THAT(complaint(), HasSubstr("run.rec: there is no such file"));
  put("");
  EXPECT_THAT(complaint(), HasSubstr("is no recording of throng"));
  put(std::string(1000, 'x'));
  EXPECT_THAT(complaint(), HasSubstr("is no recording of throng"));
  write_recording();
  std::string other = bytes();
  other[recording_magic.size()] = 9;
  put(other);
  EXPECT_THAT(complaint(), HasSubstr("is a recording of version 9; this throng reads version 4"));
}

TEST_F(Recordings, CutShortAnywhereSaySo) {
  write_recording();
  const std::string whole = bytes();
  EXPECT_EQ(complaint(), "(all read)");
  for (std::size_t length = recording_magic.size() + 4; length < whole.size(); ++length) {
    put(whole.substr(0, length));
    EXPECT_THAT(complaint(), testing::AnyOf(HasSubstr("is cut short"), HasSubstr("is no recording"))) << length;
  }
}

TEST_F(Recordings, WithBytesBehindTheEndAreRefused) {
  write_recording();
  put(bytes() + "x");
  EXPECT_THAT(complaint(), HasSubstr("frame 3: is damaged"));
}

TEST_F(Recordings, WithAnyByteDamagedAreRefusedBeforeTheirFirstFrame) {
  write_recording();
  const std::string whole = bytes();
  constexpr std::size_t end_head = 5 + 8 + 8;  // a damaged head of the end looks like a recording that was cut short
  for (std::size_t byte = 0; byte < whole.size(); byte += 3) {
    std::string damaged = whole;
    damaged[byte] = static_cast<char>(damaged[byte] ^ 0x20);
    put(damaged);
    const std::string words = complaint();
    EXPECT_TRUE(words.starts_with(file_.string() + ": ")) << byte << ": " << words;
    EXPECT_EQ(words.find('\n'), std::string::npos) << byte;
    const bool in_head_of_end = byte >= whole.size() - end_head && byte < whole.size() - end_head + 5;
    EXPECT_TRUE(in_head_of_end || !RecordingReader::open(file_)) << byte;
  }
}

// Whatever is read is in range or refused, also where the checksum is right: a flipped bit ends in the whole file, or
// in one line that names the file.
TEST_F(Recordings, WithABitFlippedAndTheChecksumMendedAreReadOrRefused) {
  write_recording();
  const std::string whole = bytes();
  for (std::size_t bit = 0; bit < whole.size() * 8; bit += 11) {
    std::string flipped = whole;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
    put(test::with_true_checksum(flipped));
    const std::string words = complaint();
    EXPECT_TRUE(words == "(all read)" || words.starts_with(file_.string() + ": ")) << bit << ": " << words;
    EXPECT_EQ(words.find('\n'), std::string::npos) << bit;
  }
}

}  // namespace
}  // namespace throng::app::recording_test
