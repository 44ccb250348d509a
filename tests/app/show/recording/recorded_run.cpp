#include "tests/app/show/recording/recorded_run.h"

#include <fstream>
#include <iterator>
#include <variant>

#include "app/commands/command_line/options.h"
#include "app/files/byte_hash.h"
#include "app/show/opened_show.h"
#include "app/show/recording/bytes.h"
#include "app/show/show_view.h"
#include "app/show/stage/stage.h"
#include "tests/app/commands/command_line/command_words.h"

namespace throng::app::test {

DemoOptions demo(const std::string& line) {
  const ParsedCommand command = parse_command_line(words("--headless=none " + line));
  const auto* const options = std::get_if<DemoOptions>(&command);
  EXPECT_NE(options, nullptr) << line;
  return options == nullptr ? DemoOptions{} : *options;
}

std::unique_ptr<Show> show_of(const DemoOptions& options) {
  StartError error;
  auto show = open_show(options, error);
  EXPECT_NE(show, nullptr) << error.message;
  return show;
}

void change(Show& show, const std::function<void(Tuning&)>& values) {
  Tuning tuning = show.stage().tuning();
  values(tuning);
  ask(show, Apply{tuning});
}

void ask(Show& show, const CrowdRequest& request) {
  const Status taken = show.take(request);
  EXPECT_TRUE(taken) << taken.error().message;
}

Push push_of_selected(const Show& show) { return {*show.stage().selected(), render::forward(show.view().camera)}; }

std::string with_true_checksum(std::string recording) {
  recording.resize(recording.size() - sizeof(std::uint64_t));
  ByteHash hash;
  hash.add(recording);
  append_number(recording, hash.value());
  return recording;
}

void RecordedRun::record(Show& show, int frames, const Act& act) const {
  const Status started = show.start_recording(file_);
  ASSERT_TRUE(started) << started.error().message;
  for (int frame = 1; frame <= frames; ++frame) {
    act(show, frame);
    show.animate(show.stage().tuning().paused ? Ticks{} : sixtieth + Ticks{frame % 3 * 1000});
  }
  const Status stopped = show.stop_recording();
  ASSERT_TRUE(stopped) << stopped.error().message;
}

std::string RecordedRun::repeated(const std::string& line) const {
  const auto replay = Replay::open(file_);
  if (!replay) return replay.error().message;
  const DemoOptions options = (*replay)->options(demo("--replay " + file_.string() + " " + line));
  const auto show = show_of(options);
  if (const Status begun = (*replay)->begin(*show); !begun) return begun.error().message;
  for (;;) {
    const Result<bool> more = (*replay)->step(*show);
    if (!more) return more.error().message;
    if (!*more) return (*replay)->summary();
  }
}

std::string RecordedRun::repeated_in_any_schedule() const {
  for (const char* const line : {"", "--pus 3 --schedule levels", "--pus 2 --schedule fused --tile 2"}) {
    const std::string found = repeated(line);
    if (!found.starts_with(file_.string() + ": all ")) return found;
  }
  return "(as recorded)";
}

std::string RecordedRun::bytes() const {
  std::ifstream stream(file_, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void RecordedRun::put(const std::string& bytes) const { std::ofstream(file_, std::ios::binary) << bytes; }

}  // namespace throng::app::test
