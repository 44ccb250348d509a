#include "app/recording_reader.h"

#include <cmath>
#include <system_error>

#include "app/preset.h"
#include "app/recording_bytes.h"

namespace throng::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t most_header_bytes = 1U << 20U;
constexpr std::uint32_t most_hashes = 100'100;  // the agents, and what a scene adds to them
constexpr std::uint32_t most_pixels = 16384;
constexpr anim::Ticks longest_frame = 3600 * anim::ticks_per_second;

glm::vec3 next_vector(NumberReader& numbers) {
  glm::vec3 vector{0.0F};
  for (int axis = 0; axis < 3; ++axis) vector[axis] = numbers.next<float>();
  return vector;
}

bool is_near(const glm::vec3& vector) {
  constexpr float farthest = 1e6F;  // metres
  return std::abs(vector.x) <= farthest && std::abs(vector.y) <= farthest && std::abs(vector.z) <= farthest;
}

bool is_view(const LodView& view) {
  constexpr float pi = 3.14159265F;
  const render::Camera& camera = view.camera;
  const auto is_size = [](int pixels) { return pixels >= 1 && pixels <= static_cast<int>(most_pixels); };
  return is_near(camera.position) && std::isfinite(camera.yaw) && std::abs(camera.pitch) <= pi / 2.0F &&
         camera.vertical_view > 0.0F && camera.vertical_view < pi && is_size(view.width) && is_size(view.height);
}

RecordedSelection selection(NumberReader& numbers) {
  const auto agent = numbers.next<std::uint32_t>();
  return {agent == recorded_nobody ? std::nullopt : std::optional(agent)};
}

RecordedPush push(NumberReader& numbers) {
  const auto agent = numbers.next<std::uint32_t>();
  return {.agent = agent, .direction = next_vector(numbers)};
}

RecordedRoles roles(NumberReader& numbers) {
  RecordedRoles roles{.character = numbers.next<std::uint32_t>()};
  for (int& clip : roles.clips) clip = numbers.next<std::int32_t>();
  return roles;
}

RecordedFrame frame_head(NumberReader& numbers) {
  RecordedFrame frame;
  frame.delta = numbers.next<std::int64_t>();
  frame.view.camera.position = next_vector(numbers);
  frame.view.camera.yaw = numbers.next<float>();
  frame.view.camera.pitch = numbers.next<float>();
  frame.view.camera.vertical_view = numbers.next<float>();
  frame.view.width = static_cast<int>(numbers.next<std::uint32_t>());
  frame.view.height = static_cast<int>(numbers.next<std::uint32_t>());
  frame.pose_hash = numbers.next<std::uint64_t>();
  return frame;
}

}  // namespace

anim::Result<std::unique_ptr<RecordingReader>> RecordingReader::open(const fs::path& file) {
  std::unique_ptr<RecordingReader> reader(new RecordingReader(file));
  if (const auto complaint = reader->read_begin()) return anim::Error{file.string() + ": " + *complaint};
  return reader;
}

std::optional<std::string> RecordingReader::read_begin() {
  std::error_code error;
  if (!fs::is_regular_file(file_, error)) return "cannot be read";
  bytes_left_ = fs::file_size(file_, error);
  stream_.open(file_, std::ios::binary);
  if (error || !stream_) return "cannot be read";
  std::string bytes;
  const bool has_head = read_bytes(recording_magic.size() + 8, bytes);
  NumberReader head(bytes);
  if (!has_head || head.take(recording_magic.size()) != recording_magic) return "is no recording of throng";
  const auto version = head.next<std::uint32_t>();
  if (version != recording_version) {
    return "is a recording of version " + std::to_string(version) + "; this throng reads version " +
           std::to_string(recording_version);
  }
  const auto header_bytes = head.next<std::uint32_t>();
  if (header_bytes > most_header_bytes || !read_bytes(header_bytes, bytes)) return "is cut short in its header";
  if (auto complaint = read_header(bytes, header_)) return complaint;
  tuning_ = header_.tuning;
  return {};
}

bool RecordingReader::read_bytes(std::uint64_t count, std::string& bytes) {
  if (count > bytes_left_) return false;
  bytes.resize(count);
  stream_.read(bytes.data(), static_cast<std::streamsize>(count));
  bytes_left_ -= count;
  return static_cast<std::uint64_t>(stream_.gcount()) == count;
}

anim::Error RecordingReader::error_at(std::uint64_t frame, const std::string& what) const {
  return {file_.string() + ": frame " + std::to_string(frame) + ": " + what};
}

anim::Result<RecordedItem> RecordingReader::next() {
  const anim::Error cut_short{file_.string() + ": is cut short after frame " + std::to_string(frames_) +
                              "; record it again, and let that run end by itself"};
  constexpr std::uint64_t head_bytes = 5;
  if (!read_bytes(head_bytes, payload_)) return cut_short;
  NumberReader head(payload_);
  const auto kind = static_cast<RecordKind>(head.next<std::uint8_t>());
  if (!read_bytes(head.next<std::uint32_t>(), payload_)) return cut_short;
  std::optional<RecordedItem> read = item(kind);
  if (read) return std::move(*read);
  bytes_left_ = 0;
  return error_at(frames_ + 1, "is damaged; record it again");
}

std::optional<RecordedItem> RecordingReader::item(RecordKind kind) {
  if (kind == RecordKind::tuning) return changed_tuning();
  if (kind == RecordKind::frame) return frame();
  NumberReader numbers(payload_);
  const auto whole = [&](const auto& item) {
    return numbers.at_end() ? std::optional<RecordedItem>(item) : std::nullopt;
  };
  switch (kind) {
    case RecordKind::selection:
      return whole(selection(numbers));
    case RecordKind::push: {
      const RecordedPush pushed = push(numbers);
      return is_near(pushed.direction) ? whole(pushed) : std::nullopt;
    }
    case RecordKind::roles:
      return whole(roles(numbers));
    case RecordKind::end: {
      const RecordedEnd end{numbers.next<std::uint64_t>()};
      return end.frames == frames_ && bytes_left_ == 0 ? whole(end) : std::nullopt;
    }
    default:
      return std::nullopt;
  }
}

std::optional<RecordedItem> RecordingReader::changed_tuning() {
  Preset preset{.tuning = tuning_, .camera = {}};
  if (from_json(payload_, preset)) return std::nullopt;
  tuning_ = preset.tuning;
  return tuning_;
}

std::optional<RecordedItem> RecordingReader::frame() {
  NumberReader numbers(payload_);
  const RecordedFrame frame = frame_head(numbers);
  const auto agents = numbers.next<std::uint32_t>();
  const bool can_be = frame.delta >= 0 && frame.delta <= longest_frame && is_view(frame.view) && agents <= most_hashes;
  if (!numbers.good() || !can_be) return std::nullopt;
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
  return frame;
}

}  // namespace throng::app
