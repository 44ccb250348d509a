#include "tests/soak/command_lines.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>

#include "throng/render/context.h"

#include "app/commands/command_line/options.h"
#include "app/commands/command_line/options_commands.h"
#include "app/settings/preset.h"
#include "app/show/request/crowd_file.h"
#include "engine/anim/kernel/choose_kernels.h"
#include "engine/anim/kernel/kernels.h"

namespace throng::soak {
namespace {

namespace fs = std::filesystem;

/// Gives what the value of an option is made of.
struct Maker {
  const Models& models;
  const fs::path& folder;
  Random& random;
};

/// An option, how often it is given, and what makes its value. Empty values are those of flags.
struct Option {
  const char* name;
  float chance;
  std::function<std::string(const Maker&)> value;
};

auto word_of(std::vector<std::string> words) {
  return [words = std::move(words)](const Maker& maker) { return any_of(maker.random, words); };
}

auto text(std::string text) {
  return [text = std::move(text)](const Maker&) { return text; };
}

std::string any_settings(const Maker& maker) {
  std::string all;
  for (const app::TuningValue& value : app::tuning_values()) {
    if (!value.option.empty() || !maker.random.chance(0.2F)) continue;
    all += (all.empty() ? "" : ",") + std::string(value.key) + "=" + any_text_of(value, maker.random);
  }
  return all.empty() ? "paused=off" : all;
}

std::string any_preset(const Maker& maker) {
  app::Preset preset;
  change_some_values(preset.tuning, maker.random);
  const fs::path file = maker.folder / "some.json";
  static_cast<void>(app::write_preset(file, preset));
  return file.string();
}

// Some of its models are refused, and some have another clip than it says.
std::string any_crowd_file(const Maker& maker) {
  app::CrowdSetup setup;
  for (std::uint32_t left = 1 + maker.random.below(3); left > 0; --left) {
    app::ChosenCharacter& character = setup.characters.emplace_back();
    character.file = any_model(maker.models, maker.random);
    character.share = static_cast<double>(1 + maker.random.below(9));
    if (maker.random.chance(0.2F)) character.placement.scale = any_number(maker.random, 1e-3, 100.0);
    if (maker.random.chance(0.2F)) character.clips = {{app::Role::stand, app::no_clip_name}};
  }
  change_some_values(setup.preset.tuning, maker.random);
  if (maker.random.chance(0.5F)) setup.pair.take_other(app::Tuning(), "other");
  if (maker.random.chance(0.5F)) setup.bookmarks.at(maker.random.below(app::bookmark_count)) = app::CameraPose{};
  const fs::path file = maker.folder / "some.throng";
  static_cast<void>(app::write_crowd_file(file, setup));
  return file.string();
}

// Some of its people have one row, and some stand where another one does.
std::string any_tracks(const Maker& maker) {
  std::ostringstream text;
  text << "id,frame,x,y\n";
  for (std::uint32_t person = maker.random.below(20); person < 20; ++person) {
    const double speed = any_number(maker.random, 0.01, 3.0);
    for (std::uint32_t frame = maker.random.below(50); frame < 60; ++frame) {
      text << person << ',' << frame << ',' << speed * frame / 25.0 << ',' << maker.random.below(2) + person % 9
           << '\n';
    }
  }
  const fs::path file = maker.folder / "tracks.csv";
  std::ofstream(file) << text.str();
  return maker.random.chance(0.2F) ? "-" : file.string();
}

std::string any_camera(const Maker& maker) {
  if (maker.random.chance(0.2F)) return "follow:#" + std::to_string(maker.random.below(30));
  std::ostringstream text;
  for (const double most : {60.0, 20.0, 60.0, 180.0}) {
    text << std::lround(most * (2.0 * static_cast<double>(maker.random.unit()) - 1.0)) << ',';
  }
  text << -maker.random.below(40);
  if (maker.random.chance(0.5F)) text << ',' << 10 + maker.random.below(90);
  return text.str();
}

std::string any_camera_path(const Maker& maker) {
  if (maker.random.chance(0.7F)) return any_of(maker.random, std::vector<std::string>{"none", "orbit", "pan"});
  const fs::path file = maker.folder / "path.csv";
  std::ofstream(file) << "time,x,y,z,yaw,pitch,fov\n0,0,2,20,0,-5,50\n2,9,6,15,40,-20,40\n";
  return file.string();
}

std::string any_cast(const Maker& maker) {
  if (maker.random.chance(0.2F)) return THRONG_SOURCE_DIR "/assets/cast.json";
  std::string cast;
  for (std::uint32_t left = 1 + maker.random.below(4); left > 0; --left) {
    cast += (cast.empty() ? "" : ",") + any_model(maker.models, maker.random);
    if (maker.random.chance(0.6F)) cast += "*" + std::to_string(1 + maker.random.below(9));
  }
  return cast;
}

std::string any_size(const Maker& maker) {
  return std::to_string(any_whole_number(maker.random, 1, 900)) + "x" +
         std::to_string(any_whole_number(maker.random, 1, 700));
}

std::string any_seconds(const Maker& maker) { return app::shortest_text(any_number(maker.random, 1e-6, 2.0)); }
std::string any_scale(const Maker& maker) { return app::shortest_text(any_number(maker.random, 1e-3, 100.0)); }

std::string any_frames(const Maker& maker) { return std::to_string(any_whole_number(maker.random, 1, 150)); }

/// Gives a SIMD target that poses the same bits as the best one.
std::string any_target(Random& random) {
  const anim::Kernels& best = anim::best_kernels();
  std::vector<std::string> names = anim::runnable_targets();
  std::erase_if(names, [&](const std::string& name) {
    return name != best.target && !(best.fused_multiply_add && anim::find_kernels(name)->fused_multiply_add);
  });
  return any_of(random, names);
}

/// Options of the demo beside those of the tuning. Those without a chance have rounds of their own.
const std::vector<Option>& other_options() {
  static const std::vector<Option> options = {
      {"--scale", 0.05F, any_scale},
      {"--up", 0.05F, word_of({"x", "y", "z", "-x", "-y", "-z"})},
      {"--ground", 0.1F, word_of({"file", "feet"})},
      {"--preset", 0.15F, any_preset},
      {"--set", 0.3F, any_settings},
      {"--cast", 0.2F, any_cast},
      {"--trajectories", 0.1F, any_tracks},
      {"--fps", 0.02F, word_of({"10", "25"})},
      {"--unit", 0.02F, word_of({"m", "cm", "mm", "0.02"})},
      {"--height", 0.02F, word_of({"head", "ground"})},
      {"--angle", 0.02F, word_of({"degrees", "radians", "north", "none"})},
      {"--time-unit", 0.02F, word_of({"s", "ms"})},
      {"--start", 0.02F, word_of({"0", "0.5", "9"})},
      {"--track-rate", 0.05F, word_of({"1", "-1", "0.1", "8"})},
      {"--track-part", 0.02F, word_of({"0,1", "0.2,0.2", "3,9"})},
      {"--track-repeat", 0.05F, text("")},
      {"--crowd", 0.05F, word_of({R"({"values": {"agents": 12, "scene": "parade"}})", "{"})},
      {"--lenient", 0.05F, text("")},
      {"--walls", 0.0F, text("")},
      {"--clips", 0.1F, word_of({"walk=none", "stand=none", "run=none,jog=none", "sit=none,clap=none"})},
      {"--clips-from", 0.1F, [](const Maker& maker) { return any_model(maker.models, maker.random); }},
      {"--skin", 0.1F, word_of({"all", "1"})},
      {"--strict", 0.05F, text("")},
      {"--memory-limit", 0.05F, word_of({"64MB", "500MB", "2GB", "1MB"})},
      {"--simd", 0.2F, [](const Maker& maker) { return any_target(maker.random); }},
      {"--size", 0.8F, any_size},
      {"--camera", 0.4F, any_camera},
      {"--camera-path", 0.2F, any_camera_path},
      {"--msaa", 0.2F, word_of({"0", "4"})},
      {"--sun", 0.3F, word_of({"noon", "evening", "overcast", "night", "3,200", "-90,0", "90,359"})},
      {"--focus", 0.0F, text("4")},
      {"--aperture", 0.0F, text("2")},
      {"--ui", 0.2F, word_of({"", "=fixed"})},
      {"--legend", 0.1F, text("")},
      {"--colours", 0.4F, word_of({"none", "interval", "bones", "mesh", "error", "speed", "density", "presence"})},
      {"--trails", 0.2F, word_of({"0", "5", "30"})},
      {"--ui-tab", 0.2F, word_of({"crowd", "skipping", "bones", "scheduling", "agent", "presets"})},
      {"--quality", 0.2F, word_of({"low", "medium", "high", "auto"})},
      {"--no-settings", 0.1F, text("")},
      {"--ui-scale", 0.1F, word_of({"0.5", "1", "1.5", "4"})},
      {"--select", 0.2F, word_of({"0"})},
      {"--view", 0.1F, word_of({"", "", "=walk"})},
      {"--hide-ui", 0.0F, text("")},
      {"--headless", 1.0F,
       word_of({"", "=egl", render::gl::osmesa_is_installed() ? "=osmesa" : "=egl", "=none", "=none", "=none"})},
      {"--software", 0.1F, text("")},
      {"--draw", 0.3F, word_of({"last", "all", "none"})},
      {"--frames", 1.0F, any_frames},
      {"--dt", 0.3F, any_seconds},
      {"--after", 0.1F, word_of({"0", "0.3", "1.5"})},
      {"--progress", 0.1F, text("")},
      {"--replay", 0.0F, text("run.rec")},
      {"--video", 0.0F, text("run.mp4")},
      {"--fps-out", 0.0F, text("30")},
      {"--pictures", 0.0F, text("pictures")},
      {"--labels", 0.0F, text("labels")},
      {"--seconds", 0.0F, text("0.5")},
      {"--screenshot", 0.3F, text("picture.png")},
      {"--stats", 1.0F, text("stats.json")},
      {"--events", 0.5F, text("")},
      {"--trace", 0.1F, text("trace.json")},
      {"--ui-map", 0.2F, text("ui.json")},
      {"--data", 0.05F, text(THRONG_SOURCE_DIR)},
      {"--record", 1.0F, text("run.rec")},
      {"--remove-parts", 0.1F, text("")},
  };
  return options;
}

void add(std::vector<std::string>& words, const std::string& name, const std::string& value) {
  if (value.starts_with('=')) {
    words.push_back(name + value);
  } else {
    words.push_back(name);
    if (!value.empty()) words.push_back(value);
  }
}

/// Words that may contradict each other.
std::vector<std::string> any_words(const Maker& maker) {
  std::vector<std::string> words;
  if (maker.random.chance(0.15F)) {
    words.push_back(any_crowd_file(maker));
  } else if (maker.random.chance(0.5F)) {
    for (std::uint32_t left = 1 + maker.random.below(3); left > 0; --left) {
      words.push_back(any_model(maker.models, maker.random));
    }
  }
  for (const app::TuningValue& value : app::tuning_values()) {
    const float chance = value.key == "agents" ? 1.0F : 0.2F;
    if (value.option.empty() || !maker.random.chance(chance)) continue;
    std::string drawn = any_text_of(value, maker.random);
    app::Tuning tuning;
    if (value.read_option(tuning, drawn)) continue;  // 0, for which an option has no word
    add(words, std::string(value.option_name()), drawn);
  }
  for (const Option& option : other_options()) {
    if (maker.random.chance(option.chance)) add(words, option.name, option.value(maker));
  }
  return words;
}

std::vector<std::string> files_in(const fs::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".glb" || ending == ".gltf") files.push_back(entry.path().string());
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

Models find_models() {
  const fs::path source = THRONG_SOURCE_DIR;
  return {.built_in = (source / "assets/mannequin.glb").string(),
          .features = files_in(source / "tests/data/features"),
          .broken = files_in(source / "tests/data/malformed")};
}

const std::string& any_model(const Models& models, Random& random) {
  if (random.chance(0.15F)) return models.built_in;
  return any_of(random, random.chance(0.03F) ? models.broken : models.features);
}

std::vector<std::string> any_demo_line(const Models& models, const fs::path& folder, Random& random) {
  while (true) {
    std::vector<std::string> words = any_words({models, folder, random});
    if (std::holds_alternative<app::DemoOptions>(app::parse_command_line(words))) return words;
  }
}

std::vector<std::string> any_scheduling(Random& random) {
  std::vector<std::string> words;
  for (const app::TuningValue& value : app::tuning_values()) {
    // Poses change where a local store of a fixed size has no room for the clips of arms.
    if (!value.only_schedules || value.key == "local_store_kib") continue;
    app::Tuning tuning;
    const std::string drawn = any_text_of(value, random);
    if (random.chance(0.6F) && !value.read_option(tuning, drawn)) add(words, std::string(value.option_name()), drawn);
  }
  if (random.chance(0.3F)) add(words, "--simd", any_target(random));
  return words;
}

std::optional<std::string> option_left_out() {
  std::istringstream table(app::demo_options_as_markdown());
  for (std::string line; std::getline(table, line);) {
    if (!line.starts_with("| `--")) continue;
    const std::string name = line.substr(3, line.find_first_of(" [`", 3) - 3);
    const bool drawn = std::ranges::any_of(other_options(), [&](const Option& each) { return each.name == name; });
    const bool tuned =
        std::ranges::any_of(app::tuning_values(), [&](const auto& value) { return value.option_name() == name; });
    if (!drawn && !tuned) return name + " has no values in tests/soak/command_lines.cpp";
  }
  return {};
}

}  // namespace throng::soak
