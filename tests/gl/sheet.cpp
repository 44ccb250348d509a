#include "tests/gl/sheet.h"

#include <gtest/gtest.h>

namespace throng::render::test {
namespace {

constexpr std::array<float, 12> positions = {-2, 4, 0, 2, 4, 0, -2, 0, 0, 2, 0, 0};
constexpr std::array<std::uint16_t, 16> entries{};
constexpr std::array<float, 16> weights = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};

/// Turns everything about the middle of the sheet: by half a turn, or not at all.
DollPalette palette_of(bool upside_down) {
  const float sign = upside_down ? -1.0F : 1.0F;
  const PaletteRows rows{{{sign, 0, 0, 0}, {0, sign, 0, upside_down ? 4.0F : 0.0F}, {0, 0, 1, 0}}};
  return DollPalette(doll_joints, rows);
}

}  // namespace

Sheet::Sheet(gl::Context& context) : crowd_(context) {
  crowd_.camera = {.position = {0.0F, 2.0F, 2.0F}};
  InstanceRecord record{};
  record.scale = 1.0F;
  record.heading_cosine = 1.0F;
  crowd_.instances = {record};
  crowd_.looks = {plain_look()};
  crowd_.from = crowd_.to = {palette_of(false)};
  crowd_.write_palettes();
  face({0, 0, 1});
}

void Sheet::face(const glm::vec3& normal) {
  normals_.clear();
  for (int i = 0; i < 4; ++i) normals_.insert(normals_.end(), {normal.x, normal.y, normal.z});
}

void Sheet::turn_upside_down() {
  crowd_.from = crowd_.to = {palette_of(true)};
  crowd_.write_palettes();
}

std::vector<float> Sheet::all_at(float u, float v) { return {u, v, u, v, u, v, u, v}; }

void Sheet::dress(std::uint32_t tint, std::uint32_t second) {
  is_dressed_ = true;
  regions_.assign(4, static_cast<std::uint8_t>(Region::top));
  crowd_.looks.front().tints.fill(tint);
  crowd_.looks.front().seconds.fill(second);
}

Image Sheet::picture() {
  CrowdMeshData data;
  data.parts = {{.positions = positions,
                 .normals = normals_,
                 .texture_coords = coords,
                 .emission_coords = {},
                 .metallic_roughness_coords = metallic_roughness_coords,
                 .normal_coords = normal_coords,
                 .occlusion_coords = occlusion_coords,
                 .tangents = tangents,
                 .colors = colors,
                 .regions = regions_,
                 .shapes = {},
                 .hair = {},
                 .trims = trims,
                 .faces = faces,
                 .palette_entries = entries,
                 .weights = weights,
                 .indices = triangles_}};
  if (is_dressed_) data.pieces = {{.levels = {{data.parts, 0.0F}, {data.parts, 0.0F}}}};
  data.materials = {material};
  data.images = images;
  data.entry_at_level = {{0, 1, 2, 3, 4, 5}};
  const std::vector<CrowdMeshData> characters(2, data);
  EXPECT_TRUE(crowd_.renderer().load_characters(characters));
  CrowdFrame frame = crowd_.frame();
  const CrowdBatch run{.count = 1}, worn{.mesh_lod = mesh_lod, .piece = 1, .count = 1};
  constexpr std::uint32_t only = 0;
  if (is_dressed_) {
    frame.batches = {&worn, 1};
    frame.runs = {&run, 1};
    frame.drawn = {&only, 1};
  }
  frame.light = light;
  frame.shadows = frame.crowd_shade = false;
  crowd_.renderer().draw(frame);
  return crowd_.renderer().read_image();
}

double Sheet::brightness(const Image& image, float x, float y, int channel) {
  constexpr int reach = 4;  // pixels
  const int column = static_cast<int>(x * static_cast<float>(image.width));
  const int row = static_cast<int>(y * static_cast<float>(image.height));
  double sum = 0.0;
  for (int i = -reach; i < reach; ++i) {
    for (int j = -reach; j < reach; ++j) sum += image.pixel(column + i, row + j)[channel];
  }
  return sum / (4.0 * reach * reach);
}

}  // namespace throng::render::test
