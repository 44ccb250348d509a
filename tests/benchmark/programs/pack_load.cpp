// How much longer importing a model takes than opening a pack of it: throng_pack_load MODEL.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "engine/anim/import/import.h"
#include "engine/anim/pack/pack.h"

namespace throng {
namespace {

constexpr int rounds = 15;

template <typename Work>
double milliseconds(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

std::string write_pack_of(const std::string& model) {
  auto file = import::import_file(model);
  if (!file) return std::fprintf(stderr, "%s\n", file.error().message.c_str()), std::string();
  pack::FileToPack packed{.name = "model", .file = std::move(*file), .characters = {}};
  auto character = std::make_shared<const anim::Character>(anim::bake_character(packed.file.models.front()));
  packed.characters.push_back({.name = "model", .prepared = {}, .character = std::move(character), .surface = {}});
  const std::vector<std::byte> bytes = pack::write_pack({&packed, 1});
  const std::string path = (std::filesystem::temp_directory_path() / "throng_pack_load.pack").string();
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return path;
}

int run(const std::string& model) {
  const std::string path = write_pack_of(model);
  if (path.empty()) return 1;
  std::vector<double> imports, loads, ratios;
  bool opened = true;
  for (int round = 0; round < rounds; ++round) {
    imports.push_back(milliseconds([&] { opened &= import::import_file(model).has_value(); }));
    loads.push_back(milliseconds([&] {
      const auto pack = pack::Pack::open(path);
      opened &= pack && pack->character();
    }));
    ratios.push_back(imports.back() / loads.back());
  }
  std::filesystem::remove(path);
  std::printf("import %.2f ms, pack %.3f ms, ratio %.0f (medians of %d rounds)\n", median(imports), median(loads),
              median(ratios), rounds);
  return opened ? 0 : 1;
}

}  // namespace
}  // namespace throng

int main(int argument_count, char** arguments) {
  if (argument_count == 2) return throng::run(arguments[1]);
  return std::fprintf(stderr, "throng_pack_load MODEL\n"), 2;
}
