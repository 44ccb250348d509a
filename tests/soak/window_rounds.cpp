#include "tests/soak/window_rounds.h"

#include <algorithm>
#include <system_error>

#include "app/settings/preset.h"
#include "tests/sanitized.h"
#include "tests/soak/process_figures.h"
#include "tests/soak/program.h"

namespace throng::soak {
namespace {

namespace fs = std::filesystem;

constexpr int rest_agents = 40;

app::Preset rest_preset() {
  app::Preset preset;
  preset.tuning.agents = rest_agents;
  preset.tuning.system.pus = 2;
  preset.camera = app::CameraPose{.x = 0, .y = 3, .z = 12, .yaw = 0, .pitch = -10};
  return preset;
}

std::string copied(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  fs::copy_file(file, folder / file.filename(), error);
  return (folder / file.filename()).string();
}

fs::path file_that_ends_in(const fs::path& folder, const std::string& ending) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().string().ends_with(ending)) return entry.path();
  }
  return {};
}

/// Widgets that would make the round long, or the rest preset another one, or end the recording of the round.
bool is_left_alone(const std::string& widget) {
  return widget.starts_with("Agents") || widget.starts_with("Delete") || widget.find("preset") != std::string::npos ||
         widget == "Name" || widget == "Sweep" || widget == "badge:recording";
}

}  // namespace

WindowRounds::WindowRounds(const Models& models, const fs::path& folder) : folder_(folder) {
  fs::create_directories(folder_ / "models");
  models_.built_in = copied(models.built_in, folder_ / "models");
  for (const std::string& file : models.features) models_.features.push_back(copied(file, folder_ / "models"));
  for (const std::string& file : models.broken) models_.broken.push_back(copied(file, folder_ / "models"));
}

Fault WindowRounds::gone(const std::string& when) {
  window_.reset();
  return "the window ended, or drew no more frames, " + when;
}

Fault WindowRounds::open() {
  if (window_ != nullptr) return {};
  const fs::path preset = folder_ / "config/throng/presets/rest.json";
  if (const Status written = app::write_preset(preset, rest_preset()); !written) return written.error().message;
  const std::vector<std::string> words = {"--agents", std::to_string(rest_agents), "--size", "1000x700"};
  window_ = std::make_unique<DrivenWindow>(words, folder_);
  if (!window_->is_there()) return gone("at its start: are xvfb and xdotool installed?");
  return rest();
}

Fault WindowRounds::run(const RoundPlace& place) {
  Random random(place.seed, 3);
  if (Fault fault = open()) return fault;
  if (Fault fault = begin_recording()) return fault;
  for (std::uint32_t acts = 10 + random.below(20); acts > 0; --acts) {
    if (Fault fault = act(random)) return fault;
  }
  if (Fault fault = end_recording(place)) return fault;
  return rest();
}

Fault WindowRounds::act(Random& random) {
  const auto map = window_->next_map(1);
  if (!map) return gone("between two acts");
  const std::uint32_t which = random.below(20);
  const bool done = which < 9    ? use_a_widget(random, *map)
                    : which < 14 ? press_a_key(random)
                    : which < 16 ? resize(random)
                    : which < 18 ? look_around(random)
                                 : drop(random);
  return done ? Fault{} : gone("after the act before");
}

bool WindowRounds::use_a_widget(Random& random, const Json& map) {
  std::vector<std::string> names;
  for (const auto& [name, unused] : map["widgets"].items()) {
    if (!is_left_alone(name)) names.push_back(name);
  }
  if (names.empty()) return true;
  const std::string& name = any_of(random, names);
  const Json place = map["widgets"][name];
  tell("uses " + name);
  ++counts_["widgets"];
  if (!name.ends_with(".field"))
    return window_->drag(place, random.chance(0.5F) ? 0.5 : static_cast<double>(random.unit()));
  const std::string number = std::to_string(any_whole_number(random, 0, 300));
  return window_->drag(place, 0.5) && window_->xdotool({"type", number}) && window_->xdotool({"key", "Return"});
}

bool WindowRounds::press_a_key(Random& random) {
  static const std::vector<std::string> keys = {"space", "Tab", "F1", "f", "c", "F5", "F12",  "p", "x", "b",
                                                "w",     "a",   "s",  "d", "q", "e",  "Home", "g", "1", "2"};
  const std::string& key = any_of(random, keys);
  tell("presses " + key);
  ++counts_["keys"];
  return window_->xdotool({"keydown", key}) && window_->next_map() && window_->xdotool({"keyup", key});
}

