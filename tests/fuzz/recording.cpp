// Recordings, item by item: the bytes as they are, and with the checksum that they should have.

#include "app/files/byte_hash.h"
#include "app/show/recording/bytes.h"
#include "app/show/recording/reader.h"
#include "tests/fuzz/scratch_file.h"
#include "tests/fuzz/target.h"

namespace throng::fuzz {
namespace {

std::string with_true_checksum(std::string bytes) {
  bytes.resize(bytes.size() - sizeof(std::uint64_t));
  app::ByteHash hash;
  hash.add(bytes);
  app::append_number(bytes, hash.value());
  return bytes;
}

void read_all(const std::string& path) {
  const auto reader = app::RecordingReader::open(path);
  if (!reader) return;
  for (;;) {
    const auto item = (*reader)->next();
    if (!item || std::holds_alternative<app::RecordedEnd>(*item)) return;
  }
}

}  // namespace
}  // namespace throng::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace throng;
  static const fuzz::ScratchFile file("input.rec");
  file.put(data, size);
  fuzz::read_all(file.path());
  if (size < sizeof(std::uint64_t)) return 0;
  const std::string bytes = fuzz::with_true_checksum({reinterpret_cast<const char*>(data), size});
  file.put(std::as_bytes(std::span(bytes)));
  fuzz::read_all(file.path());
  return 0;
}
