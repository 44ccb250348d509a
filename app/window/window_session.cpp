#include "app/window/window_session.h"

#include "app/show/painter.h"
#include "app/show/show.h"
#include "app/show/stage/stage.h"

namespace throng::app {

WindowSession::WindowSession(Show& show_in_window, const DemoOptions& given)
    : show(show_in_window),
      options(given),
      unsaved(show.stage().tuning()),
      input(show.painter().context().window()),
      camera(show),
      reporter(show),
      editor(show, reporter) {}

}  // namespace throng::app
