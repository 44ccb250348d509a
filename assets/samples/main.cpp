// throng_samples FOLDER: writes the files that the README's first steps name.

#include <cstdio>
#include <string>

#include "assets/samples/samples.h"
#include "engine/base/files/output_file.h"

namespace {

bool write(const std::string& file, const std::string& bytes) {
  const auto written = throng::write_whole_file(file, bytes);
  if (!written) std::fprintf(stderr, "throng_samples: %s\n", written.error().message.c_str());
  return static_cast<bool>(written);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("throng_samples: usage: throng_samples FOLDER\n", stderr);
    return 2;
  }
  const std::string folder = argv[1];
  const auto robot = throng::samples::make_robot();
  const bool all = write(folder + "/robot.glb", {reinterpret_cast<const char*>(robot.data()), robot.size()}) &&
                   write(folder + "/crossing.txt", throng::samples::make_crossing()) &&
                   write(folder + "/crossing.wkt", throng::samples::crossing_floor());
  return all ? 0 : 1;
}
