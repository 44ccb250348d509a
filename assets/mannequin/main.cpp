#include <cstdio>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "assets/mannequin/glb.h"

/// Writes beside the target first, so that no half-written file is ever seen.
static bool write_file(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  std::filesystem::path beside = path;
  beside += ".part";
  std::ofstream stream(beside, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  std::error_code failure;
  if (stream) {
    std::filesystem::rename(beside, path, failure);
    if (!failure) return true;
  }
  std::filesystem::remove(beside, failure);
  return false;
}

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("throng_mannequin: usage: throng_mannequin FILE.glb\n", stderr);
    return 2;
  }
  if (!write_file(argv[1], throng::mannequin::make_mannequin())) {
    std::fprintf(stderr, "throng_mannequin: %s: cannot be written; name a file in a folder you can write to\n",
                 argv[1]);
    return 1;
  }
  return 0;
}
