#include "app/show/contexts.h"

#include <span>
#include <string>
#include <vector>

#include "app/show/driver_needs.h"

namespace throng::app {
namespace {

using Maker = std::function<MadeContext()>;

/// A context that could be had instead of one that does not open.
struct Alternative {
  const Maker& make;
  const char* advice;
};

bool wants_pictures(const DemoOptions& options) { return drawn_frames(options) != DrawWhich::none || options.ui; }

std::string last_resort(const DemoOptions& options) {
  return wants_pictures(options) ? "" : "; --headless=none runs without drawing";
}

/// Gives the error of the requested context, with an alternative that works, or else with the errors of all.
MadeContext refuse(std::string reasons, std::span<const Alternative> alternatives, const DemoOptions& options) {
  for (const Alternative& other : alternatives) {
    const MadeContext made = other.make();
    if (made) return render::Error{reasons + "; use " + other.advice};
    reasons += "; " + made.error().message;
  }
  return render::Error{reasons + last_resort(options)};
}

MadeContext open_or_refuse(const Maker& make, std::span<const Alternative> alternatives, const DemoOptions& options) {
  MadeContext made = make();
  return made ? std::move(made) : refuse(made.error().message, alternatives, options);
}

}  // namespace

ContextMakers context_makers(const DemoOptions& options) {
  using namespace render::gl;
  const WindowOptions window{.width = options.width, .height = options.height};
  const EglOptions egl{.force_software = options.force_software};
  return {[window] { return make_window_context(window); }, [egl] { return make_egl_context(egl); },
          make_osmesa_context};
}

MadeContext open_context(const DemoOptions& options, const ContextMakers& makers) {
  if (const anim::Status fits = check_room_to_draw(); !fits) {
    return render::Error{fits.error().message + last_resort(options)};
  }
  spare_driver_threads();
  const auto refuse_unless = [&](const Maker& make, const std::vector<Alternative>& alternatives) {
    return open_or_refuse(make, alternatives, options);
  };
  switch (options.context) {
    case ContextKind::window:
      return refuse_unless(makers.window, {{makers.egl, "--headless"}, {makers.osmesa, "--headless"}});
    case ContextKind::egl:
      return refuse_unless(makers.egl, {{makers.osmesa, "--headless=osmesa"}});
    case ContextKind::osmesa:
      return refuse_unless(makers.osmesa, {{makers.egl, "--headless=egl"}});
    default:
      break;
  }
  MadeContext first = makers.egl();
  if (first) return first;
  MadeContext second = makers.osmesa();
  return second ? std::move(second) : refuse(first.error().message + "; " + second.error().message, {}, options);
}

}  // namespace throng::app
