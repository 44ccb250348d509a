#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/bench/drawing.h"
#include "app/commands/command_line/option_reader.h"
#include "app/commands/command_line/options_commands.h"
#include "app/settings/tuning_values.h"

namespace throng::app {
namespace {

/// A reader of several texts with commas between them; `read_one` takes each.
template <typename Value, typename ReadOne>
ValueReader list_of(std::vector<Value>& target, ReadOne read_one) {
  return [&target, read_one](const std::string& text) -> Complaint {
    std::vector<Value> values;
    for (const std::string& part : parts_between_commas(text)) {
      if (const Complaint complaint = read_one(part, values.emplace_back())) {
        return *complaint + ", or several with commas between them";
      }
    }
    target = std::move(values);
    return {};
  };
}

ValueReader number_list(std::vector<int>& target, int least, int most) {
  return list_of(target, [=](const std::string& text, int& number) { return read_number(text, least, most, number); });
}

/// A list of values for the option of one value of the tuning; `get` takes each out of its tuning.
template <typename Value, typename Get>
void list(OptionReader& reader, const char* option, std::vector<Value>& target, Get get, const char* more = "") {
  const TuningValue& row = tuning_value(option);
  const std::string hint(row.hint());
  const auto read_one = [&row, get](const std::string& text, Value& value) {
    Tuning tuning;
    Complaint complaint = row.read_option(tuning, text);
    if (!complaint) value = get(tuning);
    return complaint;
  };
  reader.value(option, hint + "[," + hint + "...]", description(row) + more, list_of(target, read_one));
}

void declare_measured(OptionReader& reader, BenchOptions& options) {
  reader.option_defaults()->group("What is measured");
  reader.model(options.model, "A glTF file or a pack; without it, a branching skeleton is built");
  declare_memory_limit(reader, options.reading);
  list(
      reader, "--agents", options.agents, [](const Tuning& tuning) { return tuning.agents; },
      "; of every list each, in every combination");
  reader
      .value("--bones", "N[,N...]", "Bones of the built skeleton, 1 to 1024 (62)", number_list(options.bones, 1, 1024))
      ->excludes("MODEL");
  reader.value("--clips", "K[,K...]", "Different clips for it, 1 to 256 (2)", number_list(options.clips, 1, 256))
      ->excludes("MODEL");
  reader.value("--frames", "N", "Rounds in which all that is compared takes turns (60)",
               whole_number(options.frames, 1, std::numeric_limits<int>::max()));
  reader.value("--seconds", "S", "With --draw: what each number of agents may take at most (20)",
               number_between(options.seconds, 1, 86400));
}

void declare_drawing(OptionReader& reader, BenchOptions& options) {
  reader.option_defaults()->group("Whole frames");
  DemoOptions& shown = options.shown;
  reader
      .flag("--draw", options.draws,
            "Instead: what the parts of a frame take, crowd logic, level of detail and drawing included")
      ->excludes("--bones", "--clips");
  for (const char* const value : {"--scene", "--error-px", "--scenery", "--shadows", "--crowd-shade"}) {
    reader.tuning_value(app::tuning_value(value), shown.tuning);
  }
  reader.value("--size", "WxH", "Pixels (1280x720)", image_size(shown.width, shown.height));
  reader.value("--camera", "PLACE", "A camera of the scene, or x,y,z,yaw,pitch[,fov] in metres and degrees",
               camera(shown));
  reader.value("--msaa", "0|4", "Samples a pixel (what the device affords)",
               choice<int>(shown.msaa, {{"0", 0}, {"4", 4}}));
  reader.value("--context", "egl|osmesa", "What the device is opened with (EGL, else OSMesa)",
               choice<ContextKind>(shown.context, {{"egl", ContextKind::egl}, {"osmesa", ContextKind::osmesa}}));
}

void declare_scheduling(OptionReader& reader, BenchOptions& options) {
  reader.option_defaults()->group("Scheduling");
  list(reader, "--pus", options.pus, [](const Tuning& tuning) { return tuning.system.pus; });
  list(reader, "--schedule", options.schedules, [](const Tuning& tuning) { return tuning.system.schedule; });
  list(reader, "--stream", options.streams, [](const Tuning& tuning) { return tuning.system.stream; });
  for (const char* const shared : {"--local-store", "--tile", "--double-buffer", "--palette"}) {
    reader.tuning_value(app::tuning_value(shared), options.tuning);
  }
  declare_simd(reader, options.kernels);
}

void declare_files(OptionReader& reader, BenchOptions& options) {
  reader.option_defaults()->group("Files");
  reader.value("--json", "FILE|-", "Write the figures as one JSON object", any_text(options.json));
  reader.value("--plot", "FILE.svg", "Draw them", file_that_ends_in(".svg", options.plot));
  reader.value("--trace", "FILE", "Write the work of each PU over time, for ui.perfetto.dev", file_name(options.trace))
      ->excludes("--draw");
  reader.value("--data", "DIR", "Folder of shaders and assets", existing_folder(options.data));
  reader.parts_remover(options.remove_parts);
}

/// Options that are right alone and wrong together.
std::optional<std::string> contradiction_in_bench(const OptionReader& reader, const BenchOptions& options) {
  constexpr std::array whole_frames = {"--seconds", "--scene",   "--error-px",    "--size",    "--camera",
                                       "--msaa",    "--shadows", "--crowd-shade", "--scenery", "--context"};
  for (const char* const name : whole_frames) {
    if (!options.draws && reader.given(name)) return std::string(name) + ": goes with --draw";
  }
  if (!options.draws) return {};
  for (const char* const name : {"--schedule", "--stream", "--local-store", "--tile", "--double-buffer", "--palette"}) {
    if (reader.given(name)) return std::string(name) + ": --draw measures what a run does by itself; leave it out";
  }
  return options.pus.size() > 1 ? std::optional<std::string>("--pus: one number goes with --draw") : std::nullopt;
}

}  // namespace

ParsedCommand parse_bench(const std::vector<std::string>& arguments) {
  BenchOptions options;
  OptionReader reader("throng bench",
                      "Measures what an update of many agents costs, with LOD and crowd logic off, or whole frames.");
  declare_measured(reader, options);
  declare_drawing(reader, options);
  declare_scheduling(reader, options);
  declare_files(reader, options);
  reader.footer("Example:\n  throng bench --agents 1000,10000 --pus 1,2,4 --json -");
  if (auto stop = reader.read(arguments)) return *stop;
  if (auto contradiction = contradiction_in_bench(reader, options)) return UsageError{*contradiction};
  if (options.draws && !reader.given("--agents")) options.agents = usual_drawn_agents();
  for (const char* const value : {"shadows", "crowd_shade", "error_px"}) {
    if (reader.given(std::string(find_tuning_value(value)->option_name())))
      options.shown.values_given.keys.emplace_back(value);
  }
  return options;
}

}  // namespace throng::app
