// Makes the inputs that fuzzing begins with, of files that our code writes: throng_fuzz_seeds FOLDER writes
// FOLDER/TARGET/...

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/character/bone_lod.h"
#include "app/character/role_table.h"
#include "app/settings/preset.h"
#include "app/show/recording/writer.h"
#include "app/show/request/crowd_file.h"
#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/pack/pack.h"
#include "engine/base/files/output_file.h"

namespace throng::fuzz {
namespace {

Status write_pack_of(const std::filesystem::path& file, int bones, int clips) {
  pack::FileToPack packed;
  packed.name = "crowd";
  packed.file.file = "crowd.glb";
  packed.with_keys = true;
  packed.file.models = {anim::synthetic_model(bones, clips, 1, 8)};
  pack::CharacterToPack& character = packed.characters.emplace_back();
  character.name = "only";
  character.character = std::make_shared<const anim::Character>(anim::bake_character(packed.file.models[0]));
  character.surface = {std::byte{1}};
  const std::vector<std::byte> bytes = pack::write_pack({&packed, 1});
  return write_whole_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

app::ChosenCharacter person() {
  return {.file = "person.glb",
          .fingerprint = "0123456789abcdef",
          .bones = {"hips", "head"},
          .level_counts = {2, 1},
          .rig = {{anim::BodyRole::left_foot, "ankle"}}};
}

/// Writes a recording with one of everything.
Status write_recording(const std::filesystem::path& file) {
  const app::RecordingHeader header{.characters = {person()}, .tuning = {}, .width = 640, .height = 360};
  const app::RecordedFrame frame{
      .delta = Ticks{10}, .view = {.camera = {}, .width = 640, .height = 360}, .pose_hash = 77};
  auto created = app::RecordingWriter::create(file, header);
  if (!created) return created.error();
  app::RecordingWriter& writer = **created;
  writer.add(frame, std::vector<std::uint64_t>{1, 2, 3});
  app::Tuning tuning;
  tuning.agents = 2;
  const std::vector<app::CrowdRequest> requests{
      app::Apply{tuning},
      app::Select{1},
      app::Push{.agent = 1, .direction = {0.25F, 0.0F, -1.0F}},
      app::SetRoles{},
      app::Hold{.agent = 2, .seconds = 0.75F},
      app::GoBack{},
      app::SetBones{.character = 0, .choice = {.bones = {1, 0}, .level_counts = {2, 1}}},
      app::SetBody{.character = 0, .parts = person().rig},
      app::SetPlacement{.character = 0, .choice = {.scale = 0.01, .up = anim::UpAxis::z}},
      app::SetRules{},
      app::SetShare{.character = 0, .share = 0.5},
      app::LoadModels{{"person.glb"}},
      app::SetCast{{person(), person()}}};
  for (const app::CrowdRequest& request : requests) writer.add(request);
  writer.add(frame, std::vector<std::uint64_t>{1, ~0ULL});
  return writer.finish();
}

/// Writes what a person keeps: tuned values, roles and parts of the body, an order of bones.
Status write_kept(const std::filesystem::path& folder) {
  if (Status written = app::write_preset(folder / "preset" / "every-key.json", app::Preset{}); !written) {
    return written;
  }
  const std::vector<app::RoleChoice> clips{{app::Role::walk, "clip_1"}, {app::Role::cheer, app::no_clip_name}};
  const anim::Skeleton skeleton = anim::synthetic_model(5, 1).skeleton;
  const app::RoleFile roles(folder / "roles" / "model");
  if (auto written = roles.write(clips); !written) return written.error();
  const std::vector<app::RigChoice> rig{{anim::BodyRole::hips, skeleton.bones[0].name}};
  if (auto written = roles.write_rig(rig); !written) return written.error();
  const auto order = app::BoneLodFile(folder / "bone_order" / "model").write(skeleton);
  return order ? Status(Done{}) : order.error();
}

/// Writes a crowd file with one of everything, and one of the built-in character alone.
Status write_crowd_files(const std::filesystem::path& folder) {
  const anim::Skeleton skeleton = anim::synthetic_model(5, 3).skeleton;
  app::ChosenCharacter plain;
  plain.file = (folder / "horse.glb").string();
  const app::ChosenCharacter person{
      .file = (folder / "models" / "person.glb#tall").string(),
      .share = 3,
      .clip_files = {(folder / "walk.glb").string()},
      .placement = {.scale = 0.01, .up = anim::UpAxis::z, .ground = anim::GroundRule::feet},
      .clips = {{app::Role::walk, "clip_1"}, {app::Role::cheer, app::no_clip_name}},
      .bones = app::bone_keys(skeleton),
      .level_counts = {5, 2},
      .rig = {{anim::BodyRole::hips, skeleton.bones[0].name}}};
  app::CrowdSetup setup{.characters = {person, plain, person}, .preset = {.tuning = {}, .camera = app::CameraPose{}}};
  setup.preset.tuning.agents = 30;
  setup.trajectories = {.file = (folder / "walk.csv").string(), .start = 2.5};
  setup.trajectories.reading = {.fps = 25.0, .walls = (folder / "hall.wkt").string(), .lenient = true};
  setup.trajectories.part.emplace(1.0, 40.0);
  setup.camera_name = "follow:17";
  setup.camera_path = "orbit";
  app::Tuning other;
  other.error_px = 4;
  setup.pair.take_other(other, "loose");
  setup.pair.change_places(setup.preset.tuning);
  setup.pair.names.front() = "baseline";
  setup.bookmarks.front() = app::CameraPose{.x = 1, .y = 2, .z = 3};
  setup.bookmarks.back() = app::CameraPose{.pitch = -20};
  if (Status written = app::write_crowd_file(folder / "everything.throng", setup); !written) return written;
  return app::write_crowd_file(folder / "built-in.throng", {.characters = {{}}, .preset = {}});
}

/// Writes texts that are nested deeper than anything is read, for each target that reads such a text.
Status write_nested(const std::filesystem::path& folder) {
  const auto repeated = [](std::string_view text) {
    constexpr std::size_t most_bytes = 60'000;
    std::string nested;
    while (nested.size() < most_bytes) nested += text;
    return nested;
  };
  for (const char* const target : {"import", "machine", "preset", "crowd_file", "roles", "rules", "bone_order",
                                   "tracks", "ground_plan", "check_cases"}) {
    const std::filesystem::path place = folder / target;
    std::filesystem::create_directories(place);
    if (Status written = write_whole_file(place / "nested-arrays.json", repeated("[")); !written) return written;
    Status written = write_whole_file(place / "nested-objects.json", repeated("{\"a\":"));
    if (!written) return written;
  }
  const Status written = write_whole_file(folder / "tracks" / "nested.xml", "<fcd-export>" + repeated("<a>"));
  return written ? write_whole_file(folder / "ground_plan" / "nested.wkt", repeated("GEOMETRYCOLLECTION(")) : written;
}

Status write_all(const std::filesystem::path& folder) {
  for (const char* const target : {"pack", "recording", "preset", "roles", "bone_order", "crowd_file"}) {
    std::filesystem::create_directories(folder / target);
  }
  if (Status written = write_pack_of(folder / "pack" / "small.pack", 3, 1); !written) return written;
  if (Status written = write_pack_of(folder / "pack" / "two-clips.pack", 7, 2); !written) return written;
  if (Status written = write_recording(folder / "recording" / "everything.rec"); !written) return written;
  if (Status written = write_crowd_files(folder / "crowd_file"); !written) return written;
  if (Status written = write_kept(folder); !written) return written;
  return write_nested(folder);
}

}  // namespace
}  // namespace throng::fuzz

int main(int count, char** arguments) {
  const throng::Status written = throng::fuzz::write_all(count == 2 ? arguments[1] : ".");
  if (!written) std::cerr << written.error().message << '\n';
  return written ? EXIT_SUCCESS : EXIT_FAILURE;
}
