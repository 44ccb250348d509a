#include "app/character/cut_scene_models.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace throng::app {
namespace {

constexpr int keys_a_second = 30;
constexpr double rise_seconds = cut_scene_seconds - release_seconds;
constexpr glm::dvec3 hand{-0.34, 0.86, 0.12};  // of an actor at the origin, at size 1

using Turn = glm::dquat;

struct ClipKey {
  glm::dvec3 position{0.0};
  Turn rotation{1.0, 0.0, 0.0, 0.0};
};

anim::Skeleton one_bone(const std::string& name) {
  anim::Skeleton skeleton;
  skeleton.name = name;
  skeleton.bones = {{.name = name, .node = 0, .rest = {}}};
  skeleton.references.resize(1);
  skeleton.palette.resize(1);
  skeleton.level_bone_counts = {1};
  return skeleton;
}

/// Keys of `place_at(seconds)`, evenly from 0 to `duration`.
anim::Clip clip_of(const std::string& name, double duration, const auto& place_at) {
  anim::Clip clip{.name = name, .animation = 0, .duration = duration, .tracks = {}};
  anim::BoneTracks& bone = clip.tracks.emplace_back();
  const int last = static_cast<int>(std::lround(duration * keys_a_second));
  for (int key = 0; key <= last; ++key) {
    const double seconds = duration * key / last;
    const ClipKey place = place_at(seconds);
    bone.translation.times.push_back(static_cast<float>(seconds));
    bone.translation.values.emplace_back(place.position);
    bone.rotation.values.emplace_back(place.rotation);
  }
  bone.rotation.times = bone.translation.times;
  return clip;
}

double turn(double seconds, double period) { return 2.0 * std::numbers::pi * seconds / period; }

ClipKey carried_at(double seconds, double size) {
  const glm::dvec3 bob(0.0, 0.02 * std::sin(turn(seconds, 1.0)), 0.0);
  return {size * (hand + bob), glm::angleAxis(0.07 * std::sin(turn(seconds, 2.0)), glm::dvec3(0.0, 0.0, 1.0))};
}

ClipKey rising_at(double seconds, double size) {
  return {balloon_place(seconds, size), glm::angleAxis(0.16 * std::sin(1.3 * seconds), glm::dvec3(0.0, 0.0, 1.0))};
}

/// Rings of `profile` (radius, height) about +Y, closed by radii of 0, in one colour.
anim::SkinnedMesh turned_surface(std::span<const glm::vec2> profile, const glm::vec4& color) {
  constexpr std::uint32_t around = 20;
  anim::SkinnedMesh mesh;
  for (std::size_t ring = 0; ring < profile.size(); ++ring) {
    const glm::vec2 along = profile[std::min(ring + 1, profile.size() - 1)] - profile[ring == 0 ? 0 : ring - 1];
    const glm::vec2 out = glm::normalize(glm::vec2(along.y, -along.x));
    for (std::uint32_t i = 0; i <= around; ++i) {
      const auto angle = static_cast<float>(turn(i, around));
      const glm::vec2 side(std::sin(angle), std::cos(angle));
      mesh.positions.emplace_back(profile[ring].x * side.x, profile[ring].y, profile[ring].x * side.y);
      mesh.normals.emplace_back(out.x * side.x, out.y, out.x * side.y);
    }
  }
  for (std::uint32_t ring = 0; ring + 1 < profile.size(); ++ring) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t a = ring * (around + 1) + i, b = a + around + 1;
      for (const std::uint32_t corner : {a, a + 1, b + 1, a, b + 1, b}) mesh.indices.push_back(corner);
    }
  }
  mesh.colors.assign(mesh.positions.size(), color);
  mesh.palette_entries.assign(mesh.positions.size(), glm::u16vec4(0));
  mesh.weights.assign(mesh.positions.size(), glm::vec4(1.0F, 0.0F, 0.0F, 0.0F));
  return mesh;
}

std::vector<glm::vec2> scaled(std::vector<glm::vec2> profile, double size) {
  for (glm::vec2& point : profile) point *= static_cast<float>(size);
  return profile;
}

anim::SkinnedMesh balloon_skin(double size) {
  constexpr int rings = 14;
  constexpr float radius = 0.19F, stretch = 1.22F, middle = 1.17F;
  std::vector<glm::vec2> profile;
  for (int ring = 0; ring <= rings; ++ring) {
    const auto angle = static_cast<float>(std::numbers::pi * ring / rings);
    const float taper = 1.0F - 0.14F * (1.0F + std::cos(angle)) * 0.5F;  // narrower towards the knot
    profile.emplace_back(radius * taper * std::sin(angle), middle - radius * stretch * std::cos(angle));
  }
  return turned_surface(scaled(profile, size), {0.62F, 0.02F, 0.03F, 1.0F});
}

