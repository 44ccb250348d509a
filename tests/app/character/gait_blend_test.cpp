// Between the gaits of the built-in character feet step in turns above the ground and hardly slide, and knees bend the
// way that knees do.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "app/character/built_in.h"
#include "app/character/gait_plane.h"
#include "engine/anim/agent/animation_system.h"
#include "engine/anim/agent/blend_space_2d_channel.h"
#include "engine/anim/base/aligned_bytes.h"

namespace throng::app::gait_blend_test {
namespace {

constexpr int frames_a_second = 120;
constexpr std::uint8_t shoes = 4;  // the region of the built-in character's mesh

struct Figures {
  float lowest = 1.0F;           // metres, of a sole
  double knee = 180.0;           // degrees, the least bent
  std::array<int, 2> strikes{};  // of the left foot and of the right one
  bool by_turns = true;
  std::vector<double> slides;  // metres a step, how far a sole goes while it is on the ground

  double mean_slide() const {
    double sum = 0.0;
    for (const double slide : slides) sum += slide;
    return slides.empty() ? 0.0 : sum / static_cast<double>(slides.size());
  }
};

/// One foot on its way over the ground, seen by the vertices of its sole.
class Sole {
 public:
  void add(std::size_t vertex) { places_.push_back({.vertex = vertex}); }
  float lowest() const { return lowest_; }
  bool stands() const { return stands_; }
  double slide() const { return slide_; }

  /// Takes the vertices as they are now, at their places in the world. Returns whether the foot came down.
  bool take(const std::vector<glm::vec3>& skin) {
    constexpr float touching = 0.006F;  // metres
    double most = 0.0;
    lowest_ = 1.0F;
    for (Place& place : places_) {
      const glm::vec3 now = skin[place.vertex];
      lowest_ = std::min(lowest_, now.y);
      const bool touched = place.last.y < touching && now.y < touching;
      if (touched) most = std::max(most, std::hypot(double{now.x - place.last.x}, double{now.z - place.last.z}));
      place.last = now;
    }
    const bool stood = std::exchange(stands_, lowest_ < (stands_ ? 2.0F : 1.0F) * touching);
    if (stands_ && !stood) slide_ = 0.0;
    slide_ += most;
    return stands_ && !stood;
  }

 private:
  struct Place {
    std::size_t vertex;
    glm::vec3 last{0.0F, 1.0F, 0.0F};
  };
  std::vector<Place> places_;
  float lowest_ = 1.0F;
  bool stands_ = false;
  double slide_ = 0.0;
};

class GaitBlend : public testing::Test {
 protected:
  static const CharacterSource& character() {
    static const CharacterSource only = *load_built_in(THRONG_SOURCE_DIR);
    return only;
  }

  /// Walks for some cycles with a velocity, the root as fast as that.
  static Figures walk(const glm::vec2& velocity, Middle middle) {
    const auto& source = character();
    const auto plane = *gait_plane(source.roles, static_cast<int>(source.clip_names.size()), middle);
    const auto system = std::move(*anim::AnimationSystem::create(source.character, {}));
    system->set_agent_count(1);
    EXPECT_TRUE(system->agent(0).add_channel(std::make_unique<anim::BlendSpace2dChannel>(plane, velocity)));
    const auto bones = source.model.skeleton.bones.size();
    const anim::AlignedBytes memory =
        anim::allocate_aligned(source.model.skeleton.palette.size() * sizeof(anim::PaletteMatrix));
    std::vector<anim::Transform> locals(bones);
    const anim::ExactPose wanted{
        .agent = {0}, .palette = reinterpret_cast<anim::PaletteMatrix*>(memory.get()), .locals = locals};
    const PoseRequest update{.agent = {0}};
    Figures figures;
    std::array<Sole, 2> soles = soles_of(source.model.meshes.front());
    int last = -1;
    for (int frame = 0; frame < 6 * frames_a_second; ++frame) {
      system->advance(ticks_per_second / frames_a_second);
      system->update({&update, 1});
      system->pose_exactly({&wanted, 1});
      const float seconds = static_cast<float>(frame) / frames_a_second;
      const auto skin =
          skin_of(source.model.meshes.front(), wanted.palette, seconds * glm::vec3(velocity.x, 0.0F, velocity.y));
      for (const int side : {0, 1}) {
        Sole& sole = soles[static_cast<std::size_t>(side)];
        const bool stood = sole.stands();
        const double slide = sole.slide();
        const bool strikes = sole.take(skin);
        if (frame < frames_a_second) continue;  // the first second only brings the feet to the ground
        if (stood && !sole.stands()) figures.slides.push_back(slide);
        figures.lowest = std::min(figures.lowest, sole.lowest());
        if (!strikes) continue;
        figures.by_turns = figures.by_turns && side != last;
        last = side;
        ++figures.strikes[static_cast<std::size_t>(side)];
      }
      for (const char* const joint : {"shin.L", "shin.R"}) figures.knee = std::min(figures.knee, bend(locals, joint));
    }
    return figures;
  }

