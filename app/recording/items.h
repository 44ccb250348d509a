#pragma once

#include <optional>
#include <string_view>

#include "app/recording/bytes.h"
#include "app/recording/recording.h"

namespace throng::app {

/// What was asked, of its kind's payload alone; nothing if it cannot be. Not the tuning, which says what changed since
/// the one before.
std::optional<RecordedRequest> read_request(RecordKind kind, std::string_view payload);

/// The fixed beginning of a frame; nothing if it cannot be.
std::optional<RecordedFrame> read_frame(NumberReader& numbers);

}  // namespace throng::app
