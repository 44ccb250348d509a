#include "app/show/show_requests.h"

#include <string>
#include <utility>

#include "app/character/source.h"
#include "app/people/wardrobe/cast_rules_text.h"
#include "app/settings/option_values.h"
#include "app/show/load_plan.h"
#include "app/show/stage/memory_needs.h"
#include "app/show/stage/stage.h"
#include "engine/base/text/plain_text.h"

namespace throng::app {
namespace {

/// Returns whether a stage has a character, or an agent. The error says which there are.
Status has_character(const Stage& stage, CharacterNumber character) {
  const std::size_t count = stage.people().size();
  if (character < count) return Done{};
  return Error{"there is no character " + std::to_string(character) + ", only 0 to " + std::to_string(count - 1)};
}

Status has_agent(const Stage& stage, std::uint32_t agent) {
  const std::size_t count = stage.crowd().size();
  if (agent < count) return Done{};
  return Error{"there is no agent " + std::to_string(agent) + ", only 0 to " + std::to_string(count - 1)};
}

/// Makes another stage of other characters or tracks. A recorded crowd goes on at the same moment with other
/// characters.
Status exchange(std::vector<CharacterSource> characters, const Tuning& tuning,
                std::shared_ptr<const Trajectories> trajectories, ShowParts& show) {
  const Stage& before = *show.stage;
  const bool same_tracks = trajectories != nullptr && trajectories == before.trajectories();
  auto made = Stage::create(std::move(characters), tuning, show.painter->palette_pages(), before.posed().frame(),
                            std::move(trajectories));
  if (!made) return made.error();
  Stage& stage = **made;
  if (same_tracks && before.track_clock()) stage.set_track_clock(*before.track_clock());
  if (const Status loaded = show.painter->load_meshes(stage); !loaded) return loaded.error();
  if (before.animated().event_sums()) stage.animated().sum_up_events();
  show.viewer.reset();
  show.painter->reset_palette_pages();  // the new stage has asked for none yet
  show.replaced_stage = std::exchange(show.stage, std::move(*made));
  show.rewind.forget();
  return Done{};
}

/// Returns the characters that a request brings: loaded ahead, or now.
Result<LoadedCast> cast_for(const CrowdRequest& request, ShowParts& show) {
  LoadedModels& models = show.models;
  if (models.ahead.empty()) return load(*cast_to_load(request, show.stage->people()), models.options, models.data);
  LoadedCast cast = std::move(models.ahead.front());
  models.ahead.pop_front();
  return cast;
}

Status take_cast(const CrowdRequest& request, ShowParts& show) {
  auto loaded = cast_for(request, show);
  if (!loaded) return loaded.error();
  if (Status replaced = replace_characters(std::move(loaded->characters), show); !replaced) return replaced;
  show.models.left_out = std::move(loaded->left_out);
  return Done{};
}

}  // namespace

Status carry_out(const Apply& values, ShowParts& show) {
  const Tuning& tuning = values.tuning;
  if (tuning.scene == Scene::tracks && show.recorder.is_recording()) return Error{no_recording_of_tracks};
  const bool another_scene = tuning.scene != show.stage->tuning().scene;
  Status applied = show.stage->apply(tuning);
  if (applied && another_scene) applied = show.painter->load_meshes(*show.stage);
  if (applied && another_scene) show.view.begin_scene(*show.stage);
  return applied;
}

Status carry_out(const SetBody& body, ShowParts& show) {
  if (Status there = has_character(*show.stage, body.character); !there) return there;
  show.viewer.reset();
  Status set = show.stage->set_rig(body.character, body.parts);
  if (set) show.rewind.forget();
  return set;
}

Status carry_out(const SetBones& bones, ShowParts& show) {
  if (Status there = has_character(*show.stage, bones.character); !there) return there;
  show.viewer.reset();
  Status set = show.stage->set_bone_lod(bones.character, bones.choice);
  return set ? show.painter->load_meshes(*show.stage) : set;
}

Status carry_out(const SetPlacement& placement, ShowParts& show) {
  const Stage& stage = *show.stage;
  if (Status there = has_character(stage, placement.character); !there) return there;
  auto cast = cast_for(placement, show);
  if (!cast) return cast.error();
  std::vector<CharacterSource> characters(stage.people().begin(), stage.people().end());
  CharacterSource& placed = characters[placement.character];
  const CharacterSource before = std::exchange(placed, std::move(cast->characters.front()));
  placed.cast_rules = before.cast_rules;
  placed.rules_are_chosen = before.rules_are_chosen;  // another size chooses no rules
  return exchange(std::move(characters), stage.tuning(), stage.trajectories(), show);
}

Status carry_out(const LoadModels& models, ShowParts& show) { return take_cast(models, show); }
Status carry_out(const SetCast& cast, ShowParts& show) { return take_cast(cast, show); }
Status carry_out(const GoBack& back, ShowParts& show) { return show.rewind.go_back(*show.stage, back.moment); }

Status carry_out(const SetShare& share, Stage& stage) {
  if (Status there = has_character(stage, share.character); !there) return there;
  if (!is_share(share.share)) return Error{"a share must be above 0 and at most " + shortest_text(most_share)};
  stage.set_roles(share.character, stage.people()[share.character].roles.clips, share.share);
  return Done{};
}

Status carry_out(const SetRoles& roles, Stage& stage) {
  if (Status there = has_character(stage, roles.character); !there) return there;
  const CharacterSource& person = stage.people()[roles.character];
  if (!has_clips(person, roles.clips)) return Error{person.name + " has no such clip"};
  stage.set_roles(roles.character, roles.clips);
  return Done{};
}

Status carry_out(const SetRules& rules, Stage& stage) {
  if (Status there = has_character(stage, rules.character); !there) return there;
  auto read = rules_of_text(rules.rules);
  Status set = read ? stage.set_cast_rules(rules.character, std::move(*read), rules.file) : read.error();
  if (set || rules.file.empty()) return set;
  return Error{plain_text(rules.file) + ": " + set.error().message};
}

Status carry_out(const Select& select, Stage& stage) {
  if (select.agent) {
    if (Status there = has_agent(stage, *select.agent); !there) return there;
  }
  stage.select(select.agent);
  return Done{};
}

Status carry_out(const Push& push, Stage& stage) {
  if (Status there = has_agent(stage, push.agent); !there) return there;
  return stage.animated().push_over(push.agent, push.direction);
}

Status carry_out(const Hold& hold, Stage& stage) {
  if (!hold.agent) return stage.animated().let_go_of_clip(), Done{};
  if (Status there = has_agent(stage, *hold.agent); !there) return there;
  stage.animated().hold_clip(*hold.agent, hold.seconds);
  return Done{};
}

Status carry_out(const Seek& seek, Stage& stage) {
  const bool has_clock = stage.crowd().tracks() != nullptr && !stage.trajectories()->is_live;
  if (!has_clock) return Error{"the crowd follows no file, so it goes to no other time of one"};
  if (seek.clock != stage.crowd().tracks()->clock()) stage.set_track_clock(seek.clock);
  return Done{};
}

Status open_viewer(const ViewRequest& request, ShowParts& show) {
  std::vector<ViewedMesh> meshes;
  if (request.character < show.stage->people().size()) {
    for (const MeshLevel& level : show.painter->mesh_levels(request.character)) {
      meshes.push_back({static_cast<std::size_t>(level.triangles), level.error.surface});
    }
  }
  auto viewer = Viewer::create(*show.stage, request, std::move(meshes));
  if (!viewer) return viewer.error();
  show.viewer = std::move(*viewer);
  return Done{};
}

Status replace_characters(std::vector<CharacterSource> characters, ShowParts& show) {
  const bool viewed = show.viewer != nullptr;
  const Stage& stage = *show.stage;
  Status exchanged = exchange(std::move(characters), stage.tuning(), stage.trajectories(), show);
  if (!exchanged) return exchanged;
  show.models.left_out.clear();
  return viewed ? open_viewer({}, show) : exchanged;  // a person who looks at models goes on
}

Status replace_trajectories(std::shared_ptr<const Trajectories> trajectories, ShowParts& show) {
  if (trajectories == nullptr) {
    if (show.stage->tuning().scene != Scene::tracks && show.live == nullptr) show.stage->forget_trajectories();
    return Done{};
  }
  if (show.recorder.is_recording()) {
    return Error{trajectories->file +
                 ": a recording goes on, and cannot hold the crowd of a file; end it with R, then drop the file"};
  }
  Tuning tuning = show.stage->tuning();
  tuning.scene = Scene::tracks;
  tuning.agents = static_cast<int>(trajectories->persons.size());
  std::vector<CharacterSource> characters(show.stage->people().begin(), show.stage->people().end());
  if (Status fits = check_memory(tuning, characters, nullptr); !fits) return fits;
  Status exchanged = exchange(std::move(characters), tuning, std::move(trajectories), show);
  if (!exchanged) return exchanged;
  show.live.reset();
  TrackClock clock = show.stage->crowd().tracks()->clock();
  clock.repeats = true;
  show.stage->set_track_clock(clock);
  show.view.begin_scene(*show.stage);
  return Done{};
}

}  // namespace throng::app
