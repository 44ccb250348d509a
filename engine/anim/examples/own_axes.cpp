// A host with other axes and units: converts places, rotations and matrices, and compares what they do in its space.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "throng/throng.h"

using namespace throng;

namespace {

/// The host's axis i is Throng's axis from[i], times sign[i]; a metre is `units` long.
struct Axes {
  const char* name;
  int from[3];
  float sign[3];
  float units;
};

constexpr Axes spaces[] = {{"Y up, left-handed, faces +Z, metres", {0, 1, 2}, {-1, 1, 1}, 1},
                           {"Z up, left-handed, faces +X, centimetres", {2, 0, 1}, {1, -1, 1}, 100},
                           {"Z up, right-handed, faces -Y, metres", {0, 2, 1}, {1, -1, 1}, 1},
                           {"Z up, right-handed, faces +X, metres", {2, 0, 1}, {1, 1, 1}, 1}};

Vec3 place_in(const Axes& axes, const Vec3& p) {
  const float in[3] = {p.x, p.y, p.z}, *const s = axes.sign;
  return {axes.units * s[0] * in[axes.from[0]], axes.units * s[1] * in[axes.from[1]],
          axes.units * s[2] * in[axes.from[2]]};
}

/// The axis of a rotation changes as a place does, and turns about where the host's axes are mirrored.
Quat rotation_in(const Axes& axes, const Quat& q) {
  const float in[3] = {q.x, q.y, q.z}, *const s = axes.sign;
  const bool is_cyclic = axes.from[1] == (axes.from[0] + 1) % 3;
  const float side = (is_cyclic ? 1.0F : -1.0F) * s[0] * s[1] * s[2];
  return {side * s[0] * in[axes.from[0]], side * s[1] * in[axes.from[1]], side * s[2] * in[axes.from[2]], q.w};
}

/// Takes three rows of four for column vectors. A host with row vectors reads columns[i] as row i.
Mat4 matrix_in(const Axes& axes, const float* rows) {
  Mat4 out;
  for (int i = 0; i < 3; ++i) {
    const float* const row = rows + 4 * axes.from[i];
    for (int j = 0; j < 3; ++j) out.columns[j][i] = axes.sign[i] * axes.sign[j] * row[axes.from[j]];
    out.columns[3][i] = axes.units * axes.sign[i] * row[3];
  }
  return out;
}

Vec3 moved(const Mat4& m, const Vec3& p) {
  const auto row = [&](int i) { return m.columns[0][i] * p.x + m.columns[1][i] * p.y + m.columns[2][i] * p.z; };
  return {row(0) + m.columns[3][0], row(1) + m.columns[3][1], row(2) + m.columns[3][2]};
}

Vec3 turned(const Quat& q, const Vec3& v) {
  const Vec3 t{2 * (q.y * v.z - q.z * v.y), 2 * (q.z * v.x - q.x * v.z), 2 * (q.x * v.y - q.y * v.x)};
  return {v.x + q.w * t.x + q.y * t.z - q.z * t.y, v.y + q.w * t.y + q.z * t.x - q.x * t.z,
          v.z + q.w * t.z + q.x * t.y - q.y * t.x};
}

float apart(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return std::fprintf(stderr, "usage: own_axes MODEL\n"), 2;
  const auto file = load(arguments[1]);
  if (!file) return std::fprintf(stderr, "%s\n", file.error().message.c_str()), 1;
  const Character character = file->characters.front();
  auto crowd = Crowd::create(character);
  if (!crowd) return std::fprintf(stderr, "%s\n", crowd.error().message.c_str()), 1;
  const Agent agent = crowd->agent(crowd->add_agent());
  agent.play({.clip = {character.clip_count() - 1}});
  const auto socket = agent.add(Socket{.bone = character.bone_count() / 2});
  struct alignas(16) Row {
    float numbers[4];
  };
  std::vector<Row> palette(crowd->palette_bytes(0) / sizeof(Row));
  const PoseRequest request{.agent = agent.id(), .palette = reinterpret_cast<std::byte*>(palette.data())};
  crowd->advance(ticks_per_second / 2);
  crowd->update({&request, 1});

  const Vec3 point{0.3F, 1.2F, -0.1F};
  const Place place = socket ? agent.processes().socket(*socket) : Place{};
  for (const Axes& axes : spaces) {
    float worst = apart(place_in(axes, turned(place.rotation, point)),
                        turned(rotation_in(axes, place.rotation), place_in(axes, point)));
    for (std::size_t entry = 0; entry < character.palette_entries(); ++entry) {
      const float* const rows = palette[3 * entry].numbers;
      const Vec3 here = moved(matrix_in({"as Throng", {0, 1, 2}, {1, 1, 1}, 1}, rows), point);
      worst = std::max(worst, apart(place_in(axes, here), moved(matrix_in(axes, rows), place_in(axes, point))));
    }
    std::printf("%s: %s\n", axes.name, worst < 1e-4F * axes.units ? "agrees" : "differs");
  }
}
