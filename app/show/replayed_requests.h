#pragma once

#include "app/recording/recording.h"
#include "app/show/show.h"
#include "engine/anim/base/result.h"

namespace throng::app {

/// Asks a show for what was recorded. The error is the end of a sentence: this show cannot do what the recording asks.
anim::Status repeat(const RecordedRequest& request, Show& show);

}  // namespace throng::app
