#include "tests/gl/doll_crowd.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace throng::render::test {
namespace {

constexpr std::size_t row_length = 5;

AgentLook look_of(std::size_t agent) {
  AgentLook look = plain_look();
  for (std::size_t region = 0; region < 5; ++region) {
    const auto hash = static_cast<std::uint32_t>((agent * 5 + region + 1) * 2654435761U);
    look.tints.at(region) = tint_of((hash >> 4U) | 0x00404040U);
  }
  return look;
}

InstanceRecord record_of(std::size_t agent) {
  InstanceRecord record{};
  const auto column = static_cast<float>(agent % row_length);
  const auto row = static_cast<float>(agent / row_length);
  record.position[0] = (column - 2.0F) * 1.2F;
  record.position[2] = -row * 1.6F;
  record.scale = 0.9F + 0.02F * column;
  record.contact_scale = 1.0F;
  record.heading_cosine = std::cos(0.3F * column - 0.5F);
  record.heading_sine = std::sin(0.3F * column - 0.5F);
  record.agent = static_cast<std::uint32_t>(agent);
  // The blend is a third of the way from one slot to the other.
  record.blend_start = DollCrowd::now - 10'000;
  record.blend_duration = 30'000;
  return record;
}

}  // namespace

DollCrowd::DollCrowd(gl::Context& context, int samples, int longest_tile) {
  RendererOptions options;
  options.data = THRONG_SOURCE_DIR;
  options.size = {width, height};
  options.samples = samples;
  options.longest_tile = longest_tile;
  Result<std::unique_ptr<Renderer>> renderer = Renderer::create(context, options);
  if (!renderer) throw std::runtime_error(renderer.error().message);
  renderer_ = std::move(*renderer);
  const std::vector<CrowdMeshData> meshes(2, doll_.mesh_data());
  if (const Status loaded = renderer_->load_characters(meshes); !loaded) {
    throw std::runtime_error(loaded.error().message);
  }
  slots_ = std::make_unique<PaletteSlots>(renderer_->palette_pages(), std::vector<std::size_t>{doll_palette_bytes});
  read_back_ = std::make_unique<SkinningReadBack>(*renderer_);
  camera.position = {0.0F, 1.6F, 4.2F};
  camera.pitch = -0.12F;
}

void DollCrowd::stand(std::size_t count) {
  for (std::size_t agent = 0; agent < count; ++agent) {
    instances.push_back(record_of(agent));
    looks.push_back(look_of(agent));
    from.push_back(doll_pose(0.2F + 0.1F * static_cast<float>(agent % 7)));
    to.push_back(doll_pose(1.3F - 0.1F * static_cast<float>(agent % 9)));
  }
}

std::uint32_t DollCrowd::write(const DollPalette& palette) {
  const PaletteSlot slot = slots_->acquire(doll_palette_bytes);
  std::memcpy(slots_->memory(slot), palette.data(), palette.size() * sizeof(PaletteRows));
  return slot.first_line;
}

void DollCrowd::write_palettes() {
  for (std::size_t agent = 0; agent < instances.size(); ++agent) {
    instances[agent].palette_from = write(from[agent]);
    instances[agent].palette_to = write(to[agent]);
  }
}

CrowdFrame DollCrowd::frame() {
  // There are two runs, so that the second does not start at the first instance.
  const auto count = static_cast<std::uint32_t>(instances.size());
  const std::uint32_t half = count / 2;
  batches_.clear();
  const auto run_of = [](std::uint8_t character, std::uint32_t first, std::uint32_t size) {
    return CrowdBatch{.character = character, .first = first, .count = size};
  };
  if (count > 0) batches_ = {run_of(0, 0, half), run_of(0, half, count - half)};
  CrowdFrame frame;
  frame.camera = view_of(camera, static_cast<float>(width) / height);
  frame.instances = instances;
  frame.batches = batches_;
  frame.looks = looks;
  frame.looks_number = new_looks_number();  // tests change them
  frame.now = now;
  return frame;
}

Image DollCrowd::picture() {
  renderer_->draw(frame());
  return renderer_->read_image();
}

}  // namespace throng::render::test
