#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace throng::places {

using glm::dvec3;

/// Says how a surface takes light; in the file, as engine/render/scenery_data.h has it.
enum class Kind : std::uint8_t { matt, glass, water, metal };

/// Says how a surface takes and sends out light.
struct Paint {
  dvec3 color{1};  ///< linear
  int glow = 0;    ///< 0 to 255: light at night
  int tinted = 0;  ///< 255: an instance's tint multiplies the colour
  int sway = 0;    ///< 0 to 255: how far wind moves it
  Kind kind = Kind::matt;
  bool baked = true;  ///< darkened by what is near; off for leaves, which bring their own shade
};

Paint shaded(Paint paint, double factor);

struct Corner {
  dvec3 position;
  Paint paint;
  dvec3 normal{0};  ///< Zero: that of the face, or of its smooth neighbours.
};

/// Three or four corners, counter-clockwise seen from outside.
struct Face {
  std::array<Corner, 4> corners;
  std::size_t count = 0;
  int smooth = 0;  ///< Faces of the same number above 0 share normals where they meet.
};

/// Collects faces. Everything that is added goes through `place` first, which turns, moves and stretches.
class MeshBuilder {
 public:
  void triangle(dvec3 a, dvec3 b, dvec3 c, const Paint& paint, int smooth = 0);
  void quad(dvec3 a, dvec3 b, dvec3 c, dvec3 d, const Paint& paint, int smooth = 0);
  void add(Face face);
  int fresh_smooth() { return ++last_smooth_; }

  glm::dmat4 place{1};
  std::vector<Face> faces;

 private:
  int last_smooth_ = 0;
};

/// Moves what is added while it lives.
class Moved {
 public:
  Moved(MeshBuilder& builder, dvec3 by, double turns = 0, dvec3 stretch = dvec3(1));
  ~Moved() { builder_.place = before_; }
  Moved(const Moved&) = delete;
  Moved& operator=(const Moved&) = delete;

 private:
  MeshBuilder& builder_;
  glm::dmat4 before_;
};

}  // namespace throng::places