bool WindowRounds::resize(Random& random) {
  const std::string width = std::to_string(any_whole_number(random, 60, 1300));
  const std::string height = std::to_string(any_whole_number(random, 60, 850));
  tell("makes it " + width + "x" + height);
  ++counts_["sizes"];
  return window_->xdotool({"search", "--name", "Throng", "windowsize", width, height}) && window_->next_map();
}

bool WindowRounds::look_around(Random& random) {
  const auto place = [&](std::uint32_t most) { return std::to_string(20 + random.below(most)); };
  const std::string button = random.chance(0.5F) ? "1" : "3";
  tell("drags and clicks in the picture");
  ++counts_["drags in the picture"];
  return window_->xdotool({"mousemove", place(500), place(500), "mousedown", button}) && window_->next_map() &&
         window_->xdotool({"mousemove", place(500), place(500), "mouseup", button}) && window_->next_map() &&
         window_->xdotool({"mousemove", place(500), place(500), "click", "1", "click", "5"});
}

bool WindowRounds::drop(Random& random) {
  const std::string& file = any_model(models_, random);
  tell("drops " + file);
  ++counts_["dropped models"];
  return window_->drop(file) && window_->next_map();
}

bool WindowRounds::press_when_not_typing(const std::string& key) {
  const auto map = window_->next_map();
  if (!map) return false;
  if ((*map)["typing"].get<bool>() && !window_->xdotool({"key", "Return"})) return false;
  return window_->wait_for([](const Json& now) { return !now["typing"].get<bool>(); }) &&
         window_->xdotool({"keydown", key}) && window_->next_map() && window_->xdotool({"keyup", key}) &&
         window_->next_map();
}

Fault WindowRounds::begin_recording() {
  if (!press_when_not_typing("r")) return gone("as a recording began");
  return {};
}

Fault WindowRounds::end_recording(const RoundPlace& place) {
  if (!press_when_not_typing("r")) return gone("as a recording ended");
  // The window numbers its files through.
  const auto recorded = [&] { return file_that_ends_in(folder_, ".rec"); };
  if (!window_->wait_for([&](const Json&) { return !recorded().empty(); })) return "the window wrote no recording";
  fs::rename(recorded(), place.folder / "run.rec");
  const std::vector<std::string> words = {"--headless=none", "--replay", "run.rec"};
  const ProgramRun run = run_program(words, place.folder);
  ++counts_["replays"];
  return run.status == 0 ? Fault{} : "the recording of the window is not repeated: " + run.output + run.errors;
}

Fault WindowRounds::rest() {
  // The next round must not find the choices and pictures that this one kept.
  std::error_code ignored;
  for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
    const std::string name = entry.path().filename().string();
    const bool kept = name.ends_with(".throng.json") || name.ends_with(".lod.json") || name.starts_with("throng-");
    if (kept) fs::remove(entry.path(), ignored);
  }
  if (!window_->xdotool({"search", "--name", "Throng", "windowsize", "1000", "700"})) return gone("as it came to rest");
  const auto map = window_->next_map(3);
  if (!map) return gone("as it came to rest");
  if ((*map)["hidden"].get<bool>() && !press_when_not_typing("Tab")) return gone("as it came to rest");
  if ((*map)["help"].get<bool>() && !press_when_not_typing("F1")) return gone("as it came to rest");
  const auto widget = [&](const std::string& name) {
    const auto has = [&](const Json& now) { return now["widgets"].contains(name); };
    const auto found = window_->wait_for(has);
    return found && window_->drag((*found)["widgets"][name], 0.5);
  };
  if (!widget("tab:Presets") || !widget("Load rest") || !window_->drop(models_.built_in))
    return gone("as it came to rest");
  const auto rests = window_->wait_for([&](const Json& now) {
    return now["report"]["agents"] == rest_agents && now["report"]["characters"] == Json::array({models_.built_in});
  });
  if (!rests || !window_->next_map(30)) return gone("as it came to rest");
  return {};
}

void WindowRounds::measure(Growth& growth) const {
  const ProcessFigures figures = figures_of(window_->process());
  if (!test::sanitized) growth.add("window, bytes resident", figures.resident, 96 * mebibyte);
  growth.add("window, open files", static_cast<std::uint64_t>(figures.descriptors), 0);
  growth.add("window, threads", static_cast<std::uint64_t>(figures.threads), 0);
}

Fault WindowRounds::close() {
  if (window_ == nullptr) return {};
  const std::optional<int> status = window_->end();
  window_.reset();
  return status == 0 ? Fault{} : "the window did not end with status 0";
}

}  // namespace throng::soak
