#include "app/settings/preset_fields.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <system_error>
#include <utility>
#include <vector>

#include "app/settings/choices.h"

namespace throng::app {
namespace {

using Form = PresetField::Form;

template <typename Number>
std::string shortest_text(Number number) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.begin(), text.end(), number).ptr;
  return {text.begin(), end};
}

template <typename Number>
ValueReader decimal_number(Number& target, Number least, Number most) {
  return [&target, least, most](const std::string& text) -> Complaint {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    const bool fits = error == std::errc{} && stop == end && number >= least && number <= most;
    if (!fits) return "must be a number, " + shortest_text(least) + " to " + shortest_text(most);
    target = number;
    return {};
  };
}

// `member` gives the value's place in a Tuning, const or not.
template <typename Member>
PresetField whole(std::string_view key, std::string_view option, Member member, int least, int most,
                  std::string_view unsaid = {}) {
  return {.key = key,
          .option = option,
          .unsaid = unsaid,
          .form = Form::number,
          .reader = [=](Tuning& tuning) { return whole_number(member(tuning), least, most); },
          .text = [=](const Tuning& tuning) { return std::to_string(member(tuning)); }};
}

template <typename Number, typename Member>
PresetField decimal(std::string_view key, Member member, Number least, Number most, std::string_view option = {}) {
  return {.key = key,
          .option = option,
          .unsaid = {},
          .form = Form::number,
          .reader = [=](Tuning& tuning) { return decimal_number<Number>(member(tuning), least, most); },
          .text = [=](const Tuning& tuning) { return shortest_text(member(tuning)); }};
}

template <typename Member>
PresetField cost(std::string_view key, Member member, std::string_view option = {}) {
  constexpr double most = 1e9;  // nanoseconds
  return decimal<double>(
      key, [=](auto& tuning) -> auto& { return member(tuning.cost); }, 0.0, most, option);
}

template <typename Member>
PresetField on_off(std::string_view key, std::string_view option, Member member) {
  return {.key = key,
          .option = option,
          .unsaid = {},
          .form = Form::on_off,
          .reader = [=](Tuning& tuning) { return on_or_off(member(tuning)); },
          .text = [=](const Tuning& tuning) { return std::string(member(tuning) ? "on" : "off"); }};
}

template <typename Value, std::size_t count, typename Member>
PresetField word(std::string_view key, std::string_view option, Member member,
                 const std::array<const char*, count>& words) {
  std::vector<std::pair<std::string, Value>> choices;
  for (std::size_t i = 0; i < count; ++i) choices.emplace_back(words[i], static_cast<Value>(i));
  return {.key = key,
          .option = option,
          .unsaid = {},
          .form = Form::word,
          .reader = [=](Tuning& tuning) { return choice<Value>(member(tuning), choices); },
          .text = [=](const Tuning& tuning) { return choices[static_cast<std::size_t>(member(tuning))].first; }};
}

PresetField seed() {
  return {.key = "seed",
          .option = "--seed",
          .unsaid = {},
          .form = Form::number,
          .reader = [](Tuning& tuning) { return seed_number(tuning.seed); },
          .text = [](const Tuning& tuning) { return std::to_string(tuning.seed); }};
}

PresetField tile() {
  const std::vector<std::pair<std::string, int>> widths{{"0", 0}, {"1", 1}, {"2", 2}, {"4", 4}, {"8", 8}, {"16", 16}};
  return {.key = "tile",
          .option = "--tile",
          .unsaid = "0",
          .form = Form::number,
          .reader = [=](Tuning& tuning) { return choice<int>(tuning.tile, widths); },
          .text = [](const Tuning& tuning) { return std::to_string(tuning.tile); }};
}

PresetField mesh_detail() {
  return {.key = "mesh_lod",
          .option = "--mesh-lod",
          .unsaid = {},
          .form = Form::word,
          .reader = [](Tuning& tuning) { return mesh_lod(tuning.mesh_lod); },
          .text = [](const Tuning& tuning) -> std::string {
            if (tuning.mesh_lod < 0) return "on";
            return tuning.mesh_lod == 0 ? "off" : std::to_string(tuning.mesh_lod);
          }};
}

PresetField bone_level_distance(std::string_view key, std::size_t level) {
  return decimal<float>(
      key, [=](auto& tuning) -> auto& { return tuning.bone_level_distance[level - 1]; }, 0.0F, 10000.0F);
}

