#pragma once

#include <functional>
#include <memory>

#include "throng/render/context.h"

#include "app/settings/settings.h"

namespace throng::app {

using MadeContext = Result<std::unique_ptr<render::gl::Context>>;

/// Makes a context of each kind.
struct ContextMakers {
  std::function<MadeContext()> window, egl, osmesa;
};

/// Returns the functions that make the contexts that the options describe.
ContextMakers context_makers(const DemoOptions& options);

/// Opens the context that the options ask for, which is not ContextKind::none. Errors: one line that says why each
/// tried context does not open. The line advises another context only if that context has just been opened, and
/// `--headless=none` only if no picture is asked for, so the advised context does not fail in its turn.
MadeContext open_context(const DemoOptions& options, const ContextMakers& makers);

}  // namespace throng::app
