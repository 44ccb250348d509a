#include <algorithm>
#include <string>

#include "app/commands/command_line/option_reader.h"
#include "app/commands/command_line/options_commands.h"
#include "app/settings/tuning_values.h"

namespace throng::app {
namespace {

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
  reader.model(options.model, "A glTF file (.glb or .gltf), a pack, or trajectories")->required();
  clips_from(reader, options.clips_from);
  reading(reader, options.reading);
  reader.flag("--json", options.json, "As one JSON object");
  declare_placement(reader, options.placement);
  reader.option_defaults()->group("How trajectories are read");
  declare_track_reading(reader, options.tracks);
  reader.option_defaults()->group("What trajectories are measured for");
  reader.value("--measures", "FILE.csv",
               "Write place, speed and density of each person at each row, with PedPy's columns",
               file_that_ends_in(".csv", options.measures));
  reader.value("--count-line", "X1,Y1,X2,Y2",
               "Count the people who pass a line between two points of the file, in metres",
               ends_of_line(options.count_line));
  declare_track_part(reader, "Measure this part of its clock only (all of it)", options.tracks);
  reader.value("--cut-off", "METRES", "How far a person's own ground reaches at most, for the density, 0.1 to 10 (1)",
               number_between(options.cut_off.emplace(Tuning().density_cut_off), 0.1F, 10.0F));
  reader.footer(
      "Examples:\n  throng inspect fox.glb --strict\n  throng inspect walk.csv --unit cm --fps 16 --measures "
      "people.csv");
  if (auto stop = reader.read(arguments)) return *stop;
  const bool is_measured = !options.measures.empty() || options.count_line;
  if (!is_measured && reader.given("--track-part"))
    return UsageError{"--track-part: goes with --measures or --count-line"};
  if (options.measures.empty() && reader.given("--cut-off")) return UsageError{"--cut-off: goes with --measures"};
  options.tracks.reading.up = options.placement.up == anim::UpAxis::y && reader.given("--up") ? TrackUp::y : TrackUp::z;
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
      ->required(std::ranges::find(arguments, "--built-in") == arguments.end())
      ->group("Model");
  reader.value("-o", "FILE.pack", "The file to write", file_that_ends_in(".pack", options.pack))->required();
  CLI::Option* const keys =
      reader.flag("--keep-keys", options.keep_keys,
                  "Keep the models' keys, which take most of the file: for pose, inspect, other sizes and clips");
  reader.parts_remover(options.remove_parts);
  clips_from(reader, options.clips_from);
  reading(reader, options.reading);
  declare_placement(reader, options.placement);
  CLI::Option* const built_in =
      reader
          .flag("--built-in", options.built_in, "The built-in character with all that it may wear, instead of models")
          ->group("Model");
  for (const char* other : {"MODEL", "--clips-from", "--strict", "--memory-limit", "--scale", "--up", "--ground"}) {
    built_in->excludes(other);
  }
  built_in->excludes(keys);
  reader.value("--data", "DIR", "Folder of assets for --built-in", existing_folder(options.data))
      ->needs(built_in)
      ->group("Model");
  reader.footer("Example:\n  throng bake fox.glb horse.glb -o animals.pack");
  if (auto stop = reader.read(arguments)) return *stop;
  return options;
}

}  // namespace throng::app
