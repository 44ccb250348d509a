#include "app/commands/pose/pipe.h"

#include <utility>

namespace throng::app {
namespace {

glm::dmat4 to_matrix(const anim::PaletteMatrix& entry) {
  glm::dmat4 matrix(1.0);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) matrix[column][row] = static_cast<double>(entry.rows[row][column]);
  }
  return matrix;
}

/// The state of one bone of a pose [packet][components][16].
anim::StateTransform state_of_bone(std::span<const float> pose, int components, int bone) {
  const auto packet = static_cast<std::size_t>(bone / anim::packet_bones);
  const auto lane = static_cast<std::size_t>(bone % anim::packet_bones);
  const auto value = [&](int component) {
    const std::size_t row = packet * static_cast<std::size_t>(components) + static_cast<std::size_t>(component);
    return static_cast<double>(pose[row * anim::packet_bones + lane]);
  };
  anim::StateTransform state;
  state.rotation = glm::dquat(value(3), value(0), value(1), value(2));
  state.position = {value(4), value(5), value(6)};
  if (components == anim::general_components) state.scale = {value(7), value(8), value(9)};
  return state;
}

}  // namespace

Status PosePipe::prepare(const anim::Model& model, const anim::Clip* clip) {
  if (system_ != nullptr && model_ == &model && clip_ == clip) return Done{};
  anim::Model played = model;
  played.clips.clear();
  if (clip != nullptr) played.clips.push_back(*clip);
  const anim::BakeOptions unchanged{.take_root_motion = false, .as_in_the_file = true};
  auto character = std::make_shared<const anim::Character>(anim::bake_character(played, unchanged));
  auto system = anim::AnimationSystem::create(std::move(character),
                                              {.schedule = anim::Schedule::levels, .stream = stream_, .hash = false});
  if (!system) return system.error();
  system_ = std::move(*system);
  palette_ = anim::allocate_aligned(anim::palette_stride(model.skeleton.palette.size(), PaletteFormat::matrices));
  model_ = &model;
  clip_ = clip;
  return Done{};
}

Result<BonePose> PosePipe::pose(const anim::Model& model, const anim::Clip* clip, double seconds) {
  if (const Status prepared = prepare(model, clip); !prepared) return prepared.error();
  system_->set_agent_count(0);
  system_->set_agent_count(1);
  system_->agent(0).play({.clip = 0, .start = to_ticks(seconds), .loop = false});
  const PoseRequest update{.agent = {0}, .palette = palette_.get()};
  system_->update({&update, 1});

  BonePose pose;
  const int components = model.skeleton.components();
  for (int bone = 0; bone < model.skeleton.bone_count(); ++bone) {
    pose.states.push_back(state_of_bone(system_->agent(0).pose(), components, bone));
  }
  const auto* const palette = reinterpret_cast<const anim::PaletteMatrix*>(palette_.get());
  for (std::size_t entry = 0; entry < model.skeleton.palette.size(); ++entry) {
    pose.palette.push_back(to_matrix(palette[entry]));
  }
  return pose;
}

}  // namespace throng::app