 private:
  static std::array<Sole, 2> soles_of(const anim::SkinnedMesh& mesh) {
    std::array<Sole, 2> soles;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      const bool is_sole = mesh.regions[v] == shoes && mesh.positions[v].y < 0.02F;
      if (is_sole) soles[mesh.positions[v].x > 0.0F ? 0 : 1].add(v);
    }
    return soles;
  }

  static std::vector<glm::vec3> skin_of(const anim::SkinnedMesh& mesh, const anim::PaletteMatrix* palette,
                                        const glm::vec3& place) {
    std::vector<glm::vec3> skin(mesh.positions.size(), glm::vec3(0.0F, 1.0F, 0.0F));
    for (std::size_t v = 0; v < skin.size(); ++v) {
      if (mesh.regions[v] != shoes) continue;
      skin[v] = place;
      for (int influence = 0; influence < 4; ++influence) {
        const auto* const rows = reinterpret_cast<const float*>(palette + mesh.palette_entries[v][influence]);
        const glm::vec4 from(mesh.positions[v], 1.0F);
        for (int axis = 0; axis < 3; ++axis) {
          const float* const row = rows + 4 * axis;
          const float to = row[0] * from.x + row[1] * from.y + row[2] * from.z + row[3];
          skin[v][axis] += mesh.weights[v][influence] * to;
        }
      }
    }
    return skin;
  }

  /// Returns the degrees by which a knee is bent; below 0 it is bent the wrong way.
  static double bend(const std::vector<anim::Transform>& locals, const std::string& joint) {
    const auto& bones = character().model.skeleton.bones;
    const auto bone = std::ranges::find(bones, joint, &anim::Bone::name) - bones.begin();
    const glm::quat turn = locals[static_cast<std::size_t>(bone)].rotation;
    return 2.0 * glm::degrees(std::atan2(static_cast<double>(turn.x), static_cast<double>(turn.w)));
  }
};

constexpr std::array<glm::vec2, 20> velocities{
    {{0.0F, 0.1F},   {0.0F, 0.2F}, {0.0F, 0.45F}, {0.0F, 0.5F},  {0.0F, 0.9F},   {0.0F, 1.35F}, {0.0F, 1.8F},
     {0.0F, 2.4F},   {0.0F, 3.0F}, {0.3F, 0.0F},  {0.45F, 0.0F}, {-0.45F, 0.0F}, {0.0F, -0.4F}, {0.0F, -0.8F},
     {-0.3F, -0.3F}, {0.2F, 0.2F}, {0.4F, 0.4F},  {0.1F, 0.6F},  {0.2F, 1.0F},   {-0.2F, 1.27F}}};

std::string in_words(const glm::vec2& velocity, const Figures& figures) {
  char text[160];
  std::snprintf(text, sizeof(text),
                "%.2f, %.2f m/s: lowest %.1f mm, knee %.1f degrees, %d and %d strikes, %.1f mm a step",
                double{velocity.x}, double{velocity.y}, double{figures.lowest} * 1e3, figures.knee, figures.strikes[0],
                figures.strikes[1], figures.mean_slide() * 1e3);
  return text;
}

TEST_F(GaitBlend, PutsNoFootThroughTheGroundAndHardlySlides) {
  for (const glm::vec2& velocity : velocities) {
    const Figures figures = walk(velocity, Middle::steps);
    const std::string words = in_words(velocity, figures);
    EXPECT_GT(figures.lowest, -0.025F) << words;
    EXPECT_LT(figures.mean_slide(), 0.07) << words;
  }
}

TEST_F(GaitBlend, StepsByTurnsWithKneesThatBendTheirWay) {
  for (const glm::vec2& velocity : velocities) {
    const Figures figures = walk(velocity, Middle::steps);
    EXPECT_TRUE(figures.by_turns) << in_words(velocity, figures);
    EXPECT_GE(figures.strikes[0], 2) << in_words(velocity, figures);
    EXPECT_LE(std::abs(figures.strikes[0] - figures.strikes[1]), 1) << in_words(velocity, figures);
    EXPECT_GT(figures.knee, 5.0) << in_words(velocity, figures);
  }
}

TEST_F(GaitBlend, DragsTheFeetOfSlowPeopleWhereItStandsInTheMiddle) {
  constexpr glm::vec2 slow(0.0F, 0.2F);
  EXPECT_LT(3.0 * walk(slow, Middle::steps).mean_slide(), walk(slow, Middle::stands).mean_slide());
}

}  // namespace
}  // namespace throng::app::gait_blend_test
