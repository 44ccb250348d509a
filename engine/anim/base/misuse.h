#pragma once

#include "throng/host.h"

#include "engine/anim/base/result.h"

namespace throng::anim {

using throng::Misuse, throng::MisuseHook, throng::set_misuse_hook;

/// Tells the hook of a misuse. Returns false, which is what a call that was ignored returns.
bool report_misuse(const Misuse& misuse);

/// Tells the hook of a misuse, and returns it as the error of the call.
Error refuse(const Misuse& misuse);

}  // namespace throng::anim
