#pragma once

#include <optional>
#include <string_view>

#include "app/recording/bytes.h"
#include "app/recording/recording.h"

namespace throng::app {

/// Reads a request from its payload; returns nothing where the payload is no such request. It does not read a tuning,
/// which has only what changed since the one before.
std::optional<RecordedRequest> read_request(RecordKind kind, std::string_view payload);

/// Reads the part of a frame that has a fixed size; returns nothing where the bytes are no such frame.
std::optional<RecordedFrame> read_frame(NumberReader& numbers);

}  // namespace throng::app
