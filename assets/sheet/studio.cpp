#include "assets/sheet/studio.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>

#include "throng/render/camera.h"

#include "app/character/built_in.h"
#include "assets/sheet/contact_sheet.h"
#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/kernel/palette/packed_palette.h"
#include "engine/crowd/sorted_draws.h"

namespace throng::sheet {
namespace {

constexpr float camera_distance = 16.0F;

bool complain(const std::string& message) {
  std::fprintf(stderr, "throng_character_sheet: %s\n", message.c_str());
  return false;
}

/// The sheet is a tool of ours: it ends where the device fails.
void need(const Status& status) {
  if (!status) std::exit(complain(status.error().message) ? 0 : 1);
}

render::CameraView view_of(const Shot& shot) {
  render::Camera camera;
  camera.yaw = shot.yaw;
  camera.pitch = shot.pitch;
  camera.vertical_view = 2.0F * std::atan(shot.metres / 2.0F / camera_distance);
  camera.position = shot.centre - render::forward(camera) * camera_distance;
  return render::view_of(camera, static_cast<float>(shot.width) / static_cast<float>(shot.height));
}

std::size_t palette_bytes(std::size_t entries) { return anim::palette_stride(entries, PaletteFormat::matrices); }

std::vector<std::size_t> palette_bytes_by_level(const anim::Skeleton& skeleton) {
  std::vector<std::size_t> bytes;
  for (const int bones : skeleton.level_bone_counts) {
    bytes.push_back(palette_bytes(static_cast<std::size_t>(anim::palette_count_for_bones(skeleton, bones))));
  }
  return bytes;
}

std::vector<anim::PaletteMatrix> written(const std::vector<glm::dmat4>& palette) {
  std::vector<anim::PaletteMatrix> rows(palette.size());
  for (std::size_t entry = 0; entry < palette.size(); ++entry) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        rows[entry].rows[row][column] = static_cast<float>(palette[entry][column][row]);
      }
    }
  }
  return rows;
}

}  // namespace

std::unique_ptr<Studio> Studio::open(bool with_wardrobe) {
  std::unique_ptr<Studio> studio(new Studio);
  const std::string source = THRONG_SOURCE_DIR;
  auto character = app::load_character(source + "/assets/mannequin.glb", "mannequin");
  if (!character) return complain(character.error().message), nullptr;
  studio->character_ = std::move(*character);
  if (with_wardrobe) {
    const auto added =
        app::add_parts(studio->character_.model, studio->character_.name, source + "/assets/wardrobe.glb");
    if (!added) return complain(added.error().message), nullptr;
    studio->character_.cast_rules = source + "/assets/cast.json";
    auto clothing = app::clothing_of(studio->character_);
    if (!clothing) return complain(clothing.error().message), nullptr;
    studio->clothing_ = std::move(*clothing);
  }
  auto context = render::gl::make_osmesa_context();
  if (!context) return complain(context.error().message), nullptr;
  studio->context_ = std::move(*context);
  auto renderer = render::Renderer::create(*studio->context_, {.data = source, .size = {64, 64}, .samples = 4});
  if (!renderer) return complain(renderer.error().message), nullptr;
  studio->renderer_ = std::move(*renderer);
  const render::CrowdMeshData mesh = app::mesh_data(studio->character_);
  const auto loaded = studio->renderer_->load_characters({&mesh, 1});
  if (!loaded) return complain(loaded.error().message), nullptr;
  return studio;
}

std::vector<anim::PaletteMatrix> Studio::palette_of(const Figure& figure) const {
  if (!figure.palette.empty()) return figure.palette;
  const anim::Skeleton& skeleton = character_.model.skeleton;
  if (figure.pose) {
    std::vector<anim::StateTransform> locals;
    for (const anim::Bone& bone : skeleton.bones) {
      locals.push_back(anim::rest_transform(bone));
      locals.back().rotation = figure.pose->rotations[mannequin::joint_index(bone.name)];
      if (bone.name == "hips") locals.back().position += figure.pose->hips;
    }
    return written(anim::pose_from_locals(skeleton, std::move(locals)).palette);
  }
  const auto clip = std::ranges::find(character_.model.clips, figure.clip, &anim::Clip::name);
  const bool found = clip != character_.model.clips.end();
  return written(anim::reference_pose(skeleton, found ? &*clip : nullptr, figure.seconds).palette);
}

render::InstanceRecord Studio::record_of(const Figure& figure) {
  const std::vector<anim::PaletteMatrix> palette = palette_of(figure);
  const PaletteSlot slot = slots_->acquire(palette_bytes(palette.size()));
  std::memcpy(slots_->memory(slot), palette.data(), palette.size() * sizeof(anim::PaletteMatrix));
  render::InstanceRecord record{};
  for (int axis = 0; axis < 3; ++axis) record.position[axis] = figure.place[axis];
  record.scale = figure.scale;
  record.contact_scale = 1.0F;
  record.heading_cosine = std::cos(figure.heading);
  record.heading_sine = std::sin(figure.heading);
  record.palette_from = record.palette_to = slot.first_line;
  record.bone_level = figure.bone_level;
  return record;
}

render::Image Studio::take(const Shot& shot, const std::vector<Figure>& figures) {
  need(renderer_->set_size({shot.width, shot.height}));
  renderer_->reset_palette_pages();
  slots_ =
      std::make_unique<PaletteSlots>(renderer_->palette_pages(), palette_bytes_by_level(character_.model.skeleton));
  std::vector<render::InstanceRecord> records;
  std::vector<render::CrowdBatch> batches;
  std::vector<render::AgentLook> looks;
  std::vector<std::uint32_t> drawn;
  for (const Figure& figure : figures) {
    const auto number = static_cast<std::uint32_t>(records.size());
    const auto lod = static_cast<std::uint8_t>(std::min(figure.mesh_lod, mesh_lod_count() - 1));
    for_each_worn(figure.outfit, lod, [&](std::uint32_t piece) {
      batches.push_back({.mesh_lod = lod,
                         .piece = static_cast<std::uint16_t>(piece),
                         .first = static_cast<std::uint32_t>(drawn.size()),
                         .count = 1});
      drawn.push_back(number);
    });
    records.push_back(record_of(figure));
    records.back().agent = number;
    looks.push_back(figure.look ? *figure.look : app::look_of(figure.tints, figure.variant, 0));
  }
  const render::CrowdBatch all{.count = static_cast<std::uint32_t>(records.size())};
  render::CrowdFrame frame;
  frame.camera = view_of(shot);
  frame.shadows = shot.shadows;
  renderer_->draw(frame);
  const render::Image empty = renderer_->read_image();
  frame.instances = records;
  frame.batches = batches;
  frame.drawn = drawn;
  frame.runs = {&all, 1};
  frame.looks = looks;
  frame.looks_number = render::new_looks_number();
  renderer_->draw(frame);
  render::Image picture = renderer_->read_image();
  flatten_background(picture, empty);
  return picture;
}

}  // namespace throng::sheet
