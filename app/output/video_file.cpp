#include "app/output/video_file.h"

#include <iterator>
#include <sstream>
#include <string>
#include <utility>

#include "app/files/program_words.h"
#include "app/output/whole_video.h"
#include "app/settings/option_values.h"

namespace throng::app {
namespace {

constexpr const char* program = "ffmpeg";

bool is_webm(const std::filesystem::path& file) { return file.extension() == ".webm"; }

std::string encoder_of(const std::filesystem::path& file) { return is_webm(file) ? "libvpx-vp9" : "libx264"; }

Error not_started(const std::string& why) {
  return {std::string("--video: ") + program + " does not start: " + why +
          "; install the package ffmpeg, or write --pictures"};
}

/// Returns the words that start an ffmpeg which reads frames and writes `part`. Colours are as in HD television, which
/// players take them for.
std::vector<std::string> words_for(const std::filesystem::path& file, const std::filesystem::path& part,
                                   const VideoFormat& format) {
  const std::string size = std::to_string(format.width) + "x" + std::to_string(format.height);
  const std::string quality = is_webm(file) ? "-b:v 0 -crf 28 -row-mt 1 -cpu-used 4 -deadline good -f webm"
                                            : "-preset medium -crf 18 -movflags +faststart -f mp4";
  std::istringstream line(
      std::string(program) + " -hide_banner -nostdin -loglevel error " +
      "-f rawvideo -pixel_format rgb24 -video_size " + size + " -framerate " + shortest_text(format.rate) +
      " -i pipe:0 -an " + "-vf scale=in_range=full:out_range=tv:out_color_matrix=bt709,format=yuv420p " +
      "-color_primaries bt709 -color_trc bt709 -colorspace bt709 -c:v " + encoder_of(file) + " " + quality);
  std::vector<std::string> words(std::istream_iterator<std::string>(line), {});
  words.insert(words.end(), {"-y", "file:" + part.string()});
  return words;
}

}  // namespace

Status check_encoder(const std::filesystem::path& file) {
  auto asked = PipedProgram::start({program, "-hide_banner", "-loglevel", "error", "-encoders"});
  if (!asked) return not_started(asked.error().message);
  const int status = asked->finish();
  const std::string encoder = encoder_of(file);
  const std::string words = last_line(asked->answer());
  if (status != 0) return not_started(words.empty() ? "it ends with status " + std::to_string(status) : words);
  if (asked->answer().find(" " + encoder + " ") != std::string::npos) return Done{};
  return Error{"--video " + file.string() + ": this ffmpeg has no encoder " + encoder +
               "; install the package ffmpeg, or name a " + (is_webm(file) ? ".mp4" : ".webm")};
}

Result<std::unique_ptr<VideoFile>> VideoFile::create(const std::filesystem::path& file, const VideoFormat& format) {
  if (is_device_or_pipe(file)) {
    return Error{"--video " + file.string() + ": a video is written to and fro; name a file, not a pipe"};
  }
  auto output = OutputFile::create(file);
  if (!output) return output.error();
  auto encoder = PipedProgram::start(words_for(file, output->part(), format));
  if (!encoder) return not_started(encoder.error().message);
  return std::unique_ptr<VideoFile>(new VideoFile(std::move(*output), std::move(*encoder), format));
}

VideoFile::VideoFile(OutputFile file, PipedProgram encoder, const VideoFormat& format)
    : file_(std::move(file)), encoder_(std::move(encoder)) {
  rgb_.resize(static_cast<std::size_t>(format.width) * static_cast<std::size_t>(format.height) * 3);
}

Status VideoFile::add(const render::Image& frame) {
  for (std::size_t pixel = 0; pixel < rgb_.size() / 3; ++pixel) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      rgb_[3 * pixel + channel] = std::byte{frame.rgba[4 * pixel + channel]};
    }
  }
  if (encoder_.write(rgb_)) return Done{};
  return ended("ended before the video did", encoder_.finish());
}

Status VideoFile::finish() {
  const int status = encoder_.finish();
  if (status != 0) return ended("failed at the end of the video", status);
  const bool is_whole = !file_.full_disk_in(encoder_.answer()) && is_whole_video(file_.part());
  return is_whole ? file_.commit() : ended("left a video that is not whole", status);
}

Error VideoFile::ended(const std::string& how, int status) const {
  if (auto full = file_.full_disk_in(encoder_.answer())) return *full;
  const std::string words = last_line(encoder_.answer());
  return {file_.file().string() + ": ffmpeg " + how + " (status " + std::to_string(status) + ")" +
          (words.empty() ? "" : ": " + words) + "; write --pictures instead"};
}

}  // namespace throng::app