anim::SkinnedMesh balloon_string(double size) {
  constexpr float thin = 0.005F;
  return turned_surface(scaled({{thin, 0.0F}, {thin, 0.9F}, {0.022F, 0.925F}, {thin, 0.945F}}, size),
                        {0.75F, 0.75F, 0.72F, 1.0F});
}

/// A key of the camera: its position and the point that it looks at, for an actor of size 1.
struct View {
  double seconds;
  glm::dvec3 eye, target;
};

constexpr std::array<View, 6> views = {{
    {0.0, {0.9, 1.45, 2.6}, {-0.1, 1.3, -4.0}},
    {4.0, {1.5, 1.30, 3.6}, {-0.1, 1.25, 0.0}},
    {6.0, {1.6, 0.95, 3.4}, {-0.3, 3.0, 0.0}},
    {8.5, {0.6, 2.20, 7.8}, {-0.3, 4.1, 0.0}},
    {11.0, {-2.2, 5.60, 9.0}, {-0.2, 2.8, -0.5}},
    {14.0, {-4.6, 7.40, 9.8}, {0.0, 1.0, -0.5}},
}};

/// Through the second and third of four points (Catmull and Rom 1974), where the points are evenly apart in time.
glm::dvec3 through(const std::array<glm::dvec3, 4>& p, double t) {
  const glm::dvec3 a = 2.0 * p[1], b = p[2] - p[0];
  const glm::dvec3 c = 2.0 * p[0] - 5.0 * p[1] + 4.0 * p[2] - p[3], d = 3.0 * (p[1] - p[2]) + p[3] - p[0];
  return 0.5 * (a + t * (b + t * (c + t * d)));
}

ClipKey camera_at_time(double seconds, double size) {
  std::size_t view = 0;
  while (view + 2 < views.size() && seconds >= views[view + 1].seconds) ++view;
  const double share = (seconds - views[view].seconds) / (views[view + 1].seconds - views[view].seconds);
  std::array<glm::dvec3, 4> eyes, targets;
  for (std::size_t i = 0; i < 4; ++i) {
    const View& point = views[std::clamp<std::size_t>(view + i, 1, views.size()) - 1];
    eyes[i] = point.eye;
    targets[i] = point.target;
  }
  const glm::dvec3 eye = through(eyes, share), target = through(targets, share);
  return {size * eye, glm::quatLookAt(glm::normalize(target - eye), glm::dvec3(0.0, 1.0, 0.0))};
}

}  // namespace

glm::dvec3 balloon_place(double seconds, double size) {
  const double height = 1.25 * (seconds - 1.0 + std::exp(-seconds));  // gathers speed, then rises evenly
  return size * (hand + glm::dvec3(0.3 * std::sin(0.9 * seconds), height, 0.1 * (1.0 - std::cos(0.7 * seconds))));
}

CharacterSource balloon(double size) {
  CharacterSource source;
  source.name = "balloon";
  source.model.skeleton = one_bone("balloon");
  source.model.materials.resize(1);
  source.model.meshes = {balloon_skin(size), balloon_string(size)};
  source.model.clips.push_back(clip_of("carried", 2.0, [&](double t) { return carried_at(t, size); }));
  source.model.clips.push_back(clip_of("rise", rise_seconds, [&](double t) { return rising_at(t, size); }));
  const anim::BakeOptions all_in_the_pose{.take_root_motion = false};
  source.character = std::make_shared<const anim::Character>(anim::bake_character(source.model, all_in_the_pose));
  for (const anim::BakedClip& clip : source.character->clips) source.clip_names.push_back(clip.name);
  source.roles.is_prop = true;
  source.roles.others = {0};
  source.roles.height = source.character->bounds.height;
  source.roles.radius = source.character->bounds.body_radius;
  return source;
}

std::shared_ptr<const anim::Character> film_camera(double size) {
  anim::Model model;
  model.skeleton = one_bone("camera");
  model.clips.push_back(clip_of("film", cut_scene_seconds, [&](double t) { return camera_at_time(t, size); }));
  return std::make_shared<const anim::Character>(anim::bake_character(model, {.take_root_motion = false}));
}

}  // namespace throng::app
