#include "app/place/stand_in.h"

#include <iterator>

#include <glm/vec3.hpp>

#include "app/place/prop.h"

namespace throng::app {
namespace {

struct Box {
  Prop prop;
  glm::vec3 lowest, highest, color;
};

constexpr Box boxes[] = {
    {Prop::arcade_bay, {-3, 0, -8}, {3, 15, 0}, {0.6F, 0.5F, 0.4F}},
    {Prop::facade_a, {-3, 0, -8}, {3, 15, 0}, {0.6F, 0.55F, 0.45F}},
    {Prop::facade_b, {-3, 0, -8}, {3, 17, 0}, {0.6F, 0.5F, 0.4F}},
    {Prop::facade_c, {-3, 0, -8}, {3, 14, 0}, {0.5F, 0.5F, 0.45F}},
    {Prop::tower, {-4, 0, -4}, {4, 42, 4}, {0.5F, 0.4F, 0.3F}},
    {Prop::tree_a, {-2, 2.5F, -2}, {2, 7, 2}, {0.08F, 0.2F, 0.04F}},
    {Prop::tree_b, {-2, 2.5F, -2}, {2, 8, 2}, {0.1F, 0.22F, 0.04F}},
    {Prop::tree_c, {-2, 2.5F, -2}, {2, 6, 2}, {0.1F, 0.18F, 0.04F}},
    {Prop::planter, {-0.7F, 0, -0.7F}, {0.7F, 0.8F, 0.7F}, {0.3F, 0.3F, 0.3F}},
    {Prop::lamp, {-0.1F, 0, -0.1F}, {0.1F, 4, 0.1F}, {0.05F, 0.05F, 0.05F}},
    {Prop::bench, {-0.9F, 0.3F, -0.25F}, {0.9F, 0.44F, 0.25F}, {0.3F, 0.15F, 0.07F}},
    {Prop::fountain, {-2.1F, 0, -2.1F}, {2.1F, 0.6F, 2.1F}, {0.4F, 0.4F, 0.4F}},
    {Prop::kiosk, {-1.2F, 0, -1.2F}, {1.2F, 3, 1.2F}, {0.1F, 0.3F, 0.2F}},
    {Prop::steps, {-3, 0, -0.8F}, {3, 0.4F, 0.8F}, {0.5F, 0.5F, 0.5F}},
    {Prop::statue, {-0.6F, 0, -0.6F}, {0.6F, 4, 0.6F}, {0.2F, 0.3F, 0.25F}},
    {Prop::flag, {-0.05F, 0, -0.05F}, {0.05F, 6, 0.05F}, {0.8F, 0.8F, 0.8F}},
    {Prop::bunting, {-3, 5, -0.02F}, {3, 5.2F, 0.02F}, {0.8F, 0.8F, 0.8F}},
    {Prop::barrier, {-1, 0.2F, -0.03F}, {1, 1.1F, 0.03F}, {0.4F, 0.4F, 0.4F}},
    {Prop::bollard, {-0.1F, 0, -0.1F}, {0.1F, 0.9F, 0.1F}, {0.1F, 0.1F, 0.1F}},
    {Prop::stand, {-0.2F, 0, -0.2F}, {0.2F, 2.6F, 0.2F}, {0.05F, 0.05F, 0.05F}},
    {Prop::camera_crane, {-0.4F, 0, -0.4F}, {0.4F, 4, 0.4F}, {0.05F, 0.05F, 0.05F}},
    {Prop::seat_block, {-0.5F, -1, -0.5F}, {0.5F, 0, 0.5F}, {0.4F, 0.4F, 0.38F}},
    {Prop::seat, {-0.22F, 0.3F, -0.2F}, {0.22F, 0.44F, 0.2F}, {0.8F, 0.8F, 0.8F}},
    {Prop::roof_bay, {-3, 7, 0}, {3, 7.2F, 7}, {0.6F, 0.6F, 0.6F}},
    {Prop::goal, {-3.6F, 0, -1}, {3.6F, 2.4F, -0.9F}, {0.8F, 0.8F, 0.8F}},
    {Prop::flood_light, {-0.3F, 0, -0.3F}, {0.3F, 20, 0.3F}, {0.3F, 0.3F, 0.3F}},
    {Prop::banner, {-1.4F, 0, -0.03F}, {1.4F, 0.9F, 0.03F}, {0.8F, 0.8F, 0.8F}},
    {Prop::hill, {-200, -5, -60}, {200, 40, 60}, {0.1F, 0.16F, 0.06F}},
    {Prop::skyline, {-30, 0, -8}, {30, 14, 8}, {0.4F, 0.35F, 0.3F}},
};
static_assert(std::size(boxes) == prop_count);

void add_face(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v, const Box& box,
              render::SceneryMeshData& mesh) {
  const glm::vec3 cross(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
  const float length = cross.x + cross.y + cross.z;
  const glm::vec3 normal = cross / (length < 0.0F ? -length : length);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const auto byte = [](float share) { return static_cast<std::uint8_t>(share * 255.0F); };
  for (const glm::vec3& at : {corner, corner + u, corner + u + v, corner + v}) {
    mesh.vertices.push_back({.position = {at.x, at.y, at.z},
                             .normal = {normal.x, normal.y, normal.z},
                             .color = {byte(box.color.x), byte(box.color.y), byte(box.color.z), 255},
                             .tinted = 255});
  }
  for (const std::uint32_t index : {0U, 1U, 2U, 0U, 2U, 3U}) mesh.lods[0].indices.push_back(first + index);
}

}  // namespace

std::vector<render::SceneryMeshData> stand_in_props() {
  std::vector<render::SceneryMeshData> meshes;
  for (const Box& box : boxes) {
    render::SceneryMeshData mesh;
    mesh.name = name_of(box.prop);
    mesh.lods.resize(1);
    const glm::vec3 side = box.highest - box.lowest;
    const glm::vec3 x(side.x, 0, 0), y(0, side.y, 0), z(0, 0, side.z);
    add_face(box.highest, -x, -y, box, mesh);
    add_face(box.lowest, y, x, box, mesh);
    add_face(box.highest, -y, -z, box, mesh);
    add_face(box.lowest, z, y, box, mesh);
    add_face(box.highest, -z, -x, box, mesh);
    meshes.push_back(mesh);
  }
  return meshes;
}

}  // namespace throng::app
