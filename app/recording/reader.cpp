#include "app/recording/reader.h"

#include <algorithm>
#include <system_error>

#include "app/files/byte_hash.h"
#include "app/recording/bytes.h"
#include "app/recording/items.h"
#include "app/settings/preset.h"

namespace throng::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t most_header_bytes = 1U << 24U;
constexpr std::uint32_t most_hashes = 100'100;  // the agents, and what a scene adds to them
constexpr std::uint64_t item_head_bytes = 5, checksum_bytes = 8;

// Of as many bytes of the file, from its first.
std::optional<std::uint64_t> hash_of(std::istream& stream, std::uint64_t count) {
  constexpr std::uint64_t most_at_once = 1U << 16U;
  ByteHash hash;
  std::string bytes;
  for (stream.seekg(0); count > 0; count -= bytes.size()) {
    bytes.resize(std::min(count, most_at_once));
    if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) return {};
    hash.add(bytes);
  }
  return hash.value();
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
  if (is_damaged()) return "is damaged: its bytes do not add up to its checksum; record it again";
  const auto header_bytes = head.next<std::uint32_t>();
  if (header_bytes > most_header_bytes || !read_bytes(header_bytes, bytes)) return "is cut short in its header";
  if (auto complaint = read_header(bytes, header_)) return complaint;
  tuning_ = header_.tuning;
  return {};
}

// Only what was ended has a checksum; what was cut short is read as far as it goes.
bool RecordingReader::is_damaged() {
  constexpr std::uint64_t end_bytes = item_head_bytes + end_payload_bytes;
  const std::uint64_t next_item = static_cast<std::uint64_t>(stream_.tellg()), all = next_item + bytes_left_;
  if (bytes_left_ < end_bytes) return false;
  std::string bytes(end_bytes, '\0');
  stream_.seekg(static_cast<std::streamoff>(all - end_bytes));
  stream_.read(bytes.data(), static_cast<std::streamsize>(end_bytes));
  NumberReader end(bytes);
  const bool is_ended = end.next<std::uint8_t>() == static_cast<std::uint8_t>(RecordKind::end) &&
                        end.next<std::uint32_t>() == end_payload_bytes;
  end.next<std::uint64_t>();
  const bool damaged = is_ended && hash_of(stream_, all - checksum_bytes) != end.next<std::uint64_t>();
  stream_.seekg(static_cast<std::streamoff>(next_item));
  return damaged;
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
  if (kind == RecordKind::tuning) return changed_tuning();
  if (kind == RecordKind::frame) return frame();
  if (kind == RecordKind::end) return end();
  return read_request(kind, payload_);
}

std::optional<RecordedItem> RecordingReader::changed_tuning() {
  Preset preset{.tuning = tuning_, .camera = {}};
  if (from_json_text(payload_, preset)) return std::nullopt;
  tuning_ = preset.tuning;
  return RecordedRequest(tuning_);
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
