// No order of calls of C and no number brings the library down, whatever the caller gets wrong.
//
//     THRONG_RANDOM_SECONDS=3600 build/release/tests/throng_api_tests --gtest_filter='ApiCRandomCalls.*'

#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "tests/api/c/c_crowd.h"

namespace throng::c_random_calls_test {
namespace {

using api_test::CCrowd;
using api_test::first_character;

constexpr std::uint32_t room = 256;  // elements of each array

/// Calls functions of C with numbers that are none, ids that there are not, null pointers, and structs of wrong sizes.
/// Other pointers have the room that the call says. The same seed makes the same calls.
class CRandomCalls {
 public:
  explicit CRandomCalls(std::uint32_t seed) : random_(seed), c_(4) {
    begin_builder();
    snapshot_ = throng_crowd_snapshot(c_.crowd);
    throng_crowd_write_joints(c_.crowd, first_character, nullptr);
    add_frames();
    add_channels();
    add_processes();
    add_motion();
    add_characters();
    add_bones();
    add_builder();
  }
  ~CRandomCalls() {
    throng_snapshot_free(snapshot_);
    throng_builder_free(builder_);
  }
  CRandomCalls(const CRandomCalls&) = delete;
  CRandomCalls& operator=(const CRandomCalls&) = delete;

  void call() { calls_[below(static_cast<std::uint32_t>(calls_.size()))](); }
  /// Poses the agents that play, and returns how many numbers of their joints are not finite.
  std::size_t pose_all() {
    std::size_t wrong = 0;
    for (const throng_id agent : c_.ids) {
      throng_pose_request request{};
      request.agent = agent;
      request.joints = joints_;
      if (throng_crowd_update(c_.crowd, &request, 1) != 0) continue;
      const std::size_t floats = throng_crowd_joint_bytes(c_.crowd, first_character) / sizeof(float);
      for (const float number : std::span(joints_, floats)) wrong += std::isfinite(number) ? 0U : 1U;
    }
    return wrong;
  }
  std::uint32_t built() const { return built_; }

 private:
  std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(random_() % limit); }
  bool seldom() { return one_in(16); }
  bool one_in(std::uint32_t times) { return below(times) == 0; }
  float number() {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    constexpr std::array odd{0.0F, std::nanf(""), infinite, -infinite, 3.4e38F, -3.4e38F, 1e-42F, 1e9F};
    return one_in(8) ? odd[below(odd.size())] : static_cast<float>(below(4000)) / 1000.0F - 1.0F;
  }
  double seconds() { return static_cast<double>(number()); }
  std::uint32_t index() {
    constexpr std::array odd{16U, 31U, 255U, 256U, 1U << 20U, 0x7fffffffU, 0x80000000U, THRONG_NONE};
    return one_in(6) ? odd[below(odd.size())] : below(4);
  }
  throng_id agent() { return one_in(6) ? throng_id{index(), index()} : c_.ids[below(4)]; }
  throng_crowd* crowd() { return maybe(c_.crowd); }
  throng_character* character() { return maybe(c_.character); }
  throng_builder* builder() { return maybe(builder_); }
  template <typename T>
  T* maybe(T* pointer) {
    return seldom() ? nullptr : pointer;
  }
  /// Returns a struct of options, seldom of a wrong size.
  template <typename Options>
  Options sized(Options options) {
    if (seldom()) options.size = index();
    return options;
  }
  const float* numbers() {
    for (float& one : numbers_) one = number();
    return maybe(&numbers_[0]);
  }
  const float* sound_numbers() {
    for (std::uint32_t i = 0; i < room; ++i) numbers_[i] = static_cast<float>(i) / static_cast<float>(room);
    return seldom() ? numbers() : &numbers_[0];
  }
  throng_place place() { return {{number(), number(), number()}, {number(), number(), number(), number()}}; }
  void add(std::function<void()> call) { calls_.push_back(std::move(call)); }

  void add_frames();
  void add_channels();
  void add_processes();
  void add_motion();
  void add_characters();
  void add_bones();
  void add_builder();
  void add_mesh();
  void begin_builder();
  void build();

