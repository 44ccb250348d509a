#include <limits>
#include <optional>
#include <string>

#include "app/command_line/option_reader.h"
#include "app/command_line/options_commands.h"
#include "app/settings/placement_options.h"
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

/// A list of what the option of one value of the tuning takes; `get` takes each out of its tuning.
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

void clips_from(OptionReader& reader, std::vector<std::string>& target) {
  reader.value("--clips-from", "FILE,...", "Files whose clips are added, retargeted where need be", file_names(target));
}

void reading(OptionReader& reader, import::ImportOptions& options) {
  reader.flag("--strict", options.strict, "Refuse a file that would be repaired, and links out of its folder");
  declare_memory_limit(reader, options);
}

}  // namespace

void declare_memory_limit(OptionReader& reader, import::ImportOptions& options) {
  reader.value("--memory-limit", "SIZE",
               "Memory that reading a model may take, 2GB or 500MB (64 MB and 4 times the file)",
               memory_size(options.memory_limit));
}

void declare_simd(OptionReader& reader, const anim::Kernels*& kernels) {
  reader.value("--simd", "TARGET",
               "Vector instructions: avx512, avx2, sse4, scalar, or as Highway names them (the best)",
               simd_target(kernels));
}

void declare_placement(OptionReader& reader, anim::PlacementChoice& placement) {
  reader.option_defaults()->group("Size and place of models");
  reader.value("--scale", "X", "Metres that a unit of the files is (guessed from the height)",
               scale_above_zero(placement.scale));
  reader.value("--up", "AXIS", "The axis that points up in the files: x, y, z, -x, -y or -z (y)",
               up_axis(placement.up));
  reader.value("--ground", "file|feet", "What is on the ground: the files' origin, or the feet (guessed)",
               ground_rule(placement.ground));
}

ParsedCommand parse_pose(const std::vector<std::string>& arguments) {
  PoseOptions options;
  OptionReader reader("throng pose", "Writes the joints and palettes of every skin of a file.");
  reader.option_defaults()->group("What is posed");
  reader.model(options.model, "A glTF file (.glb or .gltf), or a pack")->required();
  clips_from(reader, options.clips_from);
  reading(reader, options.reading);
  reader.value("--clip", "NAME|INDEX", "A clip of the file, or none", any_text(options.clip))->required();
  reader.value("--time", "T[,T...]", "Seconds", times_list(options.times))->required();
  Tuning tuning;
  reader.tuning_value(tuning_value("--stream"), tuning);
  declare_simd(reader, options.kernels);
  reader.value("--json", "FILE|-", "Where to write", any_text(options.json))->required();
  reader.parts_remover(options.remove_parts);
  reader.footer("Example:\n  throng pose fox.glb --clip Run --time 0,0.25 --json run.json");
  if (auto stop = reader.read(arguments)) return *stop;
  options.stream = tuning.system.stream;
  return options;
}

ParsedCommand parse_inspect(const std::vector<std::string>& arguments) {
  InspectOptions options;
  OptionReader reader("throng inspect", "Says what was found in a file, what was repaired and what was refused.");
  reader.option_defaults()->group("What is inspected");
  reader.model(options.model, "A glTF file (.glb or .gltf), or a pack")->required();
  clips_from(reader, options.clips_from);
  reading(reader, options.reading);
  reader.flag("--json", options.json, "As one JSON object");
  declare_placement(reader, options.placement);
  reader.footer("Example:\n  throng inspect fox.glb --strict");
  if (auto stop = reader.read(arguments)) return *stop;
  return options;
}

ParsedCommand parse_lod(const std::vector<std::string>& arguments) {
  LodOptions options;
  OptionReader reader("throng lod", "Measures what each bone level of a character saves, and what it shows.");
  reader.option_defaults()->group("What is measured");
  reader.model(options.model, "A glTF file (.glb or .gltf), or a pack; without it, the built-in character");
  reader.value("--pixels", "N", "Height on screen for errors in pixels, 1 to 10000 (200)",
               whole_number(options.pixels, 1, 10000));
  declare_simd(reader, options.kernels);
  declare_memory_limit(reader, options.reading);
  reader.option_defaults()->group("Files");
  reader.value("--json", "FILE|-", "Write the figures as one JSON object", any_text(options.json));
  reader.value("--plot", "FILE.svg", "Draw them", file_that_ends_in(".svg", options.plot));
  reader.value("--export", "FILE", "Write distances, intervals, bones and meshes for another engine",
               file_name(options.export_file));
  reader.value("--data", "DIR", "Folder of assets", existing_folder(options.data));
  reader.parts_remover(options.remove_parts);
  reader.footer("Example:\n  throng lod fox.glb --pixels 300 --plot fox.svg");
  if (auto stop = reader.read(arguments)) return *stop;
  return options;
}

ParsedCommand parse_bake(const std::vector<std::string>& arguments) {
  BakeOptions options;
  OptionReader reader("throng bake",
                      "Writes all that is made of models before they play into one file that opens at once.");
  reader.option_defaults()->group("What is baked");
  const auto add = [&](const std::string& text) { return any_text(options.models.emplace_back())(text); };
  reader.value("MODEL", "...", "glTF files (.glb or .gltf), or packs", add)
      ->expected(1, CLI::detail::expected_max_vector_size)
      ->allow_extra_args()
      ->required()
      ->group("Model");
  reader.value("-o", "FILE.pack", "The file to write", file_that_ends_in(".pack", options.pack))->required();
  reader.parts_remover(options.remove_parts);
  clips_from(reader, options.clips_from);
  reading(reader, options.reading);
  declare_placement(reader, options.placement);
  reader.footer("Example:\n  throng bake fox.glb horse.glb -o animals.pack");
  if (auto stop = reader.read(arguments)) return *stop;
  return options;
}

namespace {

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
  reader.value("--sweep", "NAME", "Instead: grain, below which size tasks are too small",
               choice<Sweep>(options.sweep, {{"grain", Sweep::grain}}));
  reader
      .value("--machine", "FILE", "Instead: what a machine with other local stores would do; ps2, spe or a file",
             file_name(options.machine))
      ->excludes("--sweep");
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
  reader.value("--plot", "FILE.svg", "Draw them", file_that_ends_in(".svg", options.plot))->excludes("--machine");
  reader.value("--trace", "FILE", "Write what each PU did when, for ui.perfetto.dev", file_name(options.trace))
      ->excludes("--sweep", "--machine");
  reader.value("--data", "DIR", "Folder of assets/machines", existing_folder(options.data));
  reader.parts_remover(options.remove_parts);
}

}  // namespace

ParsedCommand parse_bench(const std::vector<std::string>& arguments) {
  BenchOptions options;
  OptionReader reader("throng bench", "Measures what an update of many agents costs, with LOD and crowd logic off.");
  declare_measured(reader, options);
  declare_scheduling(reader, options);
  declare_files(reader, options);
  reader.footer("Example:\n  throng bench --agents 1000,10000 --pus 1,2,4 --json -");
  if (auto stop = reader.read(arguments)) return *stop;
  return options;
}

}  // namespace throng::app
