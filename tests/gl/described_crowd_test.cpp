// All that is open in a show comes back by a crowd file, by a drop of it on a window, and by the copied command line.
#include "app/show/described_crowd.h"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "app/commands/command_line/options.h"
#include "app/settings/track_values.h"
#include "app/show/camera/fly_camera.h"
#include "app/show/opened_show.h"
#include "app/show/painter.h"
#include "app/show/request/crowd_command.h"
#include "app/show/show_view.h"
#include "app/show/stage/stage.h"
#include "app/window/crowd_editor.h"
#include "app/window/frame_reporter.h"
#include "tests/gl/things_to_open.h"
#include "tests/own_folder.h"
#include "tests/shell_words.h"

namespace throng::app::described_crowd_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr Ticks frame_step = ticks_per_second / 60;
const Words on_this_device{"--headless=osmesa", "--size=96x54"};

DemoOptions options_of(const Words& words) {
  const ParsedCommand command = parse_command_line(words);
  if (const auto* const error = std::get_if<UsageError>(&command)) ADD_FAILURE() << error->message;
  const auto* const options = std::get_if<DemoOptions>(&command);
  return options == nullptr ? DemoOptions() : *options;
}

/// Returns the show of a line. A word that begins with @ is the name of a file of the tests.
std::unique_ptr<Show> show_of(Words words, const Words& device = on_this_device) {
  for (std::string& word : words) {
    if (word.starts_with('@')) word = files().path(word.substr(1));
  }
  StartError error;
  auto show = open_show(options_of(words + device), error);
  EXPECT_NE(show, nullptr) << error.message;
  return show;
}

CrowdSetup described_now(const Show& show) {
  return described(show, {show.stage().tuning(), place_of(show.view().camera)});
}

/// Returns the first picture of a show, and one a tenth of a second later.
std::array<Bytes, 2> pictures_of(Show& show) {
  const auto picture_after = [&show](int frames) {
    for (int frame = 0; frame < frames; ++frame) show.animate(frame_step);
    const Status drawn = show.draw();
    EXPECT_TRUE(drawn) << drawn.error().message;
    return show.painter().renderer().read_image().rgba;
  };
  Bytes first = picture_after(1);
  return {std::move(first), picture_after(6)};
}

/// Shows another crowd for a while, and then opens a crowd file.
void drop(const CrowdSetup& setup, const std::string& file, Show& show) {
  FrameReporter reporter(show);
  CrowdEditor editor(show, reporter);
  Tuning other = show.stage().tuning();
  other.scene = Scene::parade;
  other.agents = 5;
  EXPECT_TRUE(editor.take(SetCast{{ChosenCharacter{.file = files().path("models/two.glb")}}}));
  EXPECT_TRUE(editor.take(Apply{other}));
  for (int frame = 0; frame < 3; ++frame) show.animate(frame_step);
  auto loaded = load(*editor.plan_to_open(setup), [](double, const std::string&) {});
  ASSERT_TRUE(loaded) << loaded.error().message;
  show.take_ahead(std::move(loaded->casts));
  EXPECT_TRUE(editor.open(setup, file, loaded->tracks)) << reporter.messages().all().back().words;
}

/// What is open in a show, and its pictures.
struct Shown {
  CrowdSetup setup;
  std::string command;
  std::array<Bytes, 2> pictures;
};

Shown shown_by(Show& show, const std::function<void(CrowdSetup&)>& kept_by_the_window) {
  Shown shown{.setup = described_now(show), .command = {}, .pictures = {}};
  if (kept_by_the_window) kept_by_the_window(shown.setup);
  shown.command = crowd_command(shown.setup, show.stage().people());
  shown.pictures = pictures_of(show);
  return shown;
}

std::unique_ptr<Show> begun_as(const Kind& kind) {
  auto show = show_of(kind.begun_with);
  if (show == nullptr || !kind.asked) return show;
  for (const CrowdRequest& request : kind.asked(show->stage())) {
    const Status taken = show->take(request);
    EXPECT_TRUE(taken) << taken.error().message;
  }
  return show;
}

