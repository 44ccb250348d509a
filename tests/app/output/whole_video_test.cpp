// Videos as ffmpeg leaves them, whole and cut short, byte by byte.
#include "app/output/whole_video.h"

#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/app/temporary_folder.h"

namespace throng::app::whole_video_test {
namespace {

using namespace std::string_literals;

const std::string head = "\0\0\0\014ftypisom"s, table = "\0\0\0\012moov-+"s, room = "\0\0\0\010free"s;
const std::string media = "\0\0\0\013mdat123"s, long_media =
                                                    "\0\0\0\1mdat\0\0\0\0\0\0\0\023"
                                                    "123"s;
const std::string media_without_length = "\0\0\0\0mdat123"s;

const std::string web_head =
    "\x1A\x45\xDF\xA3\x83"
    "abc"s;
const std::string web_segment = "\x18\x53\x80\x67\x01\0\0\0\0\0\0\4wxyz"s;
const std::string web_segment_without_length = "\x18\x53\x80\x67\x01\xFF\xFF\xFF\xFF\xFF\xFF\xFFwxyz"s;

class WholeVideo : public test::TemporaryFolder {
 protected:
  bool is_whole(const std::string& bytes) const {
    std::ofstream(folder_ / "video", std::ios::binary) << bytes;
    return is_whole_video(folder_ / "video");
  }
};

TEST_F(WholeVideo, HasItsTableBeforeOrBehindItsMedia) {
  EXPECT_TRUE(is_whole(head + table + room + media));
  EXPECT_TRUE(is_whole(head + room + media + table));
}

TEST_F(WholeVideo, HasMediaOfAnyLength) { EXPECT_TRUE(is_whole(head + table + long_media)); }

TEST_F(WholeVideo, OfTheWebSaysTheLengthOfItsSegment) {
  EXPECT_TRUE(is_whole(web_head + web_segment));
  EXPECT_FALSE(is_whole(web_head + web_segment_without_length));
  EXPECT_FALSE(is_whole(web_head + web_segment + "more"));
}

TEST_F(WholeVideo, IsNoneThatIsCutShortAnywhere) {
  for (const std::string& whole : {head + table + room + media, head + table + long_media, web_head + web_segment}) {
    for (std::size_t length = 0; length < whole.size(); ++length) {
      EXPECT_FALSE(is_whole(whole.substr(0, length))) << length;
    }
  }
}

TEST_F(WholeVideo, IsNoneWithoutTableMediaOrLength) {
  EXPECT_FALSE(is_whole(head + table + room));
  EXPECT_FALSE(is_whole(head + room + media));
  EXPECT_FALSE(is_whole(head + room + media_without_length));
}

TEST_F(WholeVideo, IsNoneThatIsNotThere) { EXPECT_FALSE(is_whole_video(folder_ / "none.mp4")); }

}  // namespace
}  // namespace throng::app::whole_video_test
