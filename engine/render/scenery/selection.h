#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "throng/render/crowd_draw.h"
#include "throng/render/scenery_data.h"

namespace throng::render {

/// A coarser mesh of scenery is off by at most so many pixels.
inline constexpr float scenery_error_pixels = 1.0F;
/// A thing of less than so many pixels is not drawn.
inline constexpr float least_scenery_pixels = 1.0F;

/// Instances in view are sorted into so many rings around the camera, each of which reaches 1.4 times as far as the one
/// before.
inline constexpr std::uint32_t scenery_rings = 20;

/// The shape of a mesh, as far as the choice of its level of detail reads it.
struct SceneryShape {
  glm::vec3 middle{0.0F};  ///< of a sphere around it
  float radius = 0.0F;
  std::vector<float> errors;  ///< [LOD] metres
};
SceneryShape shape_of(const SceneryMeshData& mesh);

/// Says which scenery is in view, and how far a mesh may be off there.
class SceneryView {
 public:
  /// Looks from a camera into a picture of so many pixels from bottom to top.
  SceneryView(const CameraView& camera, float picture_height);
  /// Looks along parallel rays, at pixels of so many metres. What is nearer or farther than the picture's depths is in
  /// view too, since it casts shadows into them.
  SceneryView(const glm::mat4& view_projection, float pixel_metres);

  bool sees_sphere(const glm::vec3& middle, float radius) const;
  bool sees_box(const glm::vec3& lowest, const glm::vec3& highest) const;
  /// Returns the metres that are one pixel at the nearest point of a sphere or box.
  float metres_a_pixel(const glm::vec3& middle, float radius) const;
  float metres_a_pixel_in(const glm::vec3& lowest, const glm::vec3& highest) const;
  /// Returns a number from 0 to below scenery_rings, the higher the farther away the nearest point of a sphere is.
  std::uint32_t ring(const glm::vec3& middle, float radius) const;

 private:
  std::array<glm::vec4, 6> planes_;
  std::size_t plane_count_;
  glm::vec3 eye_{0.0F};
  float a_metre_away_ = 0.0F;  // metres a pixel, one metre from the eye
  float everywhere_ = 0.0F;    // metres a pixel where rays are parallel
};

/// Chooses the instances in view and their levels of detail. Instances that are close together are looked at together.
class ScenerySelection {
 public:
  /// Takes instances. Returns the order in which the selection numbers them from here on. `shapes` has one a mesh.
  std::vector<std::uint32_t> place(std::span<const SceneryInstance> instances, std::span<const SceneryShape> shapes);

  /// A mesh at a level of detail, and the run of chosen() that is drawn with it. Runs come from near to far.
  struct Run {
    std::uint32_t mesh;
    std::uint32_t lod;
    std::uint32_t first;
    std::uint32_t count;
  };

  /// Chooses for a view. The results are valid until the next call. Allocates nothing. A level is `coarser` by so many,
  /// if there is one.
  void choose(const SceneryView& view, std::uint32_t coarser = 0);
  std::span<const Run> runs() const { return {runs_.data(), run_count_}; }
  std::span<const std::uint32_t> chosen() const { return {chosen_.data(), chosen_count_}; }

 private:
  struct Placed {
    glm::vec3 middle;
    float radius;
    float scale;
    std::uint32_t mesh;
  };
  struct Cluster {
    glm::vec3 lowest, highest;
    float largest_radius;
    std::uint32_t first, end;
  };
  struct Seen {
    std::uint32_t instance;
    std::uint32_t place;  // the index into counts_
  };

  void gather_clusters();
  void see(const SceneryView& view, std::uint32_t instance, std::uint32_t coarser);
  void sort_by_distance();

  std::vector<Placed> placed_;
  std::vector<Cluster> clusters_;
  std::vector<std::uint32_t> first_slots_;  // [mesh]; a slot is a mesh at a level of detail
  std::vector<float> errors_;               // [slot]
  std::vector<std::uint32_t> counts_;       // [ring, slot] instances in view
  std::vector<Seen> seen_;
  std::size_t seen_count_ = 0;
  std::vector<Run> runs_;
  std::size_t run_count_ = 0;
  std::vector<std::uint32_t> chosen_;
  std::size_t chosen_count_ = 0;
};

}  // namespace throng::render