void expect_same(const Shown& one, const Shown& other, const std::string& way) {
  EXPECT_EQ(to_json(one.setup).dump(2), to_json(other.setup).dump(2)) << way;
  EXPECT_TRUE(one.pictures[0] == other.pictures[0]) << "another first picture by " << way;
  EXPECT_TRUE(one.pictures[1] == other.pictures[1]) << "another picture after a while by " << way;
}

class WhatIsOpen : public testing::TestWithParam<Kind> {
 protected:
  const throng::test::OwnFolder folder_;
  const std::string file_ = (folder_.path() / "mine.throng").string();
};

TEST_P(WhatIsOpen, ComesBackByFileByDropAndByTheCopiedCommandLine) {
  const auto& kept = GetParam().kept_by_the_window;
  auto show = begun_as(GetParam());
  ASSERT_NE(show, nullptr);
  const Shown open = shown_by(*show, kept);
  ASSERT_TRUE(write_crowd_file(file_, open.setup));
  const auto read = read_crowd_file(file_);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(to_json(*read).dump(2), to_json(open.setup).dump(2));
  const Words pasted = throng::test::words_for_the_program(open.command);
  const auto said = options_of(pasted).crowd;
  EXPECT_EQ(said == nullptr ? TuningPair() : said->pair, open.setup.pair);
  EXPECT_EQ(said == nullptr ? CameraBookmarks() : said->bookmarks, open.setup.bookmarks);

  drop(*read, file_, *show);
  expect_same(shown_by(*show, kept), open, "drop");
  for (const auto& [way, words] : {std::pair(std::string("file"), Words{file_}), std::pair(open.command, pasted)}) {
    show.reset();  // one show has the graphics device at a time
    show = show_of(words);
    ASSERT_NE(show, nullptr) << way;
    expect_same(shown_by(*show, kept), open, way);
  }
}

INSTANTIATE_TEST_SUITE_P(OfCharacters, WhatIsOpen, testing::ValuesIn(kinds_of_characters()), name_of);
INSTANTIATE_TEST_SUITE_P(OfViews, WhatIsOpen, testing::ValuesIn(kinds_of_views()), name_of);

// A new member does not compile here before a kind above and these lines have it.
TEST(WhatCanBeOpen, HasAKindForEachMemberOfASetup) {
  [[maybe_unused]] const auto& [characters, trajectories, preset, camera_name, camera_path, pair, bookmarks] =
      CrowdSetup();
  [[maybe_unused]] const auto& [model, fingerprint, share, clip_files, placement, clips, bones, level_counts, rig,
                                rules] = ChosenCharacter();
  [[maybe_unused]] const auto& [file, reading, start, rate, part, repeats] = TrajectoryOptions();
  [[maybe_unused]] const auto& [fps, times, unit, up, height, angle, walls, lenient] = TrackReading();
  constexpr std::size_t track_members = 5 + 8;
  EXPECT_EQ(track_values().size(), track_members) << "app/settings/track_values.cpp has a row for each";
}

// What a person asks of the crowd is kept, but for what passes.
TEST(WhatCanBeOpen, IsWhatEachRequestAboutTheCrowdChanges) {
  std::set<std::size_t> asked{CrowdRequest(Select()).index(), CrowdRequest(Push()).index(),
                              CrowdRequest(Hold()).index(), CrowdRequest(GoBack()).index()};
  for (const std::vector<Kind>& kinds : {kinds_of_characters(), kinds_of_views()}) {
    for (const Kind& kind : kinds) {
      if (!kind.asked) continue;
      const auto show = show_of(kind.begun_with, {"--headless=none"});
      for (const CrowdRequest& request : kind.asked(show->stage())) asked.insert(request.index());
    }
  }
  EXPECT_EQ(asked.size(), std::variant_size_v<CrowdRequest>) << "a new request needs a kind above, or passes";
}

}  // namespace
}  // namespace throng::app::described_crowd_test
