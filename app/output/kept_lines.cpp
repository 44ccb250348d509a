#include "app/output/kept_lines.h"

#include <array>
#include <cstddef>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/base/files/output_file.h"

namespace throng::app {
namespace {

namespace fs = std::filesystem;

bool is_line_of(const std::string& line, int frame) {
  return line.starts_with("{\"frame\":" + std::to_string(frame) + ",") && line.ends_with('}');
}

}  // namespace

KeptLines::KeptLines(const fs::path& file) : file_(file) {
  std::vector<fs::path> candidates = parts_left_beside(file);
  candidates.insert(candidates.begin(), file);
  fs::path best;
  int most = 0;
  for (const fs::path& candidate : candidates) {
    if (!read_from(candidate)) continue;
    int lines = 0;
    for (auto line = read_line(); line && is_line_of(*line, lines + 1); line = read_line()) ++lines;
    if (lines > most) most = lines, best = candidate;
  }
  if (most > 0 && read_from(best)) count_ = most;
}

bool KeptLines::read_from(const fs::path& file) {
  input_.reset();
  pending_.clear();
  auto input = InputFile::open(file);
  if (input) input_.emplace(std::move(*input));
  return input_.has_value();
}

std::optional<std::string> KeptLines::read_line() {
  std::array<std::byte, 65536> buffer;
  std::size_t looked_at = 0;
  while (true) {
    const std::size_t end = pending_.find('\n', looked_at);
    if (end != std::string::npos) {
      std::string line = pending_.substr(0, end);
      pending_.erase(0, end + 1);
      return line;
    }
    looked_at = pending_.size();
    const auto read = input_->read(buffer);
    if (!read || *read == 0) return {};
    pending_.append(reinterpret_cast<const char*>(buffer.data()), *read);
  }
}

std::optional<std::string> KeptLines::next() {
  if (given_ == count_) return {};
  ++given_;
  return read_line();
}

void KeptLines::remove_parts() const {
  std::error_code error;
  for (const fs::path& part : parts_left_beside(file_)) fs::remove(part, error);
}

}  // namespace throng::app
