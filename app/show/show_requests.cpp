#include "app/show/show_requests.h"

#include <string>
#include <utility>

#include "app/character/cast_files.h"
#include "app/character/files.h"
#include "app/show/opened_crowd.h"
#include "app/show/stage/memory_needs.h"

namespace throng::app {
namespace {

/// Makes another stage of other characters or tracks. A recorded crowd goes on at the same moment with other
/// characters.
anim::Status exchange(std::vector<CharacterSource> characters, const Tuning& tuning,
                      std::shared_ptr<const Trajectories> trajectories, ShowParts& show) {
  const Stage& before = *show.stage;
  const bool same_tracks = tuning.scene == Scene::tracks && trajectories == before.trajectories();
  auto made = Stage::create(std::move(characters), tuning, show.painter->palette_pages(), before.posed().frame(),
                            std::move(trajectories));
  if (!made) return made.error();
  Stage& stage = **made;
  if (same_tracks) stage.set_track_clock(before.crowd().tracks()->clock());
  if (const anim::Status loaded = show.painter->load_meshes(stage); !loaded) return loaded.error();
  if (before.animated().event_sums()) stage.animated().sum_up_events();
  show.viewer.reset();
  show.painter->reset_palette_pages();  // the new stage has asked for none yet
  show.stage = std::move(*made);
  show.rewind.forget();
  return anim::Done{};
}

anim::Status take_cast(anim::Result<LoadedCast> loaded, ShowParts& show) {
  if (!loaded) return loaded.error();
  if (anim::Status replaced = replace_characters(std::move(loaded->characters), show); !replaced) return replaced;
  show.models.left_out = std::move(loaded->left_out);
  return anim::Done{};
}

}  // namespace

anim::Status carry_out(const Apply& values, ShowParts& show) {
  const Tuning& tuning = values.tuning;
  if (tuning.scene == Scene::tracks && show.recorder.is_recording()) return anim::Error{no_recording_of_tracks};
  const bool another_scene = tuning.scene != show.stage->tuning().scene;
  anim::Status applied = show.stage->apply(tuning);
  if (applied && another_scene) applied = show.painter->load_meshes(*show.stage);
  if (applied && another_scene) show.view.begin_scene(*show.stage);
  return applied;
}

anim::Status carry_out(const SetBody& body, ShowParts& show) {
  if (anim::Status there = has_character(*show.stage, body.character); !there) return there;
  show.viewer.reset();
  anim::Status set = show.stage->set_rig(body.character, body.parts);
  if (set) show.rewind.forget();
  return set;
}

anim::Status carry_out(const SetBones& bones, ShowParts& show) {
  if (anim::Status there = has_character(*show.stage, bones.character); !there) return there;
  show.viewer.reset();
  anim::Status set = show.stage->set_bone_lod(bones.character, bones.choice);
  return set ? show.painter->load_meshes(*show.stage) : set;
}

anim::Status carry_out(const SetPlacement& placement, ShowParts& show) {
  const Stage& stage = *show.stage;
  if (anim::Status there = has_character(stage, placement.character); !there) return there;
  auto placed =
      placed_anew(stage.people()[placement.character], placement.choice, show.models.options, show.models.data);
  if (!placed) return placed.error();
  std::vector<CharacterSource> characters(stage.people().begin(), stage.people().end());
  characters[placement.character] = std::move(*placed);
  return exchange(std::move(characters), stage.tuning(), stage.trajectories(), show);
}

anim::Status carry_out(const LoadModels& models, ShowParts& show) {
  auto loaded = load_dropped(models.files, show.models.options);
  if (!loaded) return loaded.error();
  for (CharacterSource& character : loaded->characters) {
    if (const anim::Status kept = take_kept_roles(character); !kept) return kept.error();
  }
  return take_cast(std::move(loaded), show);
}

anim::Status carry_out(const SetCast& cast, ShowParts& show) {
  const std::size_t count = cast.characters.size();
  if (count >= 1 && count <= most_models) {
    return take_cast(load_crowd(cast.characters, show.models.data, show.models.options), show);
  }
  return anim::Error{"a crowd has 1 to " + std::to_string(most_models) + " characters, not " + std::to_string(count)};
}

anim::Status carry_out(const GoBack& back, ShowParts& show) { return show.rewind.go_back(*show.stage, back.moment); }

anim::Status open_viewer(const ViewRequest& request, ShowParts& show) {
  std::vector<ViewedMesh> meshes;
  if (request.character < show.stage->people().size()) {
    for (const MeshLevel& level : show.painter->mesh_levels(request.character)) {
      meshes.push_back({static_cast<std::size_t>(level.triangles), level.error.surface});
    }
  }
  auto viewer = Viewer::create(*show.stage, request, std::move(meshes));
  if (!viewer) return viewer.error();
  show.viewer = std::move(*viewer);
  return anim::Done{};
}

anim::Status replace_characters(std::vector<CharacterSource> characters, ShowParts& show) {
  const bool viewed = show.viewer != nullptr;
  const Stage& stage = *show.stage;
  anim::Status exchanged = exchange(std::move(characters), stage.tuning(), stage.trajectories(), show);
  if (!exchanged) return exchanged;
  show.models.left_out.clear();
  return viewed ? open_viewer({}, show) : exchanged;  // a person who looks at models goes on
}

anim::Status replace_trajectories(std::shared_ptr<const Trajectories> trajectories, ShowParts& show) {
  if (show.recorder.is_recording()) {
    return anim::Error{trajectories->file +
                       ": a recording goes on, and cannot hold the crowd of a file; end it with R, then drop the file"};
  }
  Tuning tuning = show.stage->tuning();
  tuning.scene = Scene::tracks;
  tuning.agents = static_cast<int>(trajectories->persons.size());
  std::vector<CharacterSource> characters(show.stage->people().begin(), show.stage->people().end());
  if (anim::Status fits = check_memory(tuning, characters, nullptr); !fits) return fits;
  anim::Status exchanged = exchange(std::move(characters), tuning, std::move(trajectories), show);
  if (!exchanged) return exchanged;
  show.live.reset();
  TrackClock clock = show.stage->crowd().tracks()->clock();
  clock.repeats = true;
  show.stage->set_track_clock(clock);
  show.view.begin_scene(*show.stage);
  return anim::Done{};
}

}  // namespace throng::app
