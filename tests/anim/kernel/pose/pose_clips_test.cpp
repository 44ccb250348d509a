#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/kernel/kernels.h"
#include "tests/anim/bake/sampled_rows.h"
#include "tests/anim/kernel/validity.h"

namespace throng::anim::pose_clips_test {
namespace {

using namespace sampled_rows;

struct alignas(64) Line {
  float floats[packet_bones];
};

/// One packet of a strip, each character's poison until it is posed.
class Local {
 public:
  explicit Local(int components)
      : components_(components), lines_(static_cast<std::size_t>(widest_strip * components), poison()) {}
  float* data() { return lines_.front().floats; }
  std::vector<float> character(int index, int components) const {
    const float* first = lines_[static_cast<std::size_t>(index * components_)].floats;
    return {first, first + static_cast<std::ptrdiff_t>(components) * packet_bones};
  }
  static Line poison() {
    Line line;
    std::fill(std::begin(line.floats), std::end(line.floats), std::numeric_limits<float>::quiet_NaN());
    return line;
  }

 private:
  int components_;
  std::vector<Line> lines_;
};

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

constexpr int bones = 37;
constexpr int packets = packets_for(bones);

/// Some characters of a strip, but not all, play one clip; every second of them is blended with another.
class PoseClips : public ::testing::TestWithParam<int> {
 protected:
  PoseClips() {
    for (int character = 0; character < widest_strip; ++character) {
      const auto index = static_cast<std::size_t>(character);
      clips_[index] = moment(first_, 7 * character);
      blended_[index] = moment(second_, 11 * character);
      if (character % 5 == 3) continue;
      shown_[index].clip = &clips_[index];
      if (character % 2 == 1) continue;
      shown_[index].blended = &blended_[index];
      shown_[index].fraction = 0.05F + 0.055F * static_cast<float>(character);
    }
  }

  PoseClipsJob job(int packet, Local& local) const {
    return {.characters = shown_, .packet = packet, .components = GetParam(), .local = local.data()};
  }

  /// One character by the kernels that pose one packet at a time.
  Local one_by_one(const Kernels& kernels, const ShownClips& shown, int packet) const {
    Local local(GetParam());
    sample(kernels, *shown.clip, packet, local);
    if (shown.blended == nullptr) return local;
    Local to(GetParam());
    sample(kernels, *shown.blended, packet, to);
    kernels.blend({.from = local.data(),
                   .to = to.data(),
                   .bone_weights = nullptr,
                   .fraction = shown.fraction,
                   .components = GetParam(),
                   .out = local.data()});
    return local;
  }

  static void sample(const Kernels& kernels, const ClipMoment& clip, int packet, Local& local) {
    kernels.sample({.stream = clip.stream, .point = clip.point, .packet = packet, .pose = local.data()});
  }

  static ClipMoment moment(const StreamBlock& block, int eighths) {
    const Ticks time = block.stream().first_row + eighths * Ticks{block.stream().step_ticks} / 8;
    return {.stream = &block.stream(), .point = locate(block.stream(), time)};
  }

