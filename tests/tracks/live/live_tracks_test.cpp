#include "engine/tracks/live/live_tracks.h"

#include <chrono>
#include <cmath>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace throng::live_test {
namespace {

using testing::HasSubstr;

/// A pipe whose other end a LiveTracks reads.
class Feed {
 public:
  explicit Feed(const TrackReading& options = {}) : live_(open(), options) {}
  ~Feed() { end(); }
  Feed(const Feed&) = delete;
  Feed& operator=(const Feed&) = delete;

  void send(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t count = write(ends_[1], text.data(), text.size());
      if (count <= 0) return;
      text.remove_prefix(static_cast<std::size_t>(count));
    }
  }
  void end() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }
  /// Waits until so many rows came, or the end.
  bool wait_for(std::size_t count) {
    bool goes_on = true;
    for (int i = 0; i < 20'000 && goes_on && rows.size() < count; ++i) {
      goes_on = live_.take(rows);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return goes_on;
  }
  /// Waits for the end.
  void wait() {
    while (live_.take(rows)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const LiveTracks& live() const { return live_; }

  std::vector<LiveRow> rows;

 private:
  int open() { return pipe(ends_) == 0 ? ends_[0] : -1; }

  int ends_[2] = {-1, -1};
  LiveTracks live_;
};

TEST(Live, GivesAPersonFromItsFirstRow) {
  Feed feed;
  std::vector<LiveRow> none;
  EXPECT_TRUE(feed.live().status());
  EXPECT_FALSE(feed.live().head());
  feed.send("id,time,x,y\nann,0.5,10.25,");
  feed.send("20\n");
  ASSERT_TRUE(feed.wait_for(1));
  ASSERT_EQ(feed.rows.size(), 1U);
  EXPECT_EQ(feed.live().id(feed.rows[0].person), "ann");
  ASSERT_TRUE(feed.live().head());
  EXPECT_EQ(feed.live().head()->origin, glm::dvec2(10.0, 20.0));
  EXPECT_EQ(feed.rows[0].row.x, 0.25F);
  EXPECT_EQ(feed.rows[0].row.seconds, 0.5);
  feed.send("bob,0.5,11,21\nann,1,10.5,20\n");
  ASSERT_TRUE(feed.wait_for(3));
  EXPECT_EQ(feed.live().id(feed.rows[1].person), "bob");
  EXPECT_EQ(feed.rows[1].row.z, -1.0F);
  feed.end();
  feed.wait();
  EXPECT_TRUE(feed.live().status());
}

TEST(Live, ReadsTheTextOfTheArchiveWithHeads) {
  Feed feed;
  feed.send("# framerate: 10 fps\n# id frame x/cm y/cm z/cm\n1 10 100 200 175\n");
  ASSERT_TRUE(feed.wait_for(1));
  EXPECT_EQ(feed.rows[0].row.seconds, 1.0);
  EXPECT_FLOAT_EQ(feed.rows[0].stature, 1.75F);
  EXPECT_EQ(feed.rows[0].row.y, 0.0F);
  EXPECT_EQ(feed.live().head()->origin, glm::dvec2(1.0, 2.0));
}

TEST(Live, ReadsJsonLinesAndXml) {
  Feed json;
  json.send("{\"track\": {\"f\": 25, \"p\": 3, \"x\": 1, \"y\": 2}}\n");
  ASSERT_TRUE(json.wait_for(1));
  EXPECT_EQ(json.live().id(0), "3");
  Feed xml;
  xml.send("<?xml version=\"1.0\"?>\n<fcd-export><timestep time=\"2\"><person id=\"a\" x=\"1\" y=\"2\" angle=\"90\"/>");
  ASSERT_TRUE(xml.wait_for(1));
  EXPECT_EQ(xml.rows[0].row.seconds, 2.0);
  EXPECT_NEAR(xml.rows[0].row.heading, 1.5707963F, 1e-5F);
  xml.end();
  xml.wait();
  EXPECT_THAT(xml.live().status().error().message, HasSubstr("-: line 2: it is no whole XML"));
}

TEST(Live, TellsErrorsByLine) {
  Feed feed;
  feed.send("id,time,x,y\n1,0,0,0\n1,1,abc,0\n1,2,0,0\n");
  feed.wait();
  EXPECT_EQ(feed.rows.size(), 1U);
  EXPECT_EQ(feed.live().status().error().message,
            "-: line 3: \"abc\" is not a number; put x in metres there, or skip such rows with --lenient");
}

TEST(Live, SkipsBadAndLateRows) {
  Feed feed({.lenient = true});
  feed.send("id,time,x,y\n1,0,0,0\n1,1,abc,0\n1,2,0,0\n1,2,0,0\n1,2,1,1\n1,1.5,0,0\n");
  feed.end();
  feed.wait();
  EXPECT_EQ(feed.rows.size(), 2U);
  EXPECT_EQ(feed.live().bad_rows(), 1U);
  EXPECT_EQ(feed.live().late_rows(), 2U);
  EXPECT_TRUE(feed.live().status());
}

TEST(Live, ReadsALastLineWithoutItsEnd) {
  Feed feed;
  feed.send("id time x y\n1 0 0 0\n1 1 0 0.5");
  feed.end();
  feed.wait();
  EXPECT_EQ(feed.rows.size(), 2U);
}

TEST(Live, RefusesWhatItCannotRead) {
  for (const std::string_view text :
       {std::string_view(""), std::string_view("who,when\n1,2\n"), std::string_view("SQLite format 3\0....", 20),
        std::string_view("\0\1\2\3", 4), std::string_view("<routes>")}) {
    Feed feed;
    feed.send(text);
    feed.end();
    feed.wait();
    ASSERT_FALSE(feed.live().status()) << text;
    EXPECT_THAT(feed.live().status().error().message, testing::StartsWith("-: ")) << text;
  }
}

TEST(Live, EndsWhileItWaits) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  { const LiveTracks live(ends[0], {}); }  // returns, though nobody closed the pipe
  close(ends[0]);
  close(ends[1]);
}

TEST(Live, ReadsManyRowsInOrder) {
  Feed feed;
  std::thread sender([&] {
    std::string text = "id,frame,x,y\n";
    for (int i = 0; i < 50'000; ++i) text += std::to_string(i % 100) + "," + std::to_string(i / 100) + ",1,2\n";
    feed.send(text);
    feed.end();
  });
  feed.wait();
  sender.join();
  ASSERT_EQ(feed.rows.size(), 50'000U);
  for (std::size_t i = 0; i < feed.rows.size(); ++i) ASSERT_EQ(feed.rows[i].person, i % 100);
}

}  // namespace
}  // namespace throng::live_test
