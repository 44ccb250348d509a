#include "app/window/wanted_values.h"

#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "app/window/window_session.h"

namespace throng::app {
namespace {

anim::Status give(const Tuning& tuning, Show& show) {
  return tuning == show.stage().tuning() ? anim::Done{} : show.take(Apply{tuning});
}

}  // namespace

void show_wanted_values(WindowSession& session, bool exact_crowd) {
  const Tuning& tuning = session.editor.tuning();
  TuningSweep& sweep = session.sweep;
  if (!sweep.began_with(tuning)) sweep.stop();
  while (sweep.runs() && !exact_crowd) {
    const anim::Status given = give(sweep.tuning(), session.show);
    if (given) return;
    sweep.refuse(given.error().message);
  }
  session.messages().report(give(exact_crowd ? without_level_of_detail(tuning) : tuning, session.show));
}

// Frames in which no agent was posed, or the exact crowd was, tell nothing.
void measure_for_sweep(WindowSession& session) {
  TuningSweep& sweep = session.sweep;
  const anim::AnimationSystem& system = session.show.stage().system();
  const bool tells = sweep.runs() && session.show.stage().tuning() == sweep.tuning();
  if (tells && system.figures().report().agents_updated > 0) sweep.add(cost_of_last_update(system));
  session.reporter.show_sweep(sweep.curve());
}

}  // namespace throng::app
