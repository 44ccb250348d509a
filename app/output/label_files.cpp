#include "app/output/label_files.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "app/files/memory_check.h"
#include "app/output/label_text.h"
#include "app/output/regression/compare.h"
#include "app/show/stage/stage.h"

namespace throng::app {
namespace {

constexpr std::size_t most_waiting_labels = 2;

// Numbers and depths as they are drawn, and waiting files of frames.
constexpr std::uint64_t bytes_a_labelled_pixel = 8 + 4 * (most_waiting_labels + 2);

render::NumberImage mask_of(const render::LabelPicture& labels) {
  render::NumberImage mask{labels.size.x, labels.size.y, {}};
  mask.numbers.resize(labels.agents.size());
  std::ranges::transform(labels.agents, mask.numbers.begin(),
                         [](std::uint32_t agent) { return static_cast<std::uint16_t>(agent); });
  return mask;
}

render::NumberImage depth_of(const render::LabelPicture& labels, double step) {
  constexpr float least = 1, most = 65535;
  const auto steps_a_metre = static_cast<float>(1.0 / step);
  render::NumberImage depth{labels.size.x, labels.size.y, {}};
  depth.numbers.resize(labels.metres.size());
  std::ranges::transform(labels.metres, depth.numbers.begin(), [&](float metres) {
    if (!std::isfinite(metres)) return std::uint16_t{0};
    return static_cast<std::uint16_t>(std::clamp(std::round(metres * steps_a_metre), least, most));
  });
  return depth;
}

}  // namespace

Result<std::unique_ptr<LabelFiles>> LabelFiles::open(const DemoOptions& options, const Show& show) {
  const glm::ivec2 size(options.width, options.height);
  const std::uint64_t pixels = static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
  const std::string what = "the labels of " + std::to_string(size.x) + "x" + std::to_string(size.y) + " pixels";
  const Status fits = check_memory(what, pixels * bytes_a_labelled_pixel, "ask for a smaller --size");
  if (!fits) return fits.error();
  auto folder = OutputFolder::open("--labels", options.output.labels, options.output.run);
  if (!folder) return folder.error();
  auto lines = OutputFile::create(folder->path() / "labels.jsonl", OutputFile::Unfinished::kept);
  if (!lines) return lines.error();
  std::unique_ptr<LabelFiles> files(new LabelFiles(std::move(*folder), std::move(*lines), show.stage(), size));
  const Json conventions = label_conventions(show.stage().characters(), files->maker_.coco());
  const auto written = write_whole_file(files->folder_.path() / "labels.json", conventions.dump(1) + "\n");
  if (!written) return written.error();
  return files;
}

LabelFiles::LabelFiles(OutputFolder folder, OutputFile lines, const Stage& stage, glm::ivec2 size)
    : folder_(std::move(folder)),
      size_(size),
      kept_(folder_.path() / "labels.jsonl"),
      lines_(std::move(lines)),
      maker_(stage),
      writer_(1, most_waiting_labels) {}

bool LabelFiles::has(int frame) const {
  const auto is_there = [&](const char* kind) {
    return render::is_whole_png(folder_.file(kind, frame), size_.x, size_.y);
  };
  return frame <= kept_.count() && is_there("mask") && is_there("depth");
}

Status LabelFiles::take(Show& show, int frame, bool is_drawn) {
  if (Status made = maker_.make(show, frame, is_drawn); !made) return made;
  const auto mask = std::make_shared<const render::NumberImage>(mask_of(maker_.picture()));
  const auto depth =
      std::make_shared<const render::NumberImage>(depth_of(maker_.picture(), maker_.frame().metres_a_step));
  const auto labels = std::make_shared<const LabelFrame>(std::move(maker_.frame()));
  return writer_.add([=, this] { return write(*labels, *mask, *depth); });
}

Status LabelFiles::write(const LabelFrame& frame, const render::NumberImage& mask, const render::NumberImage& depth) {
  static_cast<void>(kept_.next());
  Status written = render::write_png(mask, folder_.file("mask", frame.number), label_texts());
  if (!written) return written;
  written = render::write_png(depth, folder_.file("depth", frame.number), depth_texts(frame.metres_a_step));
  if (!written) return written;
  return lines_.write(line_of(frame) + "\n");
}

Status LabelFiles::keep() {
  return writer_.add([this]() -> Status {
    const auto line = kept_.next();
    if (line) return lines_.write(*line + "\n");
    return Error{lines_.file().string() + ": it has changed while it was read; name another folder"};
  });
}

// A shorter run keeps the frames that a longer one has written after its end.
Status LabelFiles::finish() {
  if (Status finished = writer_.finish(); !finished) return finished;
  while (const auto line = kept_.next()) {
    if (Status written = lines_.write(*line + "\n"); !written) return written;
  }
  if (Status written = lines_.commit(); !written) return written;
  kept_.remove_parts();
  return Done{};
}

}  // namespace throng::app