  std::mt19937 random_;
  CCrowd c_;
  throng_builder* builder_ = nullptr;
  throng_snapshot* snapshot_ = nullptr;
  std::vector<std::function<void()>> calls_;
  std::uint32_t built_ = 0;
  float numbers_[room] = {};
  alignas(16) float joints_[16 * room] = {};
};

void CRandomCalls::add_frames() {
  add([this] { throng_crowd_advance(crowd(), one_in(2) ? 1.0 / 60.0 : seconds()); });
  add([this] {
    throng_pose_request requests[3];
    for (auto& one : requests) {
      one = {.agent = agent(),
             .level = index(),
             .fade_level = index(),
             .fade_halves = index(),
             .look_ahead = seconds(),
             .palette = nullptr,
             .joints = one_in(2) ? nullptr : joints_};
    }
    throng_crowd_update(crowd(), maybe(&requests[0]), below(4));
  });
  add([this] {
    throng_transform bones[room];
    throng_crowd_local_pose(crowd(), agent(), maybe(&bones[0]), below(room));
  });
  add([this] {
    throng_bounding_box box;
    throng_crowd_bounds(crowd(), agent(), maybe(&box));
  });
  add([this] { throng_crowd_snapshot_into(crowd(), maybe(snapshot_)); });
  add([this] { throng_crowd_restore(crowd(), maybe(snapshot_)); });
}

void CRandomCalls::add_channels() {
  add([this] {
    throng_play play = sized(throng_play_default());
    play.clip = index(), play.fade = number(), play.speed = number(), play.start = number(), play.loop = index();
    throng_agent_play_on(crowd(), agent(), one_in(2) ? 0 : index(), maybe(&play));
  });
  add([this] {
    throng_layer layer = sized(throng_layer_default());
    layer.weight = number();
    throng_agent_add_slot(crowd(), agent(), maybe(&layer));
  });
  add([this] {
    throng_one_shot shot = sized(throng_one_shot_default());
    shot.clip = index(), shot.fade_in = number(), shot.fade_out = number(), shot.speed = number();
    throng_agent_play_once(crowd(), agent(), index(), maybe(&shot));
  });
  add([this] {
    const throng_blend_point points[] = {{index(), number(), index()}, {index(), number(), index()}};
    throng_blend_space space = sized(throng_blend_space_default());
    space.points = maybe(&points[0]);
    space.point_count = below(3);
    throng_agent_add_blend_space(crowd(), agent(), maybe(&space), nullptr);
  });
  add([this] { throng_agent_set_speed(crowd(), agent(), number()); });
  add([this] { throng_agent_set_weight(crowd(), agent(), index(), number(), number()); });
  add([this] { throng_agent_set_parameters(crowd(), agent(), index(), number(), number()); });
  add([this] { throng_agent_remove_channel(crowd(), agent(), index()); });
  add([this] { throng_agent_is_playing(crowd(), agent(), index()); });
}

void CRandomCalls::add_processes() {
  add([this] { throng_agent_add_look_at(crowd(), agent(), nullptr); });
  add([this] { throng_agent_add_foot_placement(crowd(), agent(), nullptr); });
  add([this] { throng_agent_add_ragdoll(crowd(), agent(), nullptr); });
  add([this] {
    throng_noise noise = sized(throng_noise_default());
    noise.frequency = number(), noise.amplitude = number(), noise.mask = one_in(2) ? THRONG_NONE : index();
    throng_agent_add_noise(crowd(), agent(), maybe(&noise));
  });
  add([this] {
    throng_reach reach = sized(throng_reach_default());
    reach.limb = index(), reach.softness = number();
    throng_agent_add_reach(crowd(), agent(), maybe(&reach));
  });
  add([this] { throng_agent_look_at(crowd(), agent(), index(), numbers(), number()); });
  add([this] { throng_agent_reach(crowd(), agent(), index(), numbers(), number(), number()); });
  add([this] { throng_agent_push(crowd(), agent(), index(), numbers(), numbers()); });
  add([this] { throng_agent_set_ground(crowd(), agent(), index(), index(), numbers(), numbers()); });
  add([this] {
    const throng_place where = place();
    throng_agent_set_placement(crowd(), agent(), index(), maybe(&where));
  });
  add([this] { throng_agent_ankle(crowd(), agent(), index(), index(), maybe(&joints_[0])); });
  add([this] { throng_agent_remove_process(crowd(), agent(), index()); });
}

void CRandomCalls::add_motion() {
  add([this] {
    throng_root_motion motion;
    throng_agent_displacement(crowd(), agent(), seconds(), seconds(), maybe(&motion));
  });
  add([this] { throng_agent_curve(crowd(), agent(), index()); });
  add([this] { throng_agent_morph_weights(crowd(), agent(), maybe(&numbers_[0]), below(room)); });
  add([this] {
    throng_key keys[4];
    throng_agent_keys(crowd(), agent(), seconds(), seconds(), index(), maybe(&keys[0]), below(5));
  });
  add([this] {
    const throng_gaze_request gazes[] = {{agent(), index(), {number(), 0.0F, 1.0F}, number()}};
    throng_crowd_look_at(crowd(), maybe(&gazes[0]), below(2));
  });
  add([this] {
    const throng_speed_request speeds[] = {{agent(), number()}};
    throng_crowd_set_speeds(crowd(), maybe(&speeds[0]), below(2));
  });
}

void CRandomCalls::add_characters() {
  add([this] { throng_character_clip_name(character(), index()); });
  add([this] { throng_character_bone_name(character(), index()); });
  add([this] { throng_character_bone_parent(character(), index()); });
  add([this] { throng_character_morph_name(character(), index()); });
  add([this] { throng_character_palette_entries(character(), index()); });
  add([this] {
    throng_mesh mesh = sized(throng_mesh_default());
    throng_character_mesh(character(), index(), maybe(&mesh));
  });
  add([this] {
    std::uint16_t entries[room];
    throng_character_entries_at_level(character(), index(), maybe(&entries[0]), below(room));
  });
  add([this] {
    throng_bounding_box box;
    throng_character_clip_bounds(character(), one_in(50) ? 0 : 99, maybe(&box));
  });
}

void CRandomCalls::add_bones() {
  add([this] {
    throng_bone_to_build bone = sized(throng_bone_to_build_default());
    bone.name = maybe("bone");
    bone.parent = seldom() ? index() : 0;
    if (seldom()) bone.rest = {{number(), number(), number()}, {number(), number(), number(), number()}, {number()}};
    if (seldom()) bone.inverse_bind = numbers();
    if (seldom()) bone.role = one_in(2) ? "head" : "paw";
    throng_builder_add_bone(builder(), maybe(&bone));
  });
  add([this] { throng_builder_add_clip(builder(), maybe("clip"), seldom() ? seconds() : 1.0); });
  add([this] { throng_builder_add_data_key(builder(), seldom() ? 1 : 0, maybe("key"), seldom() ? seconds() : 0.5); });
  add([this] {
    throng_builder_add_curve(builder(), seldom() ? 1 : 0, maybe("c"), sound_numbers(), joints_, below(room));
  });
}

void CRandomCalls::add_builder() {
  for (const auto set : {throng_builder_set_translations, throng_builder_set_rotations, throng_builder_set_scales}) {
    add([this, set] {
      const float* const times = sound_numbers();
      const throng_bone_keys keys{
          .seconds = times, .values = maybe(times), .count = below(16), .form = seldom() ? index() : 0};
      set(builder(), seldom() ? index() : 0, seldom() ? index() : 0, maybe(&keys));
    });
  }
  add([this] { add_mesh(); });
  add([this] { build(); });
}

void CRandomCalls::add_mesh() {
  std::uint16_t entries[32];
  std::uint32_t indices[12];
  const std::uint8_t texels[16] = {};
  const float whole_weights[32] = {1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F};
  const throng_morph_delta deltas[] = {{.vertex = index(), .morph = index(), .position = {number()}, .normal = {}}};
  const bool is_sound = !one_in(4);
  for (auto& one : entries) one = static_cast<std::uint16_t>(is_sound ? 0 : index());
  for (auto& one : indices) one = is_sound ? below(3) : index();
  throng_mesh mesh = sized(throng_mesh_default());
  mesh.vertex_count = is_sound ? 3 : below(8);
  mesh.index_count = is_sound ? 3 : below(12);
  mesh.morph_delta_count = is_sound ? 0 : below(2);
  mesh.positions = mesh.normals = sound_numbers();
  mesh.weights = is_sound ? whole_weights : mesh.positions;
  mesh.texture_coords = mesh.tangents = mesh.colors = maybe(mesh.positions);
  mesh.palette_entries = maybe(&entries[0]);
  mesh.indices = maybe(&indices[0]);
  mesh.morph_deltas = maybe(&deltas[0]);
  mesh.alpha = seldom() ? index() : below(3);
  mesh.base_color_texels = one_in(2) ? nullptr : texels;
  mesh.texture_width = is_sound ? mesh.base_color_texels != nullptr : static_cast<std::int32_t>(below(4)) - 1;
  mesh.texture_height = is_sound ? mesh.texture_width : static_cast<std::int32_t>(below(4)) - 1;
  throng_builder_add_mesh(builder(), maybe(&mesh));
}

/// Builds what there is, and begins anew.
void CRandomCalls::build() {
  throng_load_options options = sized(throng_load_options_default());
  options.keep_meshes = 1;
  if (seldom()) options.metres_a_unit = seconds();
  throng_file* const file = throng_builder_build(builder_, maybe(&options));
  if (file != nullptr) ++built_;
  throng_file_free(file);
  throng_builder_free(builder_);
  begin_builder();
}

void CRandomCalls::begin_builder() {
  builder_ = throng_builder_create("random");
  const throng_bone_to_build root = throng_bone_to_build_default();
  throng_builder_add_bone(builder_, &root);
  throng_builder_add_clip(builder_, "first", 1.0);
}

TEST(ApiCRandomCalls, NeitherCrashNorPoseWhatIsNoNumber) {
  const char* const wanted = std::getenv("THRONG_RANDOM_SECONDS");
  const std::chrono::duration<double> seconds(wanted == nullptr ? 0.0 : std::atof(wanted));
  const auto start = std::chrono::steady_clock::now();
  std::uint32_t seed = 0, built = 0;
  do {
    CRandomCalls random(seed++);
    for (int call = 0; call < 3000; ++call) {
      random.call();
      if (call % 16 != 0) continue;
      ASSERT_EQ(random.pose_all(), 0U) << "seed " << seed - 1 << ", call " << call;
    }
    built += random.built();
  } while (seed < 3 || std::chrono::steady_clock::now() - start < seconds);
  EXPECT_GT(built, 0U) << "some of what it tells a builder is sound";
}

}  // namespace
}  // namespace throng::c_random_calls_test
