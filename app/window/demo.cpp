#include "app/window/demo.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "app/files/exit_status.h"
#include "app/files/progress_line.h"
#include "app/output/output.h"
#include "app/output/progress.h"
#include "app/settings/user_settings.h"
#include "app/show/opened_show.h"
#include "app/show/painter.h"
#include "app/show/recording/recorder.h"
#include "app/show/replay.h"
#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "app/window/drawn_overlay.h"
#include "app/window/panel/overlay.h"
#include "app/window/start_screen.h"
#include "app/window/still_picture.h"
#include "app/window/stop_signals.h"
#include "app/window/window_loop.h"
#include "engine/base/files/output_file.h"
#include "engine/base/files/process.h"
#include "engine/base/text/joined.h"
#include "engine/tracks/live/live_tracks.h"

namespace throng::app {
namespace {

/// Tells why something failed, if it did. Returns whether it did not.
bool report(const Status& outcome) {
  if (!outcome) end_with(exit_job_failed, outcome.error().message);
  return static_cast<bool>(outcome);
}

/// Writes each file, whatever becomes of the others, and tells of each that could not be written. Returns whether all
/// could.
bool write_results(Show& show, const DemoOptions& options) {
  bool all = true;
  if (!options.screenshot.empty()) all &= report(write_picture(show, options.screenshot));
  if (!options.stats.empty()) {
    all &= report(show.figures().statistics().write(options.stats, show.stage(), show.painter().drawn_by()));
  }
  if (show.figures().timeline()) {
    all &= report(write_whole_file(options.trace, show.figures().timeline()->to_json()));
  }
  return all;
}

// A full disk is said when it happens, not hours later.
void report_once(const Status& outcome, bool& reported) {
  if (!reported) report(outcome);
  reported = !outcome;
}

/// Draws one of several frames that are all drawn, or lets the output do it.
Status draw_one_of_all(Show& show, Output* output, int frame) {
  return output != nullptr ? output->take(show, frame) : show.draw();
}

/// Lets the crowd go on before the first frame.
void go_on_unseen(Show& show, const DemoOptions& options) {
  const Ticks step = to_ticks(options.dt.value_or(usual_frame_seconds));
  const Ticks end = to_ticks(options.unseen_seconds.value_or(0.0));
  for (Ticks now{}; now < end && asked_to_stop() == 0; now += step) show.animate(std::min(step, end - now));
}

Status run_replay(Show& show, const DemoOptions& options, Replay& replay, Output* output, Progress& progress) {
  const DrawWhich which = show.painter().draws() ? drawn_frames(options) : DrawWhich::none;
  for (int frame = 1; asked_to_stop() == 0 && (!options.frames_given || frame <= options.frames); ++frame) {
    const Result<bool> repeated = replay.step(show);
    if (!repeated) return repeated.error();
    if (!*repeated) break;
    progress.show(frame);
    if (which != DrawWhich::all) continue;
    if (Status drawn = draw_one_of_all(show, output, frame); !drawn) return drawn;
  }
  return which == DrawWhich::last ? show.draw() : Done{};
}

Status run_frames(Show& show, const DemoOptions& options, Output* output, Progress& progress) {
  const Ticks step = to_ticks(options.dt.value_or(usual_frame_seconds));
  const DrawWhich which = drawn_frames(options);
  const int frames = frames_of_run(options, show);
  bool last = false, reported = false;
  for (int frame = 1; !last; ++frame) {
    while (asked_to_stop() == 0 && !show.has_rows_for(step, std::chrono::milliseconds(100))) {
    }
    show.animate(step);
    progress.show(frame);
    const LiveCrowd* const live = show.live();
    last = frame == frames || asked_to_stop() != 0 || (live != nullptr && live->has_ended());
    report_once(show.recorder().outcome(), reported);
    if (!show.painter().draws() || !(which == DrawWhich::all || (which == DrawWhich::last && last))) continue;
    if (Status drawn = draw_one_of_all(show, output, frame); !drawn) return drawn;
  }
  return Done{};
}

/// Ends an output after its run. A screenshot shows the last frame, also where its picture was there before.
Status finish_output(Show& show, const DemoOptions& options, Output* output) {
  if (output == nullptr) return Done{};
  if (Status finished = output->finish(); !finished) return finished;
  return options.screenshot.empty() || output->drew_last() ? Done{} : show.draw();
}

/// Tells what a run without a window did.
struct Account {
  int frames = 0;
  double seconds = 0;
  std::vector<std::string> written;  ///< video, pictures and labels
};

Status run_headless(Show& show, const DemoOptions& options, Replay* replay, Account& account) {
  if (options.ui) show.view().free.right = 1.0F - column_share(options.width, options.ui_scale);
  go_on_unseen(show, options);
  const bool has_overlay = (options.ui || options.legend || show.stage().tuning().ids) && show.painter().draws();
  DrawnOverlay overlay(options);
  std::unique_ptr<Output> output;
  if (options.output.any()) {
    auto begun = Output::begin(options, show);
    if (!begun) return begun.error();
    output = std::move(*begun);
    if (has_overlay) output->draw_over_pictures([&overlay](Show& drawn) { return overlay.draw(drawn); });
  }
  Progress progress(frames_of_run(options, show), options.says_progress);
  Status run = replay != nullptr ? run_replay(show, options, *replay, output.get(), progress)
                                 : run_frames(show, options, output.get(), progress);
  if (!run) return run;
  if (Status finished = finish_output(show, options, output.get()); !finished) return finished;
  progress.end();
  account = {progress.frame(), progress.seconds(), output != nullptr ? output->written() : std::vector<std::string>()};
  const LiveCrowd* const live = show.live();
  if (live != nullptr && !live->status()) return Error{live->status().error().message};
  if (!has_overlay || drawn_frames(options) == DrawWhich::none) return Done{};
  const bool is_over_last = output != nullptr && output->drew_last();
  if (Status drawn = is_over_last ? Done{} : overlay.draw(show); !drawn) return drawn;
  return overlay.write_map();
}

Status run_and_record(Show& show, const DemoOptions& options, Replay* replay, Account& account) {
  if (!options.record.empty()) {
    if (Status started = show.start_recording(options.record); !started) return started;
  }
  if (replay != nullptr) {
    if (Status begun = replay->begin(show); !begun) return begun;
  }
  if (options.selected) {
    const Status selected = show.take(Select{static_cast<std::uint32_t>(*options.selected)});
    if (!selected) return selected;
  }
  const bool window = options.context == ContextKind::window;
  return window ? run_window(show, options, replay) : run_headless(show, options, replay, account);
}

/// Runs the demo, and makes an error of an exception, so that all that the run has written is kept.
Status run_in_words(Show& show, const DemoOptions& options, Replay* replay, Account& account) {
  try {
    return run_and_record(show, options, replay, account);
  } catch (...) {
    return Error{std::string(sentence_of_failure())};
  }
}

// Beside JSON on standard output, on standard error.
Status say_what_was_repeated(const Replay& replay, const DemoOptions& options) {
  if (options.stats != "-") return print(replay.summary() + "\n");
  std::fprintf(stderr, "%s\n", replay.summary().c_str());
  return Done{};
}

// Says on stderr the notice that a window shows over the crowd.
void say_on_stderr(const std::string& notice) {
  std::istringstream lines(notice);
  for (std::string line; std::getline(lines, line);) end_with(exit_done, line);
}

// Says on stderr, in one line, how many frames a run without a window had and each file and folder that it wrote.
void say_what_was_written(const DemoOptions& options, const Account& account) {
  std::vector<std::string> files;
  for (const std::string& file : {options.screenshot, options.stats, options.trace, options.record, options.ui_map}) {
    if (!file.empty() && file != "-") files.push_back(file);
  }
  files.insert(files.end(), account.written.begin(), account.written.end());
  std::string line = counted(static_cast<std::size_t>(account.frames), "frame") + " in " + time_text(account.seconds);
  if (!files.empty()) line += "; wrote " + joined(files, ", ", " and ");
  if (files.empty() && options.stats.empty()) line += "; no option named a file to write";
  end_with(exit_done, line);
}

/// Begins to read the rows of a live crowd from standard input, and waits for the first, or until a signal asks the run
/// to end. Returns null where the options name no standard input. Errors: it ends without a row, or is wrong.
Result<std::unique_ptr<LiveTracks>> open_live_input(const DemoOptions& options) {
  if (options.trajectories.file != "-") return std::unique_ptr<LiveTracks>();
  auto tracks = std::make_unique<LiveTracks>(standard_input, options.trajectories.reading);
  show_progress("waiting for the first row on standard input");
  while (!tracks->head() && !tracks->has_ended() && asked_to_stop() == 0) tracks->wait(std::chrono::milliseconds(100));
  show_progress("");
  if (tracks->head()) return tracks;
  if (const Status read = tracks->status(); !read) return Error{read.error().message};
  return Error{asked_to_stop() != 0 ? "-: the run ends before the first row came"
                                    : "-: it ended without a row; send rows as a table with a header"};
}

/// Returns how the start of a run does its work: in a window beside its picture.
StartWork start_of(const DemoOptions& options) {
  if (options.context != ContextKind::window) return start_at_once;
  return [&options](Painter& painter, const LongWork& work) { return show_start(painter, options, work); };
}

int exit_of_ended_run() { return asked_to_stop() == 0 ? static_cast<int>(exit_done) : exit_of_signal(asked_to_stop()); }

int run_show(const DemoOptions& options, Replay* replay) {
  const StopSignals signals;
  StartError error;
  auto live = open_live_input(options);
  if (!live) return report(live.error()), asked_to_stop() == 0 ? exit_job_failed : exit_of_signal(asked_to_stop());
  const std::unique_ptr<Show> show = open_show(options, error, std::move(*live), start_of(options));
  if (show == nullptr && error.message.empty()) return exit_of_ended_run();
  if (show == nullptr) return end_with(static_cast<ExitStatus>(error.status), error.message);
  Account account;
  const bool ran = report(run_in_words(*show, options, replay, account));
  const bool recorded = report(show->stop_recording());
  if (!ran || !write_results(*show, options) || !recorded) return exit_job_failed;
  if (replay != nullptr && !report(say_what_was_repeated(*replay, options))) return exit_job_failed;
  if (options.context != ContextKind::window) {
    say_on_stderr(show->notice());
    say_what_was_written(options, account);
  }
  return exit_of_ended_run();
}

/// Returns the options of a window that starts as the last one was left. Damaged settings are said and left out.
DemoOptions with_settings(DemoOptions options) {
  if (options.context != ContextKind::window || options.no_settings) return options;
  const auto settings = read_user_settings(user_settings_file());
  if (settings) take_user_settings(*settings, options);
  if (!settings) end_with(exit_done, settings.error().message);
  return options;
}

}  // namespace

int run_demo(const DemoOptions& options) {
  if (const Status ready = check_output(options.output); !ready) {
    return end_with(exit_job_failed, ready.error().message);
  }
  if (options.replay.empty()) return run_show(with_settings(options), nullptr);
  const auto replay = Replay::open(options.replay);
  if (!replay) return end_with(exit_job_failed, replay.error().message);
  return run_show((*replay)->options(options), replay->get());
}

}  // namespace throng::app
