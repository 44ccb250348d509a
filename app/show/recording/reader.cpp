#include "app/show/recording/reader.h"

#include <algorithm>
#include <cmath>

#include "app/files/byte_hash.h"
#include "app/settings/preset.h"
#include "app/show/recording/bytes.h"
#include "app/show/request/request_json.h"
#include "engine/base/json/json_object.h"

namespace throng::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t most_header_bytes = 1U << 24U;
constexpr std::uint32_t most_hashes = 100'100;  // the agents, and agents that a scene adds
constexpr std::uint64_t item_head_bytes = 5, checksum_bytes = 8;

/// Returns the longest frame that options and the clock of a window allow.
Ticks longest_frame() { return to_ticks(most_frame_seconds * static_cast<double>(most_time_scale)); }

glm::vec3 next_vector(NumberReader& numbers) {
  glm::vec3 vector{0.0F};
  for (int axis = 0; axis < 3; ++axis) vector[axis] = numbers.next<float>();
  return vector;
}

bool is_near(float metres) { return std::abs(metres) <= farthest_camera; }
bool is_near(const glm::vec3& vector) { return is_near(vector.x) && is_near(vector.y) && is_near(vector.z); }

bool is_view(const LodView& view) {
  constexpr float pi = 3.14159265F;
  const render::Camera& camera = view.camera;
  const auto is_size = [](int pixels) { return pixels >= 1 && pixels <= most_picture_pixels; };
  return is_near(camera.position) && std::isfinite(camera.yaw) && std::abs(camera.pitch) <= pi / 2.0F &&
         camera.vertical_view > 0.0F && camera.vertical_view < pi && is_size(view.width) && is_size(view.height);
}

/// Reads the part of a frame that has a fixed size; returns nothing where the bytes are no such frame.
std::optional<RecordedFrame> read_frame(NumberReader& numbers) {
  RecordedFrame frame;
  frame.delta = Ticks{numbers.next<std::int64_t>()};
  frame.view.camera.position = next_vector(numbers);
  frame.view.camera.yaw = numbers.next<float>();
  frame.view.camera.pitch = numbers.next<float>();
  frame.view.camera.vertical_view = numbers.next<float>();
  frame.view.width = static_cast<int>(numbers.next<std::uint32_t>());
  frame.view.height = static_cast<int>(numbers.next<std::uint32_t>());
  frame.pose_hash = numbers.next<std::uint64_t>();
  const bool can_be = frame.delta >= Ticks{} && frame.delta <= longest_frame() && is_view(frame.view);
  return numbers.good() && can_be ? std::optional(frame) : std::nullopt;
}

/// Returns what is wrong, as the end of a sentence; nothing where the header was read.
std::optional<std::string> read_header(std::string_view text, RecordingHeader& header) {
  const auto json = parse_json(text);
  if (!json) return json.error().message;
  std::optional<std::string> complaint;
  const JsonObject reader("", *json, {"width", "height", "characters", "tuning"}, complaint);
  reader.need({"width", "height", "characters", "tuning"});
  reader.whole("width", header.width, 1, most_picture_pixels);
  reader.whole("height", header.height, 1, most_picture_pixels);
  header.characters = read_characters(reader["characters"], complaint);
  Preset preset;
  if (!complaint) complaint = from_json(reader["tuning"], preset);
  header.tuning = preset.tuning;
  return complaint;
}

}  // namespace

Result<std::unique_ptr<RecordingReader>> RecordingReader::open(const fs::path& file) {
  auto input = InputFile::open(file, "a recording of throng");
  if (!input) return Error{file.string() + ": " + input.error().message};
  std::unique_ptr<RecordingReader> reader(new RecordingReader(file, std::move(*input)));
  if (const auto complaint = reader->read_begin()) return Error{file.string() + ": " + *complaint};
  return reader;
}

std::optional<std::string> RecordingReader::read_begin() {
  std::string bytes;
  const bool has_head = read_bytes(recording_magic.size() + 8, bytes);
  NumberReader head(bytes);
  if (!has_head || head.take(recording_magic.size()) != recording_magic) return "is no recording of throng";
  const auto version = head.next<std::uint32_t>();
  if (version != recording_version) {
    return "is a recording of version " + std::to_string(version) + "; this throng reads version " +
           std::to_string(recording_version);
  }
  if (is_damaged()) return "is damaged: its bytes do not add up to its checksum; record it again";
  const auto header_bytes = head.next<std::uint32_t>();
  if (header_bytes > most_header_bytes || !read_bytes(header_bytes, bytes)) return "is cut short in its header";
  if (const auto complaint = read_header(bytes, header_)) return "is damaged in its header: " + *complaint;
  tuning_ = header_.tuning;
  bytes_of_items_ = bytes_left_;
  return {};
}

