#include "tests/soak/show_rounds.h"

#include <unistd.h>

#include "app/show/opened_show.h"
#include "app/show/painter.h"
#include "app/show/replay.h"
#include "app/show/stage/rewind.h"
#include "app/show/stage/stage.h"
#include "tests/sanitized.h"
#include "tests/soak/acts.h"
#include "tests/soak/finite_poses.h"
#include "tests/soak/gl_objects.h"
#include "tests/soak/process_figures.h"

namespace throng::soak {
namespace {

constexpr int rest_width = 320, rest_height = 240, rest_agents = 60;
app::Tuning rest_tuning() {
  app::Tuning tuning;
  tuning.agents = rest_agents;
  tuning.system.pus = 2;
  return tuning;
}

app::DemoOptions rest_options(app::ContextKind context) {
  app::DemoOptions options;
  options.tuning = rest_tuning();
  options.context = context;
  options.width = rest_width;
  options.height = rest_height;
  return options;
}

/// The length of a frame, as a window has it: of a clock that jitters, or 0 while the crowd stands still.
Ticks any_frame(const app::Show& show, Random& random) {
  if (show.stage().tuning().paused && random.chance(0.8F)) return {};
  if (random.chance(0.5F)) return ticks_per_second / 60;
  return to_ticks(any_number(random, app::least_frame_seconds, 1.0));
}

/// Animates a frame. The clock moves by the frame and nothing else, and nothing becomes a number that is none.
Fault animate(app::Show& show, Ticks delta) {
  const Ticks before = show.stage().system().clock();
  show.animate(delta);
  const Ticks moved = show.stage().system().clock() - before;
  if (moved != delta) {
    return "the clock moved by " + std::to_string(moved.count()) + " ticks in a frame of " +
           std::to_string(delta.count());
  }
  return number_that_is_none(show);
}

}  // namespace

Fault ShowRounds::run(const RoundPlace& place) {
  Random random(place.seed, 2);
  if (random.chance(0.1F)) show_.reset();
  if (Fault fault = open()) return fault;
  if (Fault fault = play(place, random)) return fault;
  if (Fault fault = replay(place, random)) return fault;
  return rest();
}

Fault ShowRounds::open() {
  if (show_ != nullptr) return {};
  app::StartError error;
  show_ = app::open_show(rest_options(context_), error);
  if (show_ == nullptr) return "there is no show: " + error.message;
  show_->keep_moments();
  return rest();
}

Fault ShowRounds::renew() {
  if (show_ == nullptr) return {};
  show_.reset();
  return open();
}

Fault ShowRounds::play(const RoundPlace& place, Random& random) {
  const Status started = show_->start_recording(place.folder / "run.rec");
  if (!started) return started.error().message;
  for (std::uint32_t frames = 20 + random.below(60); frames > 0; --frames) {
    if (random.chance(0.5F)) act_at_random(*show_, *models_, random, counts_);
    if (Fault fault = animate(*show_, any_frame(*show_, random))) return fault;
    ++counts_["frames"];
  }
  const Status stopped = show_->stop_recording();
  return stopped ? Fault{} : stopped.error().message;
}

Fault ShowRounds::replay(const RoundPlace& place, Random& random) {
  const auto replay = app::Replay::open(place.folder / "run.rec");
  if (!replay) return replay.error().message;
  app::DemoOptions options = rest_options(app::ContextKind::none);
  options.tuning.system.pus = static_cast<int>(1 + random.below(4));
  options.tuning.system.schedule = random.chance(0.5F) ? anim::Schedule::levels : anim::Schedule::fused;
  options = (*replay)->options(options);
  app::StartError error;
  const auto show = app::open_show(options, error);
  if (show == nullptr) return "the recording has no show: " + error.message;
  if (const Status begun = (*replay)->begin(*show); !begun) return begun.error().message;
  while (true) {
    const Result<bool> repeated = (*replay)->step(*show);
    if (!repeated) return repeated.error().message;
    if (!*repeated) break;
    if (Fault fault = number_that_is_none(*show)) return "repeated: " + *fault;
  }
  ++counts_["replays"];
  return {};
}

Fault ShowRounds::rest() {
  // The values first: others may not fit the model.
  if (const Status applied = show_->take(app::Apply{rest_tuning()}); !applied) return applied.error().message;
  const Status replaced = show_->take(app::LoadModels{{models_->built_in}});
  if (!replaced) return replaced.error().message;
  show_->view().width = rest_width;
  show_->view().height = rest_height;
  show_->view().camera = {};
  show_->view().films = false;
  const bool draws = show_->painter().draws();
  if (draws) {
    const Status set = show_->painter().renderer().set_size({rest_width, rest_height});
    if (!set) return set.error().message;
  }
  constexpr int frames = 5;
  for (int frame = 0; frame < frames; ++frame) {
    show_->animate(ticks_per_second / 60);
    if (!draws) continue;
    if (const Status drawn = show_->draw(); !drawn) return drawn.error().message;
  }
  return {};
}

void ShowRounds::measure(Growth& growth, const Others& others) const {
  const bool draws = context_ != app::ContextKind::none;
  const bool renderer = draws || others.draw;
  const std::uint64_t heap = heap_in_use();
  const ProcessFigures figures = figures_of(getpid());
  const std::string name = std::string(this->name()) + ", ";
  // Figures of a run keep each time of its first 10,000 frames; the software renderer keeps what it compiled.
  if (!test::sanitized) {
    growth.add(name + "bytes on the heap", heap, (renderer ? 24 : 4) * mebibyte);
    growth.add(name + "bytes resident", figures.resident, (renderer ? 96 : 24) * mebibyte);
  }
  growth.add(name + "open files", static_cast<std::uint64_t>(figures.descriptors - others.open_files), 0);
  growth.add(name + "threads", static_cast<std::uint64_t>(figures.threads), 0);
  if (!draws) return;
  growth.add(name + "objects of OpenGL", count_gl_objects(), 0);
  // Variants of programs are built when they are first drawn with. There are no more than these.
  constexpr std::uint64_t most_variants = 300;
  growth.add(name + "programs of OpenGL", count_gl_programs(), most_variants);
}

}  // namespace throng::soak
