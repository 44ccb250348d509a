#include "tests/benchmark/programs/held.h"

#include <cmath>
#include <utility>

#include "engine/anim/agent/noise_process.h"
#include "engine/anim/agent/targeted_processes.h"

namespace throng::app {
namespace {

/// Metres, model space: in front, to both sides, at the height of faces.
glm::vec3 sight_of(std::uint32_t agent) {
  const auto number = static_cast<float>(agent);
  return {2.0F * std::sin(number), 1.5F + 0.3F * std::sin(0.7F * number), 2.5F};
}

}  // namespace

std::unique_ptr<HeldSubject> HeldSubject::create(const anim::Model& model,
                                                 std::shared_ptr<const anim::Character> character,
                                                 const anim::SystemOptions& options, std::span<const BenchAgent> agents,
                                                 const BenchPalettes& palettes) {
  std::unique_ptr<HeldSubject> held(new HeldSubject(model));
  if (!held->rigs_.look_at()) return nullptr;
  auto subject = SystemSubject::create(std::move(character), options, agents, palettes);
  if (!subject) return nullptr;
  held->subject_ = std::make_unique<SystemSubject>(std::move(*subject));
  if (!held->add_processes(agents.size())) return nullptr;
  return held;
}

bool HeldSubject::add_processes(std::size_t agents) {
  anim::AnimationSystem& system = subject_->system();
  const anim::RigKinds kinds = rigs_.add_to(system);
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    auto gaze = std::make_unique<anim::LookAtProcess>(*kinds.look_at);
    gaze->look_at(sight_of(agent));
    auto noise = std::make_unique<anim::NoiseProcess>(anim::NoiseProcess::Settings{.seed = agent});
    if (!system.agent(agent).add_post_process(std::move(gaze))) return false;
    if (!system.agent(agent).add_post_process(std::move(noise))) return false;
  }
  return true;
}

}  // namespace throng::app
