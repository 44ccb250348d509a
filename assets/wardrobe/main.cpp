// throng_wardrobe FILE.glb [--outfit BODY,PART,...]: the wardrobe, or a character that wears an outfit.

#include <cstdio>
#include <string_view>

#include "assets/mannequin/glb.h"
#include "assets/wardrobe/glb.h"
#include "assets/wardrobe/outfit.h"
#include "engine/base/files/output_file.h"

namespace {

namespace wardrobe = throng::wardrobe;

int write(const char* path, const std::vector<std::byte>& bytes) {
  const auto written = throng::write_whole_file(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  if (!written) std::fprintf(stderr, "throng_wardrobe: %s\n", written.error().message.c_str());
  return written ? 0 : 1;
}

int write_outfit(const char* path, std::string_view text) {
  const auto outfit = wardrobe::read_outfit(text);
  if (!outfit) return 2;
  const auto parts = wardrobe::finish_wardrobe(outfit->parts, false);
  return write(
      path, throng::mannequin::write_glb(wardrobe::dressed(*outfit, parts, 0, true), throng::mannequin::make_clips()));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2) return write(argv[1], wardrobe::make_wardrobe());
  if (argc == 4 && std::string_view(argv[2]) == "--outfit") return write_outfit(argv[1], argv[3]);
  std::fputs("throng_wardrobe: usage: throng_wardrobe FILE.glb [--outfit BODY,PART,...]\n", stderr);
  return 2;
}
