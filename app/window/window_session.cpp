#include "app/window/window_session.h"

#include "app/show/painter.h"
#include "app/show/show.h"
#include "app/show/stage/stage.h"

namespace throng::app {
namespace {

Status give(const Tuning& tuning, Show& show) {
  return tuning == show.stage().tuning() ? Done{} : show.take(Apply{tuning});
}

}  // namespace

WindowSession::WindowSession(Show& show_in_window, const DemoOptions& given)
    : show(show_in_window),
      options(given),
      unsaved(show.stage().tuning()),
      input(show.painter().context().window()),
      camera(show),
      reporter(show),
      editor(show, reporter) {}

void WindowSession::show_wanted_values(bool exact_crowd) {
  const Tuning& tuning = editor.tuning();
  if (!sweep.began_with(tuning)) sweep.stop();
  while (sweep.runs() && !exact_crowd) {
    const Status given = give(sweep.tuning(), show);
    if (given) return;
    sweep.refuse(given.error().message);
  }
  messages().report(give(exact_crowd ? without_level_of_detail(tuning) : tuning, show));
}

// Frames in which no agent was posed, or the exact crowd was, tell nothing.
void WindowSession::measure_for_sweep() {
  const Stage& stage = show.stage();
  const bool tells = sweep.runs() && stage.tuning() == sweep.tuning();
  if (tells && stage.system().figures().report().agents_updated > 0) sweep.add(cost_of_last_update(stage.system()));
  reporter.report().sweep = sweep.curve();
}

}  // namespace throng::app
