#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "app/commands/command_line/option_reader.h"
#include "app/commands/command_line/options_commands.h"
#include "app/settings/times_of_day.h"
#include "app/settings/tuning_values.h"
#include "app/show/request/crowd_file.h"

namespace throng::app {
namespace {

void declare_cast(OptionReader& reader, DemoOptions& options) {
  reader.value("--cast", "MODEL*SHARE,...|RULES.json",
               "Models with their shares of the agents, in place of MODEL (even shares); or rules for clothes",
               cast_or_rules(options.cast, options.cast_rules));
}

void declare_clips(OptionReader& reader, DemoOptions& options) {
  reader.value("--clips", "ROLE=NAME,...", "Clips to play for roles, of each model that has them (guessed from names)",
               role_choices(options.clips));
  reader.value("--clips-from", "FILE,...", "Files whose clips every model plays too, retargeted where need be",
               file_names(options.clips_from));
}

void declare_reading(OptionReader& reader, DemoOptions& options) {
  reader.value("--skin", "NAME|all", "Of files with several characters: which one, or all (the largest)",
               any_text(options.skin));
  reader.flag("--strict", options.reading.strict,
              "Refuse files that would be repaired, and links out of their folders");
  declare_memory_limit(reader, options.reading);
}

void declare_light(OptionReader& reader, DemoOptions& options) {
  reader.option_defaults()->group("Light");
  reader.value("--sun", "TIME",
               names_of_times() + ", or the sun's elevation,azimuth in degrees (" + times_of_day.front().name + ")",
               sun(options.tuning.light));
  reader.tuning("Light", options.tuning);
}

void declare_picture(OptionReader& reader, DemoOptions& options) {
  reader.option_defaults()->group("Picture");
  reader.value("--size", "WxH", "Pixels (1280x720)", image_size(options.width, options.height));
  reader.value(
      "--camera", "PLACE",
      "A camera of the scene, or x,y,z,yaw,pitch[,fov] in metres and degrees, or follow:ID, behind a person of "
      "--trajectories, or behind agent N as follow:#N",
      camera(options));
  reader.value(
      "--camera-path", "NAME|FILE.csv",
      "orbit around the crowd, or pan to both sides, from where --camera stands, or along the keys of a file (none)",
      camera_path(options));
  reader.value(
      "--focus", "METRES", "Distance at which a screenshot is sharp, the rest is not (all is sharp)",
      [&options](const std::string& text) { return number_between(options.focus.emplace(), 0.1F, 10'000.0F)(text); });
  reader.value("--aperture", "F", "The f-number of its lens on film 24 mm high, 0.1 to 64 (1.4)",
               number_between(options.aperture, 0.1F, 64));
  reader.value("--quality", "NAME",
               "low, medium or high: picture size, triangle limit, shadows and crowd shade together; or auto: what the"
               " device shows at --frame-rate (auto in a window, else high)",
               quality(options));
  reader.value("--msaa", "0|4", "Samples a pixel (what the device affords)",
               choice<int>(options.msaa, {{"0", 0}, {"4", 4}}));
  const auto take_ui = [&options](const std::string& text) {
    options.ui = true;
    return choice<bool>(options.ui_fixed, {{"measured", false}, {"fixed", true}})(text);
  };
  CLI::Option* const ui = reader.optional_value("--ui", "measured", "[=fixed]",
                                                "Overlay in a headless run; fixed: with times from a report", take_ui);
  reader.value("--ui-tab", "NAME",
               "Tab that the overlay starts with: crowd, skipping, bones, scheduling, agent, presets",
               choice<std::string>(options.ui_tab, {{"crowd", "Crowd"},
                                                    {"skipping", "LOD skipping"},
                                                    {"bones", "Per-bone LOD"},
                                                    {"scheduling", "Scheduling"},
                                                    {"agent", "Agent"},
                                                    {"presets", "Presets"}}));
  reader
      .flag("--legend", options.legend,
            "What the colours mean, the time and the number of people, in pictures of a headless run")
      ->excludes(ui);
  reader.flag("--no-settings", options.no_settings,
              "A window that neither starts with the settings of the last one nor leaves its own to the next");
  reader.value("--ui-scale", "X", "Size of the overlay, 0.5 to 4 (1)", number_between(options.ui_scale, 0.5, 4));
  reader.value(
      "--select", "AGENT", "The agent that is selected at first, counted from 0",
      [&options](const std::string& text) { return whole_number(options.selected.emplace(), 0, 99'999)(text); });
  reader.optional_value("--view", "", "[=CLIP]",
                        "The first character alone on a turntable, in a clip of it; the crowd waits",
                        [&options](const std::string& text) { return options.view.emplace(text), Complaint(); });
  reader.flag("--hide-ui", options.hide_ui, "No overlay in the window")->excludes(ui);
}

void declare_run(OptionReader& reader, DemoOptions& options) {
  reader.option_defaults()->group("Run");
  reader.optional_value("--headless", "auto", "[=egl|osmesa|none]",
                        "No window: EGL, else OSMesa; none: no picture at all",
                        choice<ContextKind>(options.context, {{"auto", ContextKind::headless_default},
                                                              {"egl", ContextKind::egl},
                                                              {"osmesa", ContextKind::osmesa},
                                                              {"none", ContextKind::none}}));
  declare_software(reader, options);
  reader.value(
      "--draw", "WHICH", "Headless: last, all or none of the frames (last with --screenshot or --ui-map, else none)",
      choice<DrawWhich>(options.draw, {{"last", DrawWhich::last}, {"all", DrawWhich::all}, {"none", DrawWhich::none}}));
  reader.value("--frames", "N", "Frames (headless: 60; a window: until it is closed)",
               whole_number(options.frames, 1, std::numeric_limits<int>::max()));
  reader.value("--dt", "S", "Seconds a frame (headless: 1/60; a window: the clock)",
               real_number(options.dt, least_frame_seconds, most_frame_seconds));
  reader.value("--after", "S", "Headless: seconds that the crowd goes on, unseen, before the first frame (0)",
               real_number(options.unseen_seconds, 0.0, 1e6));
  reader.flag("--progress", options.says_progress,
              "Headless: say how far the run is on standard error, in lines for another program");
  reader.value("--replay", "FILE", "Repeat a recording, and name the first frame and agent that differ",
               file_name(options.replay));
}

void declare_files(OptionReader& reader, DemoOptions& options) {
  reader.option_defaults()->group("Files");
  reader.value("--screenshot", "FILE.png", "Write the last frame", file_that_ends_in(".png", options.screenshot));
  reader.value("--stats", "FILE|-", "Write what the run did and how long it took, as JSON", any_text(options.stats));
  reader.flag("--events", options.events, "Sum up in --stats the events and places of all agents");
  reader.value("--trace", "FILE", "Write the work of each PU over time, for ui.perfetto.dev", file_name(options.trace));
  reader.value("--ui-map", "FILE", "Write where every widget of the overlay is, as JSON", file_name(options.ui_map));
  reader.value("--data", "DIR", "Folder of shaders and assets", existing_folder(options.data));
  reader.value("--record", "FILE", "Record all requests and the poses that come of them", file_name(options.record));
  reader.parts_remover(options.remove_parts);
}

/// Without updates to skip, the parts that only save work are off too, so that each agent is shown exactly. A limit on
/// the command line asks for the rule that keeps it.
void settle_level_of_detail(const OptionReader& reader, Tuning& tuning) {
  const bool error_given = reader.given("--error-px"), budget_given = reader.given("--budget-ms");
  if (!reader.given("--lod") && (error_given || budget_given)) tuning.lod.rule = LodRule::budget;
  if (budget_given && !error_given) tuning.error_px = 0.0F;
  if (tuning.lod.rule != LodRule::off || !reader.given("--lod")) return;
  if (!reader.given("--bone-lod")) tuning.lod.bone_lod = false;
  if (!reader.given("--smooth")) tuning.lod.smooth = false;
  if (!reader.given("--mesh-lod")) tuning.mesh_lod = 0;
}

/// Complains about limits without the rule that keeps them.
std::optional<std::string> idle_limit(const OptionReader& reader, const Tuning& tuning) {
  for (const std::string limit : {"--error-px", "--budget-ms"}) {
    if (reader.given(limit) && tuning.lod.rule != LodRule::budget) return limit + ": goes with --lod budget";
  }
  return {};
}

/// A recording has its own options; the command line must not repeat them.
std::optional<std::string> contradiction_of_replay(const DemoOptions& options) {
  static const std::set<std::string> free_to_choose{
      "MODEL",          "--clips-from", "--replay",   "--simd",     "--size",   "--msaa",
      "--ui",           "--hide-ui",    "--headless", "--software", "--draw",   "--frames",
      "--screenshot",   "--stats",      "--events",   "--trace",    "--ui-map", "--data",
      "--remove-parts", "--video",      "--pictures", "--fps-out",  "--legend", "--progress"};
  for (const std::string& name : options.given) {
    const auto schedules = [&](const TuningValue& row) { return row.only_schedules && row.option_name() == name; };
    if (free_to_choose.contains(name) || std::ranges::any_of(tuning_values(), schedules)) continue;
    return name + ": the recording says it; leave it out with --replay";
  }
  return {};
}

/// Refuses an overlay or legend where a run draws no picture.
std::optional<std::string> contradiction_of_overlay(const DemoOptions& options) {
  const std::string asked = options.ui ? "--ui" : options.legend ? "--legend" : "";
  if (options.context == ContextKind::window) {
    if (options.legend) return "--legend: a window has it in its panel; add --headless";
    return {};
  }
  if (asked.empty()) return {};
  if (options.context == ContextKind::none) return asked + ": --headless=none draws nothing; use --headless";
  if (options.draw == DrawWhich::none) return asked + ": --draw none draws nothing";
  if (drawn_frames(options) == DrawWhich::none) {
    return asked + ": no frame is drawn; add --screenshot, --ui-map or --draw last";
  }
  return {};
}

/// Options that are right alone and wrong together.
std::optional<std::string> contradiction_in(const DemoOptions& options) {
  if (options.models.size() > most_models) {
    return options.models[most_models] + ": " + std::to_string(most_models) + " models are the most";
  }
  if (auto contradiction = contradiction_of_crowd(options)) return contradiction;
  if (!options.models.empty() && !options.cast.empty()) return "--cast: takes the place of MODEL; give one of them";
  if (options.models.empty() && options.cast.empty() && !options.skin.empty()) {
    return "--skin: goes with a MODEL or --cast";
  }
  if (!options.replay.empty()) {
    if (auto contradiction = contradiction_of_replay(options)) return contradiction;
  }
  const bool draws_nothing = options.context == ContextKind::none;
  const bool window = options.context == ContextKind::window;
  if (draws_nothing && !options.screenshot.empty())
    return "--screenshot: --headless=none draws nothing; use --headless";
  if (draws_nothing && options.draw && *options.draw != DrawWhich::none) {
    return "--draw: --headless=none draws nothing; use --headless";
  }
  if (auto contradiction = contradiction_of_overlay(options)) return contradiction;
  if (!window && !options.ui && !options.ui_map.empty()) return "--ui-map: no overlay is drawn; add --ui";
  const bool is_still = !window && !options.screenshot.empty() && drawn_frames(options) != DrawWhich::all;
  if (options.focus && !is_still) return "--focus: is for stills; use --headless and --screenshot";
  if (!options.focus && std::ranges::find(options.given, "--aperture") != options.given.end()) {
    return "--aperture: goes with --focus";
  }
  if (!options.screenshot.empty() && options.draw == DrawWhich::none) return "--screenshot: --draw none draws nothing";
  if (window && std::max(options.width, options.height) > most_window_pixels) {
    return "--size: a window has at most " + std::to_string(most_window_pixels) + " pixels a side; use --headless";
  }
  if (window && (options.unseen_seconds || options.says_progress)) {
    return std::string(options.says_progress ? "--progress" : "--after") + ": goes with --headless";
  }
  if (window && options.force_software) return "--software: goes with --headless";
  if (window && options.draw && *options.draw != DrawWhich::all) return "--draw: a window draws all; use --headless";
  return {};
}

void declare_placements(OptionReader& reader, DemoOptions& options) {
  reader.option_defaults()->group("Size and place of models");
  reader.value("--scale", "[NAME=]X,...", "Metres that a unit of the files, or of the file NAME, is (guessed)",
               model_scales(options.placement, options.placements));
  reader.value("--up", "[NAME=]AXIS,...", "The axis that points up there: x, y, z, -x, -y or -z (y)",
               model_up_axes(options.placement, options.placements));
  reader.value("--ground", "[NAME=]RULE,...", "What is on the ground: file, their origin, or feet (guessed)",
               model_grounds(options.placement, options.placements));
}

void declare_demo(OptionReader& reader, DemoOptions& options) {
  const auto add = [&](const std::string& text) {
    return is_crowd_file(text) ? crowd_file_name(options)(text) : any_text(options.models.emplace_back())(text);
  };
  const std::string models = "glTF files (.glb or .gltf), packs, and folders of them, up to " +
                             std::to_string(most_models) +
                             " characters; or one NAME.throng, a crowd that was saved; without any, the built-in one";
  reader.value("MODEL", "...", models, add)
      ->expected(1, CLI::detail::expected_max_vector_size)
      ->allow_extra_args()
      ->group("Model");
  declare_placements(reader, options);
  declare_starting_values(reader, options);
  declare_trajectories(reader, options);
  reader.tuning("Crowd", options.tuning);
  declare_cast(reader, options);
  declare_clips(reader, options);
  declare_reading(reader, options);
  reader.tuning("Level of detail", options.tuning);
  reader.tuning("Scheduling", options.tuning);
  declare_simd(reader, options.kernels);
  declare_light(reader, options);
  reader.tuning("View", options.tuning);
  declare_picture(reader, options);
  declare_run(reader, options);
  declare_output(reader, options);
  declare_files(reader, options);
  reader.footer(
      "Examples:\n"
      "  throng --agents 5000 --scene stadium\n"
      "  throng fox.glb --view=Run\n"
      "  throng --cast fox.glb*3,horse.glb --headless --screenshot animals.png\n"
      "  throng --trajectories walk.sqlite\n"
      "  throng mine.throng\n"
      "\n"
      "Other commands, each with a --help of its own:\n"
      "  throng pose MODEL       the joints and palettes of every skin, as JSON\n"
      "  throng inspect MODEL    what is in a file, what was repaired, what was refused\n"
      "  throng lod [MODEL]      what each bone level of a character saves and shows\n"
      "  throng bench [MODEL]    what an update of many agents costs\n"
      "  throng bake MODEL...    models made ready to play, in one file that opens at once\n"
      "  throng check CASES      pictures held against expected ones, for a model or a preset of your own\n"
      "  throng compare A B      how far two pictures are apart");
}

}  // namespace

ParsedCommand parse_demo(const std::vector<std::string>& arguments) {
  DemoOptions options;
  OptionReader reader("throng", "Throng: a crowd of skinned characters, each in a pose of its own.");
  declare_demo(reader, options);
  if (auto stop = reader.read(arguments)) return *stop;
  for (const CLI::Option* option : reader.get_options([](const auto* each) { return each->count() > 0; })) {
    options.given.push_back(option->get_name());
  }
  options.frames_given = reader.given("--frames");
  for (const TuningValue& row : tuning_values()) {
    if (!row.option.empty() && reader.given(std::string(row.option_name())))
      options.values_given.keys.emplace_back(row.key);
  }
  settle_level_of_detail(reader, options.tuning);
  if (auto contradiction = settle_trajectories(reader, options)) return UsageError{*contradiction};
  if (auto contradiction = idle_limit(reader, options.tuning)) return UsageError{*contradiction};
  if (auto contradiction = settle_output(reader, options)) return UsageError{*contradiction};
  if (auto contradiction = contradiction_in(options)) return UsageError{*contradiction};
  return options;
}

std::string demo_options_as_markdown() {
  DemoOptions options;
  OptionReader reader("throng", "");
  declare_demo(reader, options);
  return reader.markdown();
}

}  // namespace throng::app
