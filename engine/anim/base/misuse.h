#pragma once

#include "engine/anim/base/result.h"

namespace throng::anim {

/// A call that broke its contract: an id of nothing, a number that is none, a call at the wrong time. The library
/// ignores such a call and leaves everything as it was.
struct Misuse {
  const char* call;    ///< the function, as "Agent::play"
  const char* reason;  ///< one sentence; both live as long as the hook is called
};

/// Hears of each misuse, on the thread that made the call. It does not call the library.
using MisuseHook = void (*)(const Misuse& misuse);

/// Sets who hears of misuses, from any thread, and returns who heard of them before. The hook that is there at first,
/// and again after nullptr, prints one line for each call and reason. A build with assertions then ends the program.
MisuseHook set_misuse_hook(MisuseHook hook);

/// Tells the hook of a misuse. Returns false, which is what a call that was ignored returns.
bool report_misuse(const Misuse& misuse);

/// Tells the hook of a misuse, and returns it as the error of the call.
Error refuse(const Misuse& misuse);

}  // namespace throng::anim
