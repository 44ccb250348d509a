#include <cstdio>
#include <string_view>

#include "assets/mannequin/glb.h"
#include "engine/base/files/output_file.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("throng_mannequin: usage: throng_mannequin FILE.glb\n", stderr);
    return 2;
  }
  const auto bytes = throng::mannequin::make_mannequin();
  const auto written = throng::write_whole_file(argv[1], {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  if (!written) std::fprintf(stderr, "throng_mannequin: %s\n", written.error().message.c_str());
  return written ? 0 : 1;
}
