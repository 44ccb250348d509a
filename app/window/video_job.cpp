#include "app/window/video_job.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/files/exit_status.h"
#include "app/files/program_words.h"
#include "app/files/whole_path.h"
#include "app/settings/option_values.h"
#include "app/show/painter.h"
#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "app/window/window_session.h"
#include "engine/base/files/child_process.h"

namespace throng::app {
namespace {

constexpr double video_rate = 30.0;  // frames a second

/// Leaves out what a run without a window does not show. The whole part is played once.
CrowdSetup setup_of_run(CrowdSetup setup) {
  Tuning& tuning = setup.preset.tuning;
  setup.pair = {};
  setup.bookmarks = {};
  tuning.paused = false;
  setup.trajectories.start.reset();
  setup.trajectories.repeats = false;
  if (tuning.scene != Scene::tracks) setup.trajectories = {};
  return setup;
}

/// Returns the whole number at the beginning of a text, which then begins behind it; 0: there is none.
int take_number(std::string_view& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return error == std::errc() ? number : 0;
}

bool take_word(std::string_view& text, std::string_view word) {
  const bool has_it = text.starts_with(word);
  if (has_it) text.remove_prefix(word.size());
  return has_it;
}

/// Returns the last line that a run of this program said, without the program's name.
std::string last_words(const std::string& said) {
  constexpr std::string_view name = "throng: ";
  std::string words = last_line(said);
  if (words.starts_with(name)) words.erase(0, name.size());
  return words;
}

/// Returns why no video of a show can be made; empty where one can.
std::string why_no_video(const Show& show) {
  if (show.live() == nullptr) return {};
  return "A video is made by a run of its own, which cannot read the rows of standard input again.";
}

}  // namespace

std::vector<std::string> words_of_video(WantedVideo video, const DemoOptions& options) {
  const Tuning tuning = video.setup.preset.tuning;
  const double speed = tuning.time_scale > 0.0F ? static_cast<double>(tuning.time_scale) : 1.0;
  const glm::ivec2 even = glm::max(video.size / 2 * 2, glm::ivec2(2));
  std::vector<std::string> words{"--headless", "--progress"};
  const auto add = [&](const char* option, const std::string& value) { words.insert(words.end(), {option, value}); };
  add("--crowd", to_json(setup_of_run(std::move(video.setup))).dump());
  add("--video", video.file);
  add("--size", std::to_string(even.x) + "x" + std::to_string(even.y));
  add("--fps-out", shortest_text(video_rate));
  add("--dt", shortest_text(speed / video_rate));
  if (tuning.scene != Scene::tracks) {
    add("--frames", std::to_string(std::max(1, static_cast<int>(video.seconds * video_rate))));
    add("--after", shortest_text(video.crowd_seconds));
  }
  if (tuning.debug_view != DebugView::none) words.emplace_back("--legend");
  if (!options.data.empty()) add("--data", options.data);
  if (options.msaa >= 0) add("--msaa", std::to_string(options.msaa));
  return words;
}

VideoProgress progress_in(const std::string& said) {
  const std::size_t newest = said.rfind("\nframe ");
  std::string_view rest(said);
  if (newest != std::string::npos) rest.remove_prefix(newest + 1);
  rest = rest.substr(0, rest.find('\n'));
  VideoProgress progress{.words = std::string(rest)};
  if (!take_word(rest, "frame ")) return {};
  const int frame = take_number(rest), frames = take_word(rest, " of ") ? take_number(rest) : 0;
  if (frames > 0) progress.share = static_cast<double>(frame) / frames;
  return progress;
}

void VideoJob::begin(WindowSession& session, CrowdSetup setup, const std::string& file) {
  const auto refuse = [&](const std::string& why) { session.messages().say(why, Message::Kind::refused); };
  if (program_) return refuse(file_ + " is being made; Cancel on its card ends it.");
  if (std::string why = why_no_video(session.show); !why.empty()) return refuse(why);
  setup.preset.tuning = session.best_values();
  const auto program = own_program();
  if (!program) return refuse("No video: " + program.error().message);
  std::vector<std::string> words = words_of_video({.file = file,
                                                   .size = session.show.painter().renderer().size(),
                                                   .setup = std::move(setup),
                                                   .seconds = session.reporter.report().output.video_seconds,
                                                   .crowd_seconds = to_seconds(session.show.stage().animated().age())},
                                                  session.options);
  words.insert(words.begin(), *program);
  auto started = PipedProgram::start(words);
  if (!started) return refuse("No video: " + *program + " does not start: " + started.error().message);
  program_.emplace(std::move(*started));
  program_->give_way();
  file_ = file;
  ends_ = leaves_no_file_ = false;
}

void VideoJob::cancel() {
  if (!program_) return;
  ends_ = true;
  leaves_no_file_ = !has_frames();
  program_->ask_to_end();
}

void VideoJob::go_on(WindowSession& session) {
  if (!program_) return;
  if (const auto status = program_->look()) say_outcome(session, *status);
}

std::optional<JobReport> VideoJob::report() const {
  if (!program_) return {};
  VideoProgress progress = progress_in(program_->answer());
  if (progress.words.empty()) progress.words = "opening the crowd";
  if (ends_) progress = {.words = "ending"};
  return JobReport{.job = SideJob::video, .words = file_ + ": " + progress.words, .share = progress.share};
}

void VideoJob::end() {
  if (!program_) return;
  if (has_frames()) {
    program_->ask_to_end();
    program_->finish();
    end_with(exit_done, "the window has closed; " + last_words(program_->answer()));
  }
  program_.reset();
}

void VideoJob::say_outcome(WindowSession& session, int status) {
  const std::string words = last_words(program_->answer());
  program_.reset();
  if (leaves_no_file_) {
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
    return session.messages().say("No video was written: it had no frame yet.");
  }
  if (status != exit_done && !ends_) {
    return session.messages().say("No video: " + words, Message::Kind::refused);
  }
  const std::size_t length = words.rfind('(');
  session.messages().say("Wrote " + whole_path(file_) +
                         (length == std::string::npos ? "" : " " + words.substr(length)));
}

}  // namespace throng::app
