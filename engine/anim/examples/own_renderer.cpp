// A renderer of one's own: skins on the CPU and draws dots into a picture (PPM) on standard output. A real one uploads
// the palettes.
#include <algorithm>
#include <cstdio>
#include <vector>

#include "throng/throng.h"

using namespace throng;

namespace {

constexpr int width = 640;
constexpr int height = 360;

/// Returns a vertex as the palette poses it: the sum of weight * (matrix * position). A matrix has three rows of four.
Vec3 skinned(const MeshView& mesh, std::size_t vertex, const float* palette) {
  const Vec3 p = mesh.positions[vertex];
  float out[3] = {};
  for (std::size_t i = 0; i < 4; ++i) {
    const float* const rows = palette + std::size_t{12} * mesh.palette_entries[vertex][i];
    for (int r = 0; r < 3; ++r) {
      const float* const row = rows + 4 * r;
      out[r] += mesh.weights[vertex][i] * (row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3]);
    }
  }
  return {out[0], out[1], out[2]};
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return std::fprintf(stderr, "usage: own_renderer MODEL > PICTURE.ppm\n"), 2;
  const auto file = load(arguments[1], {.keep_meshes = true});
  if (!file) return std::fprintf(stderr, "%s\n", file.error().message.c_str()), 1;
  const Character character = file->characters.front();
  auto crowd = Crowd::create(character, {.pus = 2});
  if (!crowd) return std::fprintf(stderr, "%s\n", crowd.error().message.c_str()), 1;

  // One buffer for all palettes, as a storage buffer of a device would be. Vectors of rows are aligned to 16 bytes.
  struct alignas(64) Line {
    float floats[16];
  };
  const std::size_t lines = crowd->palette_bytes(0) / sizeof(Line);
  std::vector<Line> palettes(lines * 8);
  std::vector<PoseRequest> requests;
  for (const AgentId id : crowd->add_agents(8)) {
    crowd->agent(id).play({.clip = {id.number % character.clip_count()}, .start = Ticks{}});
    requests.push_back({.agent = id, .palette = reinterpret_cast<std::byte*>(&palettes[id.number * lines])});
  }
  crowd->advance(ticks_per_second / 2);
  crowd->update(requests);

  std::vector<unsigned char> picture(std::size_t{3} * width * height, 24);
  const auto pixels_a_metre = static_cast<float>(0.7 * height / character.height());
  for (const PoseRequest& request : requests) {
    for (std::size_t m = 0; m < character.mesh_count(); ++m) {
      const MeshView mesh = character.mesh(m);
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const Vec3 p = skinned(mesh, v, reinterpret_cast<const float*>(request.palette));
        const int x = static_cast<int>(78.0F * static_cast<float>(request.agent.number) + 47.0F + pixels_a_metre * p.x);
        const int y = static_cast<int>(0.95F * height - pixels_a_metre * p.y);
        if (x < 0 || x >= width || y < 0 || y >= height) continue;
        const std::size_t pixel = std::size_t{3} * static_cast<std::size_t>(y * width + x);
        std::fill_n(picture.begin() + static_cast<std::ptrdiff_t>(pixel), 3, static_cast<unsigned char>(230));
      }
    }
  }
  std::printf("P6\n%d %d\n255\n", width, height);
  std::fwrite(picture.data(), 1, picture.size(), stdout);
  if (std::fflush(stdout) != 0) return std::perror("standard output"), 1;
  std::fprintf(stderr, "drew %zu characters\n", requests.size());
  return 0;
}
