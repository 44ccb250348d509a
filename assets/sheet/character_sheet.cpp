// throng_character_sheet FOLDER: the built-in character looked at from all sides, in pictures for people.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numbers>

#include <glm/gtc/quaternion.hpp>

#include "assets/sheet/contact_sheet.h"
#include "assets/sheet/studio.h"
#include "engine/anim/asset/reference_pose.h"

namespace throng::sheet {
namespace {

namespace fs = std::filesystem;
using mannequin::Pose;
using mannequin::Side;

constexpr int columns = 8;
constexpr float eighth = std::numbers::pi_v<float> / 4.0F;

app::Tints dressed(std::uint32_t person) {
  Random random(person, 0);
  return app::random_tints(random);
}
const app::Tints plain_clothes = dressed(12);

float column_place(int column, float pitch) { return (static_cast<float>(column) - 0.5F * (columns - 1)) * pitch; }

render::Image views_of_bind_pose(Studio& studio) {
  constexpr float pitch = 1.5F;
  std::vector<Figure> figures;
  figures.reserve(columns);
  for (int column = 0; column < columns; ++column) {
    figures.push_back({.place = {column_place(column, pitch), 0.0F, 0.0F},
                       .heading = static_cast<float>(column) * eighth,
                       .tints = plain_clothes});
  }
  return studio.take({.width = 1200, .height = 205, .metres = 2.05F, .centre = {0.0F, 0.93F, 0.0F}}, figures);
}

render::Image phases_of_clip(Studio& studio, const anim::Clip& clip, float heading) {
  constexpr float pitch = 1.35F;
  std::vector<Figure> figures;
  figures.reserve(columns);
  for (int column = 0; column < columns; ++column) {
    const double seconds = clip.duration * column / columns;
    const auto root = anim::reference_pose(studio.character().model.skeleton, &clip, seconds).globals;
    figures.push_back({.clip = clip.name,
                       .seconds = seconds,
                       .place = {column_place(column, pitch), 0.0F, 0.0F},
                       .heading = heading,
                       .tints = plain_clothes});
    const glm::vec3 gone(root[0][3]);
    figures.back().place -= glm::angleAxis(heading, glm::vec3(0.0F, 1.0F, 0.0F)) * glm::vec3(gone.x, 0.0F, gone.z);
  }
  return studio.take({.width = 1000, .height = 220, .metres = 2.36F, .centre = {0.0F, 1.12F, 0.0F}, .shadows = false},
                     figures);
}

Pose bent(double elbow, double knee, double shoulder, double wrist) {
  Pose pose;
  for (const Side side : {Side::left, Side::right}) {
    mannequin::place_arm(
        pose, side, {.flexion = shoulder, .abduction = 8, .elbow = elbow, .pronation = 20, .wrist_flexion = wrist});
    const char* const suffix = side == Side::left ? ".L" : ".R";
    pose[std::string("thigh") + suffix] = mannequin::turned(-0.9 * knee, 0, 0);
    pose[std::string("shin") + suffix] = mannequin::turned(knee, 0, 0);
  }
  return pose;
}

Pose raised(double abduction) {
  Pose pose;
  for (const Side side : {Side::left, Side::right}) {
    mannequin::place_arm(pose, side, {.abduction = abduction, .elbow = 10, .shrug = 0.2 * abduction});
  }
  return pose;
}

render::Image bent_joints(Studio& studio) {
  constexpr float pitch = 1.35F;
  const std::array<Pose, columns> poses{
      bent(60, 0, 20, 0),     bent(100, 0, 20, 40), bent(140, 0, 40, 70), bent(10, 60, 20, 0),
      bent(10, 100, 60, -50), bent(20, 135, 90, 0), raised(90),           raised(150)};
  std::vector<Figure> figures;
  figures.reserve(columns);
  for (int column = 0; column < columns; ++column) {
    figures.push_back({.pose = poses[static_cast<std::size_t>(column)],
                       .place = {column_place(column, pitch), 0.0F, 0.0F},
                       .heading = column < 6 ? eighth * 1.4F : 0.3F,
                       .tints = plain_clothes});
  }
  return studio.take({.width = 1200, .height = 250, .metres = 2.25F, .centre = {0.0F, 1.10F, 0.0F}}, figures);
}

render::Image close_ups(Studio& studio, float metres, glm::vec3 centre, const std::vector<Figure>& figures) {
  return studio.take({.width = 300, .height = 300, .metres = metres, .centre = centre}, figures);
}

render::Image joints_close_up(Studio& studio) {
  const Figure elbow{.pose = bent(110, 0, 25, 0), .heading = 1.9F, .tints = plain_clothes};
  const Figure knee{.pose = bent(10, 110, 20, 0), .heading = 1.4F, .tints = plain_clothes};
  const Figure shoulder{.pose = raised(120), .heading = 0.3F, .tints = plain_clothes};
  const Figure wrist{.pose = bent(90, 0, 20, 60), .heading = -0.5F, .tints = plain_clothes};
  return beside(
      {close_ups(studio, 0.9F, {0.0F, 1.2F, 0.0F}, {elbow}), close_ups(studio, 0.9F, {0.1F, 0.75F, 0.0F}, {knee}),
       close_ups(studio, 1.0F, {0.1F, 1.5F, 0.0F}, {shoulder}), close_ups(studio, 0.8F, {0.0F, 1.1F, 0.0F}, {wrist})});
}

render::Image face_and_hands(Studio& studio) {
  const Figure front{.clip = "idle", .tints = plain_clothes};
  Figure half = front;
  half.heading = 0.75F;
  Figure side = front;
  side.heading = 2.0F * eighth;
  const Figure hand{.heading = 0.9F, .tints = plain_clothes};
  return beside(
      {close_ups(studio, 0.42F, {0.0F, 1.66F, 0.0F}, {front}), close_ups(studio, 0.42F, {0.0F, 1.66F, 0.0F}, {half}),
       close_ups(studio, 0.42F, {0.0F, 1.66F, 0.0F}, {side}), close_ups(studio, 0.42F, {0.38F, 0.98F, 0.0F}, {hand})});
}

render::Image mesh_lods(Studio& studio) {
  std::vector<Figure> figures;
  const auto levels = static_cast<std::uint32_t>(studio.character().model.skeleton.level_bone_counts.size());
  for (std::size_t lod = 0; lod < studio.mesh_lod_count(); ++lod) {
    for (int turn = 0; turn < 2; ++turn) {
      const auto column = static_cast<int>(2 * lod) + turn;
      figures.push_back({.clip = turn == 0 ? "walk" : "",
                         .seconds = 0.0,
                         .place = {column_place(column, 1.35F), 0.0F, 0.0F},
                         .heading = turn == 0 ? 0.8F : 0.0F,
                         .mesh_lod = lod,
                         .bone_level = std::min(static_cast<std::uint32_t>(lod), levels - 1),
                         .tints = plain_clothes});
    }
  }
  return studio.take({.width = 1200, .height = 230, .metres = 2.05F, .centre = {0.0F, 0.93F, 0.0F}}, figures);
}

app::Variant variant_of(std::uint32_t person) {
  Random random(person, 9);
  return app::random_variant(random);
}

/// Each variation at its two ends, then people as a crowd has them.
render::Image variants(Studio& studio, bool people) {
  using app::Variant;
  constexpr std::array<Variant, columns> ends{{{.build = -1},
                                               {.build = 1},
                                               {.frame = -1},
                                               {.frame = 1},
                                               {.posture = -1},
                                               {.posture = 1},
                                               {.fullness = 1},
                                               {.frame = -0.7F, .length = 1}}};
  std::vector<Figure> figures;
  figures.reserve(columns);
  for (int column = 0; column < columns; ++column) {
    const auto person = static_cast<std::uint32_t>(column) + 20;
    figures.push_back({.clip = "idle",
                       .seconds = people ? 0.7 * column : 0.0,
                       .place = {column_place(column, 1.35F), 0.0F, 0.0F},
                       .heading = people ? 0.2F : 0.9F,
                       .scale = people ? 0.92F + 0.02F * static_cast<float>(person * 5 % 8) : 1.0F,
                       .tints = people ? dressed(person) : plain_clothes,
                       .variant = people ? variant_of(person) : ends[static_cast<std::size_t>(column)]});
  }
  return studio.take({.width = 1200, .height = 230, .metres = 2.05F, .centre = {0.0F, 0.93F, 0.0F}}, figures);
}

render::Image at_thirty_pixels(Studio& studio) {
  std::vector<Figure> figures;
  constexpr int people = 40;
  const auto& clips = studio.character().model.clips;
  for (int i = 0; i < people; ++i) {
    const anim::Clip& clip = clips[static_cast<std::size_t>(i) % clips.size()];
    figures.push_back({.clip = clip.name,
                       .seconds = clip.duration * 0.3,
                       .place = {(static_cast<float>(i) - 0.5F * (people - 1)) * 1.7F, 0.0F, 0.0F},
                       .heading = static_cast<float>(i % 5) * 0.6F - 1.2F,
                       .mesh_lod = 2,
                       .bone_level = 1,
                       .tints = dressed(static_cast<std::uint32_t>(i)),
                       .variant = variant_of(static_cast<std::uint32_t>(i))});
    if (clip.name == "walk" || clip.name == "jog" || clip.name == "run") figures.back().seconds = 0.02;
  }
  return studio.take({.width = 1200, .height = 40, .metres = 2.4F, .centre = {0.0F, 0.95F, 0.0F}}, figures);
}

render::Image at_six_hundred_pixels(Studio& studio) {
  const Figure idle{.clip = "idle", .place = {-0.45F, 0.0F, 0.0F}, .heading = -0.3F, .tints = plain_clothes};
  const Figure walk{.clip = "walk",
                    .seconds = 0.0,
                    .place = {0.45F, 0.0F, 0.0F},
                    .heading = 0.7F,
                    .tints = dressed(5),
                    .variant = variant_of(21)};
  const Figure third{.clip = "wave",
                     .seconds = 0.3,
                     .place = {1.35F, 0.0F, 0.0F},
                     .heading = 0.1F,
                     .tints = dressed(8),
                     .variant = variant_of(22)};
  const Figure fourth{.clip = "run",
                      .seconds = 0.1,
                      .place = {-1.35F, 0.0F, 0.0F},
                      .heading = 0.9F,
                      .tints = dressed(3),
                      .variant = variant_of(24)};
  return studio.take({.width = 1200, .height = 660, .metres = 1.98F, .centre = {0.0F, 0.93F, 0.0F}},
                     {idle, walk, third, fourth});
}

int write_sheets(Studio& studio, const fs::path& folder) {
  ContactSheet body;
  body.add(views_of_bind_pose(studio));
  body.add(face_and_hands(studio));
  body.add(bent_joints(studio));
  body.add(joints_close_up(studio));
  body.add(variants(studio, false));
  body.add(variants(studio, true));
  body.add(mesh_lods(studio));
  body.add(at_thirty_pixels(studio));
  body.add(at_six_hundred_pixels(studio));
  ContactSheet clips;
  for (const anim::Clip& clip : studio.character().model.clips) clips.add(phases_of_clip(studio, clip, 0.9F));
  const bool written = body.write(folder / "character_body.png") && clips.write(folder / "character_clips.png");
  return written ? 0 : 1;
}

}  // namespace
}  // namespace throng::sheet

int main(int argument_count, char** arguments) {
  if (argument_count != 2) {
    std::fputs("throng_character_sheet: usage: throng_character_sheet FOLDER\n", stderr);
    return 2;
  }
  const auto studio = throng::sheet::Studio::open();
  return studio ? throng::sheet::write_sheets(*studio, arguments[1]) : 1;
}
