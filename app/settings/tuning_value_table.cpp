#include "app/settings/tuning_value_table.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/settings/agent_colors.h"
#include "app/settings/choices.h"
#include "app/settings/tuning_value_kinds.h"

namespace throng::app {
namespace {

using anim::CostModel;
using anim::SystemOptions;

constexpr double farthest = 10'000, most_nanoseconds = 1e9, most_limit = 1e6;

Choices<int> mesh_choices() {
  Choices<int> choices = {{"on", -1}, {"off", 0}};
  for (int lod = 0; lod < mesh_lod_steps; ++lod) choices.emplace_back(std::to_string(lod), lod);
  return choices;
}

TuningValue level_distance(std::string_view key, const char* label, std::size_t level, std::string_view help) {
  return number(
      {.key = key,
       .label = label,
       .help = help,
       .most = farthest,
       .track = {.most = 150, .decimals = 1, .suffix = " m"}},
      [level](auto& tuning) -> auto& { return tuning.lod.level_distances[level - 1]; });
}

TuningValue local_store(TuningValue value) {
  const int most = static_cast<int>(value.most);
  value.read = [most](Tuning& tuning, const std::string& text) {
    int kib = 0;
    Complaint complaint = read_number(text, 0, most, kib);
    if (!complaint) set_local_store_kib(tuning, kib);
    return complaint;
  };
  value.read_option = [most](Tuning& tuning, const std::string& text) -> Complaint {
    int kib = 0;
    if (text != "auto" && read_number(text, 1, most, kib)) {
      return "must be auto or " + range_text<int>(1, most) + " KiB";
    }
    set_local_store_kib(tuning, kib);
    return {};
  };
  value.text = [](const Tuning& tuning) { return std::to_string(local_store_kib(tuning)); };
  return value;
}

TuningValue cost(std::string_view key, double CostModel::*member, std::string_view help) {
  return number({.key = key, .help = help, .most = most_nanoseconds},
                at(&Tuning::system, &SystemOptions::cost, member));
}

// Presets have their values in the order of these functions.
std::vector<TuningValue> crowd_values() {
  return {
      word({.key = "scene", .label = "Scene", .option = "--scene NAME", .help = "{values} ({default})"},
           at(&Tuning::scene), scene_words),
      number({.key = "agents",
              .label = "Agents",
              .option = "--agents N",
              .help = "Agents, {values} ({default})",
              .least = 1,
              .most = 100'000,
              .device_decides = true,
              .track = {.logarithmic = true}},
             at(&Tuning::agents)),
      number({.key = "seed",
              .label = "Seed",
              .option = "--seed S",
              .help = "Another seed, another crowd, {values} ({default})",
              .most = 4'294'967'295.0,
              .track = {.most = 9999}},
             at(&Tuning::seed)),
      on_off({.key = "variety",
              .label = "Variety",
              .option = "--variety on|off",
              .help = "Agents of one character differ in size and colours ({default})"},
             at(&Tuning::variety)),
      number({.key = "tint",
              .label = "Tint",
              .option = "--tint X",
              .help = "How much agents differ in colours, also in the file's own: {values} ({default})",
              .most = 1,
              .track = {.decimals = 2}},
             at(&Tuning::tint)),
      number({.key = "size_variety",
              .label = "Size variety",
              .option = "--size-variety X",
              .help = "How much agents differ in size, as a share: {values} ({default})",
              .most = 0.3,
              .track = {.decimals = 2}},
             at(&Tuning::size_variety)),
      word({.key = "clothes",
            .label = "Clothes",
            .option = "--clothes NAME",
            .help = "Colours of clothes: {values} ({default}); pattern makes one large shape of all, seen from above"},
           at(&Tuning::clothes), clothes_words),
      on_off({.key = "wardrobe",
              .label = "Wardrobe",
              .option = "--wardrobe on|off",
              .help = "People are dressed out of the wardrobe of their character, where it has one ({default})"},
             at(&Tuning::wardrobe)),
      word({.key = "weather",
            .label = "Weather",
            .option = "--weather NAME",
            .help = "What people dress for: {values} ({default})"},
           at(&Tuning::weather), weather_words),
      on_off({.key = "scenery",
              .label = "Scenery",
              .option = "--scenery on|off",
              .help = "What stands around the crowd is drawn ({default})"},
             at(&Tuning::scenery)),
      on_off({.key = "paused", .label = "Pause", .help = "The crowd stands still ({default})"}, at(&Tuning::paused)),
      number({.key = "time_scale",
              .label = "Speed",
              .help = "Speed of the clock in a window, {values} ({default})",
              .most = most_time_scale,
              .track = {.decimals = 2, .suffix = " x"}},
             at(&Tuning::time_scale)),
      on_off(
          {.key = "placed_feet", .label = "Placed feet", .help = "Feet near by stand where they came down ({default})"},
          at(&Tuning::placed_feet)),
  };
}

std::vector<TuningValue> update_values() {
  return {
      word({.key = "lod",
            .label = "Rule",
            .option = "--lod RULE",
            .help = "{values} ({default}); off also turns off bone LOD, smoothing and mesh LOD, unless they are given"},
           at(&Tuning::lod, &LodRules::rule), lod_rule_words),
      number({.key = "full_rate_distance",
              .label = "Full rate until",
              .help = "With the rule `distance`, nearer agents are updated in each frame: metres, {values} ({default})",
              .most = farthest,
              .track = {.most = 100, .decimals = 1, .suffix = " m"}},
             at(&Tuning::lod, &LodRules::full_rate_distance)),
      number({.key = "interval_growth",
              .label = "Interval step",
              .help = "Metres a further frame of the interval, {values} ({default})",
              .least = 0.01,
              .most = farthest,
              .track = {.least = 1, .most = 60, .decimals = 1, .suffix = " m"}},
             at(&Tuning::lod, &LodRules::interval_growth)),
      number({.key = "largest_interval",
              .label = "Largest interval",
              .help = "Frames between two updates at most, {values} ({default})",
              .least = 1,
              .most = longest_interval},
             at(&Tuning::lod, &LodRules::largest_interval)),
      word({.key = "error_sample",
            .label = "Measure",
            .option = "--error-sample WHICH",
            .help = "Agents in view whose error on screen is measured: some, all, or off for none ({default})"},
           at(&Tuning::error_sample), error_sampling_words),
      limit({.key = "error_px",
             .label = "Error limit",
             .option = "--error-px X",
             .help = "Largest error on screen, in pixels, of 99% of the agents ({default} without --budget-ms)",
             .most = most_limit,
             .option_does_more = true,
             .device_decides = true,
             .track = {.most = 8, .decimals = 2, .zero_word = "none", .suffix = " px"}},
            "pixels", at(&Tuning::error_px)),
      limit({.key = "budget_ms",
             .label = "Time limit",
             .option = "--budget-ms X",
             .help = "Milliseconds that posing may take in a frame, as predicted, summed over all PUs ({default})",
             .most = most_limit,
             .zero = "no limit",
             .option_does_more = true,
             .track = {.most = 20, .decimals = 2, .zero_word = "none", .suffix = " ms"}},
            "milliseconds", at(&Tuning::budget_ms)),
  };
}

std::vector<TuningValue> detail_values() {
  return {
      number({.key = "forced_interval",
              .label = "Force interval",
              .help = "Frames between two updates in place of the rule's, {values} ({default})",
              .most = longest_interval,
              .zero = "as the rule has it",
              .track = {.zero_word = "rule"}},
             at(&Tuning::inspection, &LodInspection::forced_interval)),
      number({.key = "forced_bone_level",
              .label = "Force level",
              .help = "The bone level in place of the rule's, {values} ({default}: as the rule has it)",
              .least = -1,
              .most = max_bone_levels - 1},
             at(&Tuning::inspection, &LodInspection::forced_bone_level)),
      on_off({.key = "force_selected_only",
              .label = "Selected only",
              .help = "The forced values are for the selected agent alone ({default})"},
             at(&Tuning::inspection, &LodInspection::force_selected_only)),
      on_off({.key = "smooth",
              .label = "Smooth",
              .option = "--smooth on|off",
              .help = "Blend between skipped updates ({default})"},
             at(&Tuning::lod, &LodRules::smooth)),
      on_off({.key = "bone_lod",
              .label = "Per-bone LOD",
              .option = "--bone-lod on|off",
              .help = "Fewer bones far away ({default})"},
             at(&Tuning::lod, &LodRules::bone_lod)),
      level_distance("bone_level_distance_1", "Level 1 from", 1,
                     "Metres from which bone level 1 is shown, {values} ({default})"),
      level_distance("bone_level_distance_2", "Level 2 from", 2,
                     "Metres from which bone level 2 is shown, {values} ({default})"),
      level_distance("bone_level_distance_3", "Level 3 from", 3,
                     "Metres from which bone level 3 is shown, {values} ({default})"),
      one_of<int>(
          {.key = "mesh_lod",
           .label = "Mesh LOD",
           .option = "--mesh-lod on|off|N",
           .help = "Meshes: by their error on screen (on), the finest (off), or always that one: {values} ({default})"},
          at(&Tuning::mesh_lod), mesh_choices()),
      number({.key = "mesh_error_px",
              .label = "Mesh error",
              .option = "--mesh-error-px X",
              .help = "Largest error of a coarser mesh, in pixels, {values} ({default}); half of --error-px is the "
                      "most that counts",
              .most = 64,
              .track = {.most = 4, .decimals = 2, .suffix = " px"}},
             at(&Tuning::mesh_error_px)),
      number(
          {.key = "triangle_budget",
           .label = "Triangle limit",
           .option = "--triangle-budget N",
           .help =
               "Most triangles of all characters in view, {values} ({default}): beyond it the least visible characters"
               " get coarser meshes than --mesh-error-px asks for",
           .most = 1'000'000'000,
           .zero = "no limit",
           .device_decides = true,
           .track = {.most = 1'000'000, .zero_word = "none"}},
          at(&Tuning::triangle_budget)),
  };
}

std::vector<TuningValue> scheduling_values() {
  return {
      number({.key = "pus",
              .label = "PUs",
              .option = "--pus N",
              .help = "Threads that pose the crowd (PUs), the calling one among them, {values} ({default})",
              .most = anim::max_pus,
              .zero = "all cores",
              .only_schedules = true,
              .track = {.most = 16, .zero_word = "all"}},
             at(&Tuning::system, &SystemOptions::pus)),
      local_store({.key = "local_store_kib",
                   .label = "Local store",
                   .option = "--local-store auto|KIB",
                   .help = "Size of the local store of a PU: auto is what a character needs ({default})",
                   .most = 65'536,
                   .zero = "auto",
                   .only_schedules = true,
                   .track = {.zero_word = "auto", .suffix = " KiB"}}),
      one_of<int>({.key = "tile",
                   .label = "Tile",
                   .option = "--tile N",
                   .help = "Characters that a PU poses at a time: {values} ({default})",
                   .zero = "what fits",
                   .only_schedules = true,
                   .track = {.zero_word = "auto"}},
                  at(&Tuning::system, &SystemOptions::tile),
                  {{"0", 0}, {"1", 1}, {"2", 2}, {"4", 4}, {"8", 8}, {"16", 16}}),
      word({.key = "schedule",
            .label = "Schedule",
            .option = "--schedule NAME",
            .help = "{values} ({default})",
            .only_schedules = true},
           at(&Tuning::system, &SystemOptions::schedule), schedule_words),
      word({.key = "double_buffer",
            .label = "Double buffer",
            .option = "--double-buffer MODE",
            .help = "{values} ({default})",
            .only_schedules = true},
           at(&Tuning::system, &SystemOptions::double_buffering), double_buffer_words),
      word({.key = "stream", .label = "Stream", .option = "--stream NAME", .help = "{values} ({default})"},
           at(&Tuning::system, &SystemOptions::stream), stream_words),
      word({.key = "palette",
            .label = "Palette",
            .option = "--palette FORMAT",
            .help = "float, 48 bytes a bone, or packed, 16, where a skeleton is rigid ({default})"},
           at(&Tuning::system, &SystemOptions::palettes), palette_words),
  };
}

std::vector<TuningValue> cost_values() {
  return {
      cost("cost_tile_ns", &CostModel::tile, "Nanoseconds of a strip of a tile ({default})"),
      cost("cost_tile_packet_ns", &CostModel::tile_packet, "The same for each 16 bones ({default})"),
      cost("cost_agent_ns", &CostModel::agent, "Nanoseconds of an agent ({default})"),
      cost("cost_player_packet_ns", &CostModel::player_packet, "The same for 16 bones of a player ({default})"),
      cost("cost_blender_packet_ns", &CostModel::blender_packet, "The same for 16 bones of a blender ({default})"),
      cost("cost_post_process_ns", &CostModel::post_process, "The same for work on a whole pose ({default})"),
      number({.key = "cost_least_task_ns",
              .label = "Grain",
              .option = "--grain NS",
              .help = "Least work for which another PU is woken, in nanoseconds of one PU ({default})",
              .most = most_nanoseconds,
              .only_schedules = true,
              .track = {.zero_word = "any", .suffix = " \xC2\xB5s"}},
             at(&Tuning::system, &SystemOptions::cost, &CostModel::least_task)),
  };
}

}  // namespace

std::vector<TuningValue> tuning_value_table() {
  std::vector<TuningValue> all;
  const auto add = [&all](std::string_view group, std::vector<TuningValue> values) {
    for (TuningValue& value : values) all.emplace_back(std::move(value)).group = group;
  };
  add("Crowd", crowd_values());
  add("Level of detail", update_values());
  add("Level of detail", detail_values());
  add("Scheduling", scheduling_values());
  add("Light", light_values());
  add("View", view_values());
  add("Scheduling", cost_values());
  return all;
}

}  // namespace throng::app