void add_crowd(std::vector<PresetField>& fields) {
  fields.push_back(word<Scene>(
      "scene", "--scene", [](auto& t) -> auto& { return t.scene; }, scene_words));
  fields.push_back(whole(
      "agents", "--agents", [](auto& t) -> auto& { return t.agents; }, 1, 100'000));
  fields.push_back(seed());
  fields.push_back(on_off(
      "paused", "", [](auto& t) -> auto& { return t.paused; }));
  fields.push_back(decimal<float>(
      "time_scale", [](auto& t) -> auto& { return t.time_scale; }, 0.0F, 4.0F));
  fields.push_back(on_off(
      "placed_feet", "", [](auto& t) -> auto& { return t.placed_feet; }));
}

void add_level_of_detail(std::vector<PresetField>& fields) {
  constexpr float farthest = 10000.0F;                          // metres
  constexpr float most_error_px = 1e6F, most_budget_ms = 1e6F;  // as the command line takes them
  fields.push_back(word<LodRule>(
      "lod", "--lod", [](auto& t) -> auto& { return t.lod; }, lod_rule_words));
  fields.push_back(decimal<float>(
      "full_rate_distance", [](auto& t) -> auto& { return t.full_rate_distance; }, 0.0F, farthest));
  fields.push_back(decimal<float>(
      "interval_growth", [](auto& t) -> auto& { return t.interval_growth; }, 0.01F, farthest));
  fields.push_back(whole(
      "largest_interval", "", [](auto& t) -> auto& { return t.largest_interval; }, 1, 16));
  fields.push_back(word<ErrorSampling>(
      "error_sample", "--error-sample", [](auto& t) -> auto& { return t.error_sample; }, error_sampling_words));
  fields.push_back(decimal<float>(
      "error_px", [](auto& t) -> auto& { return t.error_px; }, 0.0F, most_error_px));
  fields.push_back(decimal<float>(
      "budget_ms", [](auto& t) -> auto& { return t.budget_ms; }, 0.0F, most_budget_ms));
  fields.push_back(whole(
      "forced_interval", "", [](auto& t) -> auto& { return t.inspection.forced_interval; }, 0, 16));
  fields.push_back(whole(
      "forced_bone_level", "", [](auto& t) -> auto& { return t.inspection.forced_bone_level; }, -1, 3));
  fields.push_back(on_off(
      "force_selected_only", "", [](auto& t) -> auto& { return t.inspection.force_selected_only; }));
  fields.push_back(on_off(
      "smooth", "--smooth", [](auto& t) -> auto& { return t.smooth; }));
  fields.push_back(on_off(
      "bone_lod", "--bone-lod", [](auto& t) -> auto& { return t.bone_lod; }));
  fields.push_back(bone_level_distance("bone_level_distance_1", 1));
  fields.push_back(bone_level_distance("bone_level_distance_2", 2));
  fields.push_back(bone_level_distance("bone_level_distance_3", 3));
  fields.push_back(mesh_detail());
}

void add_scheduling(std::vector<PresetField>& fields) {
  fields.push_back(whole(
      "pus", "--pus", [](auto& t) -> auto& { return t.pus; }, 0, 256, "0"));
  fields.push_back(whole(
      "local_store_kib", "--local-store", [](auto& t) -> auto& { return t.local_store_kib; }, 0, 65536, "0"));
  fields.push_back(tile());
  fields.push_back(word<Schedule>(
      "schedule", "--schedule", [](auto& t) -> auto& { return t.schedule; }, schedule_words));
  fields.push_back(word<DoubleBuffer>(
      "double_buffer", "--double-buffer", [](auto& t) -> auto& { return t.double_buffer; }, double_buffer_words));
  fields.push_back(word<Stream>(
      "stream", "--stream", [](auto& t) -> auto& { return t.stream; }, stream_words));
  fields.push_back(word<Palette>(
      "palette", "--palette", [](auto& t) -> auto& { return t.palette; }, palette_words));
}

void add_view(std::vector<PresetField>& fields) {
  fields.push_back(word<DebugView>(
      "debug_view", "", [](auto& t) -> auto& { return t.debug_view; }, debug_view_words));
  fields.push_back(on_off(
      "bones_as_lines", "", [](auto& t) -> auto& { return t.bones_as_lines; }));
}

void add_cost(std::vector<PresetField>& fields) {
  fields.push_back(cost(
      "cost_tile_ns", [](auto& c) -> auto& { return c.tile; }));
  fields.push_back(cost(
      "cost_tile_packet_ns", [](auto& c) -> auto& { return c.tile_packet; }));
  fields.push_back(cost(
      "cost_agent_ns", [](auto& c) -> auto& { return c.agent; }));
  fields.push_back(cost(
      "cost_player_packet_ns", [](auto& c) -> auto& { return c.player_packet; }));
  fields.push_back(cost(
      "cost_blender_packet_ns", [](auto& c) -> auto& { return c.blender_packet; }));
  fields.push_back(cost(
      "cost_post_process_ns", [](auto& c) -> auto& { return c.post_process; }));
  fields.push_back(cost(
      "cost_least_task_ns", [](auto& c) -> auto& { return c.least_task; }, "--grain"));
}

std::vector<PresetField> all_fields() {
  std::vector<PresetField> fields;
  add_crowd(fields);
  add_level_of_detail(fields);
  add_scheduling(fields);
  add_view(fields);
  add_cost(fields);
  return fields;
}

}  // namespace

std::span<const PresetField> preset_fields() {
  static const std::vector<PresetField> fields = all_fields();
  return fields;
}

const PresetField* find_preset_field(std::string_view key_or_option) {
  const auto found = std::ranges::find_if(preset_fields(), [&](const PresetField& field) {
    return field.key == key_or_option || (!field.option.empty() && field.option == key_or_option);
  });
  return found == preset_fields().end() ? nullptr : &*found;
}

void copy_field(const PresetField& field, const Tuning& from, Tuning& to) { field.reader(to)(field.text(from)); }

std::string known_preset_keys() {
  std::string keys;
  for (const PresetField& field : preset_fields()) keys += (keys.empty() ? "" : ", ") + std::string(field.key);
  return keys;
}

}  // namespace throng::app