  const StreamBlock first_ = StreamBlock(wavy_rows(bones, GetParam(), 24));
  const StreamBlock second_ = StreamBlock(still_rows(bones, GetParam(), 24));
  std::array<ClipMoment, widest_strip> clips_, blended_;
  std::array<ShownClips, widest_strip> shown_;
};

/// A clip, and characters that show it in a wrong way.
struct ShownWrongly {
  static inline const StreamBlock block{wavy_rows(bones, rigid_components, 24)};
  static inline const ClipMoment moment{&block.stream(), locate(block.stream(), Ticks{})},
      no_stream{nullptr, moment.point};
  static inline const ClipMoment no_rows{&block.stream(), {}};
  static inline const ClipMoment heavy{&block.stream(), {moment.point.from, moment.point.to, 7}};
  static inline const ShownClips right{&moment, &moment, 0.5F}, alone{&moment, nullptr, 0.0F},
      onto_nothing{nullptr, &moment, 0.5F};
  static inline const ShownClips without_stream{&no_stream, nullptr, 0.0F}, without_rows{&no_rows, nullptr, 0.0F};
  static inline const ShownClips with_odd_weights{&heavy, nullptr, 0.0F}, wholly_blended{&moment, &moment, 1.0F};
};

TEST(PoseClipsJob, IsValidAsItsCommentsSay) {
  static const std::array<ShownClips, widest_strip + 1> too_many{};
  Local local(rigid_components);
  const PoseClipsJob job{.characters = {&ShownWrongly::right, 1}, .packet = 1, .displaced = 1, .local = local.data()};
  expect_validity<PoseClipsJob>(
      job, {{true, "nobody", [](PoseClipsJob& job) { job.characters = {}; }},
            {true, "one clip",
             [](PoseClipsJob& job) {
               job.characters = {&ShownWrongly::alone, 1};
             }},
            {false, "onto nothing",
             [](PoseClipsJob& job) {
               job.characters = {&ShownWrongly::onto_nothing, 1};
             }},
            {false, "without stream",
             [](PoseClipsJob& job) {
               job.characters = {&ShownWrongly::without_stream, 1};
             }},
            {false, "without rows",
             [](PoseClipsJob& job) {
               job.characters = {&ShownWrongly::without_rows, 1};
             }},
            {false, "with odd weights",
             [](PoseClipsJob& job) {
               job.characters = {&ShownWrongly::with_odd_weights, 1};
             }},
            {false, "wholly blended",
             [](PoseClipsJob& job) {
               job.characters = {&ShownWrongly::wholly_blended, 1};
             }},
            {false, "a strip that is too wide", [](PoseClipsJob& job) { job.characters = too_many; }},
            {false, "a negative packet", [](PoseClipsJob& job) { job.packet = -1; }},
            {false, "a packet that no clip has", [](PoseClipsJob& job) { job.packet = packets; }},
            {false, "quads that no packet has", [](PoseClipsJob& job) { job.displaced = all_quads + 1; }},
            {false, "other components than the clip", [](PoseClipsJob& job) { job.components = general_components; }},
            {false, "no local", [](PoseClipsJob& job) { job.local = nullptr; }},
            {false, "local off the alignment", [](PoseClipsJob& job) { job.local += 4; }}});
}

TEST_P(PoseClips, GivesTheBitsOfSamplingAndBlendingOnEveryTarget) {
  for (const Kernels& kernels : runnable_kernels()) {
    for (int packet = 0; packet < packets; ++packet) {
      Local local(GetParam());
      kernels.pose_clips(job(packet, local));
      for (int character = 0; character < widest_strip; ++character) {
        const ShownClips& shown = shown_[static_cast<std::size_t>(character)];
        if (shown.clip == nullptr) continue;
        const Local expected = one_by_one(kernels, shown, packet);
        EXPECT_TRUE(same_bits(local.character(character, GetParam()), expected.character(0, GetParam())))
            << kernels.target << " packet " << packet << " character " << character;
      }
    }
  }
}

TEST_P(PoseClips, LeavesCharactersAloneThatPlayNone) {
  const std::vector<float> untouched = Local(GetParam()).character(0, GetParam());
  for (const Kernels& kernels : runnable_kernels()) {
    Local local(GetParam());
    kernels.pose_clips(job(1, local));
    for (const int character : {3, 8, 13}) {
      EXPECT_TRUE(same_bits(local.character(character, GetParam()), untouched)) << kernels.target << " " << character;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(States, PoseClips, ::testing::Values(rigid_components, general_components),
                         [](const auto& components) { return components.param == 7 ? "rigid" : "general"; });

/// Where the quads of `displaced` alone have positions.
SampledRows rows_displaced_in(QuadMask displaced, SampledRows rows) {
  for (int row = 0; row < rows.row_count; ++row) {
    for (int component = 4; component < rigid_components; ++component) {
      for (int bone = 0; bone < packet_bones; ++bone) {
        if (!is_in(displaced, bone / quad_bones)) row_value(rows, row, 0, component, bone) = 0.0F;
      }
    }
  }
  return rows;
}

TEST(PoseClipsThatDisplaceSomeQuads, WritesRotationsAndTheirPositionsAndNoOthers) {
  for (QuadMask displaced = 0; displaced <= all_quads; ++displaced) {
    const StreamBlock block(rows_displaced_in(displaced, wavy_rows(16, rigid_components, 4)));
    const StreamBlock still(rows_displaced_in(displaced, still_rows(16, rigid_components, 4)));
    ASSERT_EQ(quads_of_packet(block.stream().displaced_quads, 0), displaced);
    const Ticks time = Ticks{block.stream().step_ticks} / 3;
    const ClipMoment clip{.stream = &block.stream(), .point = locate(block.stream(), time)};
    const ClipMoment other{.stream = &still.stream(), .point = locate(still.stream(), time)};
    const std::array<ShownClips, 2> shown = {{{.clip = &clip}, {.clip = &clip, .blended = &other, .fraction = 0.25F}}};
    for (const Kernels& kernels : runnable_kernels()) {
      Local all(rigid_components);
      Local some(rigid_components);
      kernels.pose_clips({.characters = shown, .displaced = all_quads, .local = all.data()});
      kernels.pose_clips({.characters = shown, .displaced = displaced, .local = some.data()});
      for (const int character : {0, 1}) {
        EXPECT_TRUE(same_bits(some.character(character, 4), all.character(character, 4))) << kernels.target;
        const std::vector<float> whole = all.character(character, rigid_components);
        const std::vector<float> partly = some.character(character, rigid_components);
        for (std::size_t lane = std::size_t{4} * packet_bones; lane < whole.size(); ++lane) {
          if (is_in(displaced, static_cast<int>(lane % packet_bones) / quad_bones)) {
            EXPECT_EQ(partly[lane], whole[lane]) << kernels.target << " " << displaced << " " << lane;
          } else {
            EXPECT_EQ(whole[lane], 0.0F) << kernels.target << " " << displaced << " " << lane;
            EXPECT_TRUE(std::isnan(partly[lane])) << kernels.target << " " << displaced << " " << lane;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace throng::anim::pose_clips_test
