#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/agent/system_snapshot.h"

namespace throng::anim {

inline constexpr Ticks frame_ticks = ticks_per_second / 60;

/// Returns a synthetic character of 40 bones and 5 clips, whose lengths differ.
std::shared_ptr<const Character> test_character();

/// Returns a palette as PoseRequest takes it.
inline std::byte* memory_of(const PaletteMatrix* palette) {
  return PaletteDestination(const_cast<PaletteMatrix*>(palette)).memory();
}

/// A crowd of one character. All agents are updated each frame at full detail.
struct CrowdRig {
  explicit CrowdRig(const SystemOptions& options = {}, std::uint32_t agents = 1);

  void step(int frames = 1);
  AnimationSystem& operator*() const { return *system; }
  AnimationSystem* operator->() const { return system.get(); }

  /// Returns the joints of the last update in model space, one a bone.
  std::vector<glm::vec3> joints(std::uint32_t agent = 0) const;
  /// Returns the palette of the last update, [bone].
  const PaletteMatrix* palette(std::uint32_t agent = 0) const;
  /// Returns the bones whose palette entries differ in some bit.
  std::vector<int> bones_unlike(const CrowdRig& other, std::uint32_t agent = 0) const;

  std::size_t entities(std::uint32_t agent = 0) const { return system->agent(agent).program().steps.size(); }
  /// Returns the number of steps from the root to the farthest player.
  std::size_t depth(std::uint32_t agent = 0) const;

  std::unique_ptr<AnimationSystem> system;
  AlignedBytes palettes;
};

/// A channel that makes its graph once and leaves it as it is. `make` returns what it made, the result last.
class FixedChannel final : public Channel {
 public:
  using Make = std::function<std::vector<Handle>(const EntityBuilder& build)>;
  explicit FixedChannel(Make make) : make_(std::move(make)) {}

  Handle state() const override { return made_.empty() ? Handle{} : made_.back(); }
  bool update(const EntityBuilder& build) override;
  void visit_handles(const std::function<void(Handle&)>& visit) override;
  void destroy_entities(const EntityBuilder& build) override;
  std::unique_ptr<Channel> clone() const override { return std::make_unique<FixedChannel>(*this); }

 private:
  Make make_;
  std::vector<Handle> made_;
};

}  // namespace throng::anim
