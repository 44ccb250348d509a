#include "tests/fuzz/scratch_file.h"

#include <cstdlib>
#include <fstream>

namespace throng::fuzz {

void ScratchFile::put(std::span<const std::byte> bytes) const {
  std::ofstream stream(file_, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) std::abort();  // a full disk is no finding, but nothing would be tried
}

}  // namespace throng::fuzz
