#include "tests/anim/asset/clip_fixtures.h"

#include <random>

#include "engine/anim/asset/synthetic_model.h"

namespace throng::anim {

namespace {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  float between(float low, float high) { return low + (high - low) * static_cast<float>(engine_() % 100'000U) / 1e5F; }
  int whole(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }
  glm::vec3 vector(float reach) { return {between(-reach, reach), between(-reach, reach), between(-reach, reach)}; }

 private:
  std::mt19937 engine_;
};

std::vector<float> uneven_times(Random& random, double seconds) {
  const int keys = random.whole(2, 40);
  std::vector<float> times;
  for (int key = 0; key < keys; ++key) {
    const float share = (static_cast<float>(key) + random.between(0.2F, 0.8F)) / static_cast<float>(keys);
    times.push_back(static_cast<float>(seconds) * share);
  }
  return times;
}

template <typename Value, typename Make>
Track<Value> wild_track(Random& random, Interpolation interpolation, double seconds, const Make& make) {
  Track<Value> track{.interpolation = interpolation, .times = uneven_times(random, seconds), .values = {}};
  const std::size_t values = track.times.size() * (interpolation == Interpolation::cubic_spline ? 3 : 1);
  for (std::size_t i = 0; i < values; ++i) track.values.push_back(make(i));
  return track;
}

}  // namespace

Model general_model(int bones) {
  Model model = synthetic_model(bones, 1);
  model.skeleton.rigid = false;
  for (ReferenceFrame& reference : model.skeleton.references) reference = {};
  for (std::size_t bone = 0; bone < model.skeleton.bones.size(); ++bone) {
    model.skeleton.bones[bone].rest.scale = glm::vec3(1.0F, bone % 3 == 0 ? 1.3F : 1.0F, 0.9F);
  }
  if (bones > 3) model.skeleton.bones[3].prefix[0] = glm::dvec4(1.0, 0.25, 0.0, 0.0);
  return model;
}

Clip wild_clip(const Skeleton& skeleton, Interpolation interpolation, double seconds, unsigned seed) {
  Random random(seed);
  Clip clip;
  clip.duration = seconds;
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    const glm::vec3 rest = skeleton.bones[static_cast<std::size_t>(bone)].rest.translation;
    BoneTracks tracks;
    tracks.bone = bone;
    tracks.rotation = wild_track<glm::quat>(random, interpolation, seconds, [&](std::size_t) {
      return glm::normalize(glm::quat(random.between(-1.0F, 1.0F), random.vector(1.0F)));
    });
    tracks.translation =
        wild_track<glm::vec3>(random, interpolation, seconds, [&](std::size_t) { return rest + random.vector(0.2F); });
    if (!skeleton.rigid) {
      tracks.scale = wild_track<glm::vec3>(random, interpolation, seconds,
                                           [&](std::size_t) { return glm::vec3(1.0F) + random.vector(0.3F); });
    }
    clip.tracks.push_back(std::move(tracks));
  }
  return clip;
}

Model one_bone_model() {
  Model model = synthetic_model(1, 1);
  model.skeleton.bones.front().rest = {};
  model.skeleton.references.front() = {};
  model.clips.clear();
  return model;
}

Model rod_model() {
  Model model = one_bone_model();
  SkinnedMesh mesh;
  mesh.positions = {glm::vec3(0.0F), glm::vec3(0.0F, 1.8F, 0.0F), glm::vec3(0.1F, 0.9F, 0.0F)};
  mesh.palette_entries.assign(3, glm::u16vec4(0));
  mesh.weights.assign(3, glm::vec4(1.0F, 0.0F, 0.0F, 0.0F));
  mesh.indices = {0, 1, 2};
  model.meshes.push_back(mesh);
  return model;
}

Clip one_bone_clip(const BoneTracks& tracks, double seconds) {
  Clip clip;
  clip.name = "clip";
  clip.duration = seconds;
  clip.tracks.push_back(tracks);
  return clip;
}

Track<glm::vec3> sampled_track(const std::function<glm::vec3(float)>& value, double rate, int steps, double first) {
  Track<glm::vec3> track;
  for (int step = 0; step <= steps; ++step) {
    track.times.push_back(static_cast<float>(first + step / rate));
    track.values.push_back(value(track.times.back()));
  }
  return track;
}

TestPlayer::TestPlayer(const KeyframeStream& stream)
    : stream_(stream), bytes_(interpolation_bytes(stream.bone_count, stream.components)) {}

std::vector<float> TestPlayer::pose_at(Ticks time) {
  const std::size_t packet_floats = static_cast<std::size_t>(stream_.components) * packet_bones;
  std::vector<float> pose(packet_floats * static_cast<std::size_t>(packets_for(stream_.bone_count)));
  advance_keyframes(stream_, time, cursor_, bytes_);
  for (int packet = 0; packet < packets_for(stream_.bone_count); ++packet) {
    evaluate_keyframes(stream_, time, bytes_, packet,
                       std::span(pose).subspan(static_cast<std::size_t>(packet) * packet_floats, packet_floats));
  }
  return pose;
}

float component_of(std::span<const float> pose, int components, int bone, int component) {
  const int place = (bone / packet_bones * components + component) * packet_bones + bone % packet_bones;
  return pose[static_cast<std::size_t>(place)];
}

}  // namespace throng::anim
