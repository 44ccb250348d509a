#pragma once

#include "app/recording/recording.h"
#include "app/show/show.h"
#include "engine/anim/base/result.h"

namespace throng::app {

/// Asks a show for what was recorded. Errors, the end of a sentence: the recording asks for what cannot be here.
anim::Status repeat(const RecordedRequest& request, Show& show);

}  // namespace throng::app
