#include "app/show/recording/writer.h"

#include "app/settings/preset.h"
#include "app/show/recording/bytes.h"
#include "app/show/request/request_json.h"

namespace throng::app {
namespace {

std::string header_text(const RecordingHeader& header) {
  const Json json = {{"width", header.width},
                     {"height", header.height},
                     {"characters", to_json(header.characters)},
                     {"tuning", to_json(Preset{.tuning = header.tuning, .camera = {}})}};
  return json.dump();
}

std::string item_head(RecordKind kind, std::size_t payload_bytes) {
  std::string head;
  append_number(head, static_cast<std::uint8_t>(kind));
  append_number(head, static_cast<std::uint32_t>(payload_bytes));
  return head;
}

}  // namespace

Result<std::unique_ptr<RecordingWriter>> RecordingWriter::create(const std::filesystem::path& file,
                                                                 const RecordingHeader& header) {
  auto beside = OutputFile::create(file, OutputFile::Unfinished::kept);
  if (!beside) return beside.error();
  std::unique_ptr<RecordingWriter> writer(new RecordingWriter(std::move(*beside), header.tuning));
  const std::string text = header_text(header);
  std::string begin(recording_magic);
  append_number(begin, recording_version);
  append_number(begin, static_cast<std::uint32_t>(text.size()));
  writer->write(begin + text);
  return writer;
}

void RecordingWriter::write(std::string_view bytes) {
  written_.add(bytes);
  if (state_) state_ = file_.write(bytes);
}

void RecordingWriter::write_item(RecordKind kind) {
  write(item_head(kind, payload_.size()));
  write(payload_);
  payload_.clear();
}

void RecordingWriter::add(const CrowdRequest& request) {
  payload_ = to_json(request, tuning_).dump();
  if (const auto* const values = std::get_if<Apply>(&request)) tuning_ = values->tuning;
  write_item(RecordKind::request);
}

void RecordingWriter::add(const RecordedFrame& frame, std::span<const std::uint64_t> agent_hashes) {
  const render::Camera& camera = frame.view.camera;
  append_number(payload_, frame.delta.count());
  for (int axis = 0; axis < 3; ++axis) append_number(payload_, camera.position[axis]);
  for (const float angle : {camera.yaw, camera.pitch, camera.vertical_view}) append_number(payload_, angle);
  append_number(payload_, static_cast<std::uint32_t>(frame.view.width));
  append_number(payload_, static_cast<std::uint32_t>(frame.view.height));
  append_number(payload_, frame.pose_hash);
  append_number(payload_, static_cast<std::uint32_t>(agent_hashes.size()));
  add_changed_hashes(agent_hashes);
  write_item(RecordKind::frame);
  ++frames_;
}

// A bit an agent, then the hashes of the agents whose bit is set.
void RecordingWriter::add_changed_hashes(std::span<const std::uint64_t> agent_hashes) {
  hashes_.resize(agent_hashes.size(), 0);
  const std::size_t bits = payload_.size();
  payload_.resize(bits + (agent_hashes.size() + 7) / 8, '\0');
  for (std::size_t agent = 0; agent < agent_hashes.size(); ++agent) {
    const std::uint16_t hash = short_hash(agent_hashes[agent]);
    if (hash == hashes_[agent]) continue;
    hashes_[agent] = hash;
    char& byte = payload_[bits + agent / 8];
    byte = static_cast<char>(byte | (1 << agent % 8));
    append_number(payload_, hash);
  }
}

Status RecordingWriter::finish() {
  append_number(payload_, frames_);
  write(item_head(RecordKind::end, end_payload_bytes));
  write(payload_);
  std::string checksum;
  append_number(checksum, written_.value());
  if (state_) state_ = file_.write(checksum);
  if (state_) state_ = file_.commit();
  std::error_code error;
  const bool has_part = !file_.part().empty() && std::filesystem::file_size(file_.part(), error) > 0 && !error;
  if (state_ || !has_part) return state_;
  return Error{state_.error().message + "; the frames before are in " + file_.part().string()};
}

}  // namespace throng::app
