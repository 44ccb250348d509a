#include "app/output/output.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>

#include "app/output/progress.h"
#include "app/output/regression/origin.h"
#include "app/show/painter.h"
#include "app/show/stage/stage.h"
#include "engine/base/files/cores.h"
#include "engine/base/text/joined.h"
#include "engine/base/text/size_text.h"

namespace throng::app {
namespace {

constexpr int most_picture_writers = 4;

/// Returns how many frames may wait for a thread, so that large ones do not fill the memory.
std::size_t most_waiting_frames(const VideoFormat& format) {
  constexpr std::size_t most_bytes = std::size_t{256} << 20U, most_frames = 8;
  const std::size_t bytes = 4 * static_cast<std::size_t>(format.width) * static_cast<std::size_t>(format.height);
  return std::clamp<std::size_t>(most_bytes / bytes, 1, most_frames);
}

VideoFormat format_of(const DemoOptions& options) {
  const double of_run = 1.0 / options.dt.value_or(usual_frame_seconds);
  return {options.width, options.height, options.output.frames_per_second.value_or(of_run)};
}

int picture_writers() { return std::clamp(usable_cores() / 2, 1, most_picture_writers); }

}  // namespace

Status check_output(const OutputOptions& options) {
  return options.video.empty() ? Done{} : check_encoder(options.video);
}

int frames_of_run(const DemoOptions& options, const Show& show) {
  const FollowedTracks* const tracks = show.stage().crowd().tracks();
  const bool goes_on_to_its_end = tracks != nullptr && options.output.any();
  if (!options.frames_given && (show.live() != nullptr || !options.replay.empty())) return 0;
  if (options.frames_given || !goes_on_to_its_end) return options.frames;
  const TrackClock& clock = tracks->clock();
  const double left = clock.rate < 0.0 ? clock.seconds - clock.first : clock.last - clock.seconds;
  const double frames = std::ceil(left / std::abs(clock.rate) / options.dt.value_or(usual_frame_seconds));
  return static_cast<int>(std::clamp(frames, 1.0, 1e9));
}

Result<std::unique_ptr<Output>> Output::begin(const DemoOptions& options, const Show& show) {
  std::unique_ptr<Output> output(new Output(options));
  if (const Status opened = output->open_files(options, show); !opened) return opened.error();
  return output;
}

Output::Output(const DemoOptions& options) : options_(options.output), format_(format_of(options)) {}

Status Output::open_files(const DemoOptions& options, const Show& show) {
  const std::size_t most_waiting = most_waiting_frames(format_);
  if (!options_.labels.empty()) {
    auto labels = LabelFiles::open(options, show);
    if (!labels) return labels.error();
    labels_ = std::move(*labels);
  }
  if (!options_.pictures.empty()) {
    auto folder = OutputFolder::open("--pictures", options_.pictures, options_.run);
    if (!folder) return folder.error();
    pictures_ = std::move(*folder);
    picture_writers_.emplace(picture_writers(), most_waiting);
  }
  if (options_.video.empty()) return Done{};
  auto video = VideoFile::create(options.output.video, format_);
  if (!video) return video.error();
  video_ = std::move(*video);
  encoder_.emplace(1, most_waiting);
  return Done{};
}

bool Output::is_there(int frame) const {
  if (video_ && !pictures_) return false;
  if (labels_ && !labels_->has(frame)) return false;
  return !pictures_ || render::is_whole_png(pictures_->file("frame", frame), format_.width, format_.height);
}

Status Output::take(Show& show, int frame) {
  frames_ = frame;
  return is_there(frame) ? use_again(frame) : draw(show, frame);
}

Status Output::draw(Show& show, int frame) {
  drew_last_ = video_ || pictures_;
  if (drew_last_) {
    if (Status drawn = show.draw(); !drawn) return drawn;
  }
  if (labels_) {
    if (Status taken = labels_->take(show, frame, drew_last_); !taken) return taken;
  }
  if (!drew_last_) return Done{};
  if (Status drawn = draw_over_ ? draw_over_(show) : Done{}; !drawn) return drawn;
  return keep_image(show, frame);
}

Status Output::keep_image(Show& show, int frame) {
  render::Renderer& renderer = show.painter().renderer();
  const auto image = std::make_shared<const render::Image>(renderer.read_image());
  if (Status read = renderer.finish(); !read) return read;
  if (pictures_) {
    const auto write = [image, file = pictures_->file("frame", frame),
                        texts = origin_texts(show.painter().drawn_by())] {
      return render::write_png(*image, file, texts);
    };
    if (Status added = picture_writers_->add(write); !added) return added;
  }
  return video_ ? add_to_video(image) : Done{};
}

Status Output::use_again(int frame) {
  ++kept_;
  drew_last_ = false;
  if (labels_) {
    if (Status kept = labels_->keep(); !kept) return kept;
  }
  if (!video_) return Done{};
  return encoder_->add([this, file = pictures_->file("frame", frame)]() -> Status {
    const auto image = render::read_png(file);
    return image ? video_->add(*image) : image.error();
  });
}

Status Output::add_to_video(SharedImage image) {
  return encoder_->add([this, image = std::move(image)] { return video_->add(*image); });
}

Status Output::finish() {
  for (auto* const workers : {&picture_writers_, &encoder_}) {
    if (!*workers) continue;
    if (Status finished = (*workers)->finish(); !finished) return finished;
  }
  if (labels_) {
    if (Status finished = labels_->finish(); !finished) return finished;
  }
  if (video_) {
    if (Status finished = video_->finish(); !finished) return finished;
  }
  return Done{};
}

std::vector<std::string> Output::written() const {
  const auto frames = static_cast<std::size_t>(frames_);
  const std::string before =
      kept_ > 0 ? "; " + counted(static_cast<std::size_t>(kept_), "frame") + " were there from before" : "";
  std::vector<std::string> files;
  if (video_) {
    std::error_code error;
    const auto bytes = std::filesystem::file_size(options_.video, error);
    files.push_back(options_.video + " (" + time_text(frames_ / format_.rate) + " of video, " +
                    size_text(error ? 0 : bytes) + ")");
  }
  if (pictures_) files.push_back(options_.pictures + " (" + counted(frames, "picture") + before + ")");
  if (labels_) files.push_back(options_.labels + " (labels of " + counted(frames, "frame") + before + ")");
  return files;
}

}  // namespace throng::app
