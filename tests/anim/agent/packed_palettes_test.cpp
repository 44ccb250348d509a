// A crowd that writes packed palettes: the same poses in a third of the bytes, one hash however they are scheduled.

#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/asset/synthetic_model.h"

namespace throng::anim::packed_palettes_test {
namespace {

constexpr std::uint32_t agents = 37;
constexpr int frames = 12;

std::shared_ptr<const Character> character_of(const Model& model) {
  return std::make_shared<const Character>(bake_character(model));
}

/// Blends of two clips, whose palettes go where a test may read them.
class PackedCrowd {
 public:
  explicit PackedCrowd(const SystemOptions& options, bool blends = true)
      : character_(character_of(synthetic_model(62, 3))),
        entries_((static_cast<std::size_t>(character_->skeleton.palette_count()) + 3) / 4 * 4),
        memory_(allocate_aligned(agents * entries_ * sizeof(PaletteMatrix))) {
    system_ = std::move(*AnimationSystem::create(character_, options));
    system_->set_agent_count(agents);
    for (std::uint32_t agent = 0; agent < agents; ++agent) {
      system_->agent(agent).play({.clip = static_cast<int>(agent % 3), .start = to_ticks(0.03 * agent)});
      if (blends) system_->agent(agent).play({.clip = static_cast<int>((agent + 1) % 3), .held_fraction = 0.4F});
    }
    std::vector<PoseRequest> updates;
    for (std::uint32_t agent = 0; agent < agents; ++agent) {
      updates.push_back({.agent = {agent}, .palette = PaletteDestination(palette(agent)).memory()});
    }
    for (int frame = 0; frame < frames; ++frame) {
      system_->advance(ticks_per_second / 60);
      system_->update(updates);
    }
  }

  const AnimationSystem& system() const { return *system_; }
  const Skeleton& skeleton() const { return character_->skeleton; }
  template <typename Entry>
  const Entry& entry(std::uint32_t agent, std::size_t bone) const {
    return reinterpret_cast<const Entry*>(palette(agent))[bone];
  }

 private:
  std::byte* palette(std::uint32_t agent) const { return memory_.get() + agent * entries_ * sizeof(PaletteMatrix); }

  std::shared_ptr<const Character> character_;
  std::size_t entries_;
  AlignedBytes memory_;
  std::unique_ptr<AnimationSystem> system_;
};

constexpr SystemOptions packed{.palettes = PaletteFormat::packed};

TEST(PackedPalettes, SayWhatFloatOnesSayToFiftyMicrometresAndRadians) {
  const PackedCrowd floats({}), crowd(packed);
  const std::vector<PackingFrame> frames_of = packing_frames(crowd.skeleton());
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    for (std::size_t bone = 0; bone < frames_of.size(); ++bone) {
      const PackingFrame& frame = frames_of[bone];
      const PaletteMatrix expected = floats.entry<PaletteMatrix>(agent, bone);
      const PaletteMatrix actual = unpack(crowd.entry<PackedPaletteEntry>(agent, bone), frame);
      for (int row = 0; row < 3; ++row) {
        float expected_joint = expected.rows[row][3], joint = actual.rows[row][3];
        for (int column = 0; column < 3; ++column) {
          EXPECT_NEAR(actual.rows[row][column], expected.rows[row][column], 6e-5F) << agent << " " << bone;
          expected_joint += expected.rows[row][column] * frame.pivot[column];
          joint += actual.rows[row][column] * frame.pivot[column];
        }
        EXPECT_NEAR(joint, expected_joint, 5e-5F) << agent << " " << bone;
      }
    }
  }
}

TEST(PackedPalettes, AreAThirdOfTheBytes) {
  EXPECT_EQ(PackedCrowd(packed).system().figures().report().palette_bytes * 3,
            PackedCrowd({}).system().figures().report().palette_bytes);
}

TEST(PackedPalettes, HaveOneHashHoweverTheyAreScheduled) {
  const std::uint64_t expected = PackedCrowd(packed).system().figures().pose_hash();
  SystemOptions options = packed;
  for (const Schedule schedule : {Schedule::fused, Schedule::levels}) {
    options.schedule = schedule;
    for (const int tile : {0, 1, 4, 16}) {
      options.tile = tile;
      for (const int pus : {1, 3}) {
        options.pus = pus;
        EXPECT_EQ(PackedCrowd(options).system().figures().pose_hash(), expected) << tile << " " << pus;
      }
    }
  }
}

TEST(PackedPalettes, HaveAHashOfTheirOwn) {
  const std::uint64_t hash = PackedCrowd(packed).system().figures().pose_hash();
  EXPECT_NE(hash, PackedCrowd({}).system().figures().pose_hash());
  EXPECT_NE(hash, PackedCrowd(packed, false).system().figures().pose_hash());
}

TEST(PackedPalettes, AreRefusedToSkeletonsThatAreNotRigidWhichKeepMatrices) {
  const PackedCrowd crowd(packed);
  EXPECT_EQ(crowd.system().characters().palette_format(0), PaletteFormat::packed);
  Model general = synthetic_model(62, 3);
  general.skeleton.rigid = false;
  for (ReferenceFrame& frame : general.skeleton.references) frame = {};
  const auto system = std::move(*AnimationSystem::create(character_of(general), packed));
  EXPECT_EQ(system->characters().palette_format(0), PaletteFormat::matrices);
}

}  // namespace
}  // namespace throng::anim::packed_palettes_test