// A recording has a checksum once it was ended. One that was cut short is read as far as it goes.
bool RecordingReader::is_damaged() {
  constexpr std::uint64_t end_bytes = item_head_bytes + end_payload_bytes;
  const std::uint64_t left = bytes_left_, all = input_.size();
  if (left < end_bytes || !input_.go_to(all - end_bytes)) return false;
  std::string bytes;
  if (!read_bytes(end_bytes, bytes)) return true;
  NumberReader end(bytes);
  const bool is_ended = end.next<std::uint8_t>() == static_cast<std::uint8_t>(RecordKind::end) &&
                        end.next<std::uint32_t>() == end_payload_bytes;
  end.next<std::uint64_t>();
  const bool damaged = is_ended && hash_of_first(all - checksum_bytes) != end.next<std::uint64_t>();
  bytes_left_ = left;
  return damaged || !input_.go_to(all - left);
}

std::optional<std::uint64_t> RecordingReader::hash_of_first(std::uint64_t count) {
  constexpr std::uint64_t most_at_once = 1U << 16U;
  ByteHash hash;
  std::string bytes;
  if (!input_.go_to(0)) return {};
  for (bytes_left_ = count; bytes_left_ > 0;) {
    if (!read_bytes(std::min(bytes_left_, most_at_once), bytes)) return {};
    hash.add(bytes);
  }
  return hash.value();
}

bool RecordingReader::read_bytes(std::uint64_t count, std::string& bytes) {
  if (count > bytes_left_) return false;
  bytes.resize(count);
  const auto read = input_.read(std::as_writable_bytes(std::span(bytes)));
  bytes_left_ -= count;
  return read && *read == count;
}

std::uint64_t RecordingReader::count_frames() {
  const std::uint64_t left = bytes_left_, all = input_.size();
  std::uint64_t frames = 0;
  std::string bytes;
  for (bytes_left_ = bytes_of_items_; input_.go_to(all - bytes_left_) && read_bytes(item_head_bytes, bytes);) {
    NumberReader head(bytes);
    const auto kind = static_cast<RecordKind>(head.next<std::uint8_t>());
    const auto length = head.next<std::uint32_t>();
    if (length > bytes_left_) break;
    frames += kind == RecordKind::frame ? 1 : 0;
    bytes_left_ -= length;
  }
  bytes_left_ = input_.go_to(all - left) ? left : 0;
  return frames;
}

void RecordingReader::begin_anew() {
  bytes_left_ = input_.go_to(input_.size() - bytes_of_items_) ? bytes_of_items_ : 0;
  tuning_ = header_.tuning;
  frames_ = 0;
  hashes_.clear();
}

Error RecordingReader::error_at(std::uint64_t frame, const std::string& what) const {
  return {file_.string() + ": frame " + std::to_string(frame) + ": " + what};
}

Result<RecordedItem> RecordingReader::next() {
  const Error cut_short{file_.string() + ": is cut short after frame " + std::to_string(frames_) +
                        "; record it again, and let that run end by itself"};
  if (!read_bytes(item_head_bytes, payload_)) return cut_short;
  NumberReader head(payload_);
  const auto kind = static_cast<RecordKind>(head.next<std::uint8_t>());
  if (!read_bytes(head.next<std::uint32_t>(), payload_)) return cut_short;
  std::optional<RecordedItem> read = item(kind);
  if (read) return std::move(*read);
  bytes_left_ = 0;
  return error_at(frames_ + 1, "is damaged; record it again");
}

std::optional<RecordedItem> RecordingReader::item(RecordKind kind) {
  if (kind == RecordKind::request) return request();
  if (kind == RecordKind::frame) return frame();
  return kind == RecordKind::end ? end() : std::nullopt;
}

std::optional<RecordedItem> RecordingReader::request() {
  const auto json = parse_json(payload_);
  auto request = json ? read_request(*json, tuning_) : json.error();
  if (!request) return std::nullopt;
  if (const auto* const values = std::get_if<Apply>(&*request)) tuning_ = values->tuning;
  return RecordedItem(std::move(*request));
}

std::optional<RecordedItem> RecordingReader::end() const {
  const RecordedEnd end{NumberReader(payload_).next<std::uint64_t>()};
  const bool can_be = end.frames == frames_ && payload_.size() == end_payload_bytes && bytes_left_ == 0;
  return can_be ? std::optional<RecordedItem>(end) : std::nullopt;
}

std::optional<RecordedItem> RecordingReader::frame() {
  NumberReader numbers(payload_);
  const std::optional<RecordedFrame> frame = read_frame(numbers);
  const auto agents = numbers.next<std::uint32_t>();
  if (!frame || !numbers.good() || agents > most_hashes) return std::nullopt;
  const std::string_view changed = numbers.take((agents + 7) / 8);
  if (!numbers.good()) return std::nullopt;
  hashes_.resize(agents, 0);
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    if ((static_cast<unsigned char>(changed[agent / 8]) >> agent % 8 & 1) != 0) {
      hashes_[agent] = numbers.next<std::uint16_t>();
    }
  }
  if (!numbers.at_end()) return std::nullopt;
  ++frames_;
  return *frame;
}

}  // namespace throng::app
