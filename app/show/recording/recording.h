#pragma once

#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

#include "throng/render/camera.h"
#include "throng/ticks.h"

#include "app/settings/settings.h"
#include "app/show/request/request.h"

namespace throng::app {

/// A recording has the requests to a crowd and the poses that came of them, frame by frame, in one file. Numbers are
/// little-endian; lengths are in bytes.
///
///     "THRONGRC"  version u32  length u32  header: JSON          RecordingHeader
///     kind u8  length u32  payload                               again and again: what was asked, then a frame
///
///     kind        payload
///     request     JSON (app/show/request/request_json.h), with the values that changed since the request before
///     frame       delta i64 (ticks), camera 6 x f32, width u32, height u32, pose hash u64, agents u32,
///                 a bit for each agent whose hash changed, from the lowest; their hashes, u16
///     end         frames u64, ByteHash u64 of all bytes of the file before it
inline constexpr std::string_view recording_magic = "THRONGRC";
inline constexpr std::uint32_t recording_version = 4;
inline constexpr std::uint32_t end_payload_bytes = 16;
enum class RecordKind : std::uint8_t { request = 1, frame, end };

struct RecordingHeader {
  std::vector<ChosenCharacter> characters;  ///< people, 1 to most_models, with their fingerprints
  Tuning tuning;                            ///< of the first frame, with its cost coefficients
  int width = 0, height = 0;                ///< pixels
};

/// The camera and the size of the picture that level of detail decided by.
struct LodView {
  render::Camera camera;
  int width = 0, height = 0;
};

struct RecordedFrame {
  Ticks delta{};  ///< 0 while paused
  LodView view;
  std::uint64_t pose_hash = 0;
};
/// Follows the last frame. A recording without it was cut short.
struct RecordedEnd {
  std::uint64_t frames = 0;
};
using RecordedItem = std::variant<CrowdRequest, RecordedFrame, RecordedEnd>;

/// Returns the part of an agent's hash that a recording keeps.
constexpr std::uint16_t short_hash(std::uint64_t hash) { return static_cast<std::uint16_t>(hash >> 48U); }

/// Why a recorded crowd is not recorded: a recording does not hold the rows of a file, nor the moves of its clock.
inline constexpr const char* no_recording_of_tracks =
    "the scene tracks is not recorded: its file shows the same each time, from any --start at any --track-rate";

}  // namespace throng::app
