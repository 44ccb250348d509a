#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/commands/command_line/option_reader.h"
#include "app/commands/command_line/options.h"

namespace throng::app {

/// Each function reads the line of one command. `arguments` are the words after the command's name.
ParsedCommand parse_demo(const std::vector<std::string>& arguments);
ParsedCommand parse_pose(const std::vector<std::string>& arguments);
ParsedCommand parse_inspect(const std::vector<std::string>& arguments);
ParsedCommand parse_lod(const std::vector<std::string>& arguments);
ParsedCommand parse_bake(const std::vector<std::string>& arguments);
ParsedCommand parse_bench(const std::vector<std::string>& arguments);
ParsedCommand parse_check(const std::vector<std::string>& arguments);
ParsedCommand parse_compare(const std::vector<std::string>& arguments);

/// Adds the option that keeps a headless run off the graphics card.
void declare_software(OptionReader& reader, DemoOptions& options);

/// Adds the option that says how much memory reading a model may take.
void declare_memory_limit(OptionReader& reader, import::ImportOptions& options);

/// Adds the option that names the SIMD target of the run.
void declare_simd(OptionReader& reader, const anim::Kernels*& kernels);

/// Adds the options that say in what size and where the models of files stand.
void declare_placement(OptionReader& reader, anim::PlacementChoice& placement);

/// Reads the name of a crowd file. All options of the command line win over its values.
ValueReader crowd_file_name(DemoOptions& options);
/// Adds the options of starting values. They come before all other options of such values, which win over them.
void declare_starting_values(OptionReader& reader, DemoOptions& options);
/// A crowd file names its characters, and so may --crowd. Returns how the command line names others, if it does.
std::optional<std::string> contradiction_of_crowd(const DemoOptions& options);

/// Adds the options that say what a run writes of each of its frames.
void declare_output(OptionReader& reader, DemoOptions& options);
/// Fills values that follow from these options and others, once the line is read. Returns a contradiction among them.
std::optional<std::string> settle_output(const OptionReader& reader, DemoOptions& options);

/// Adds the options that say how a file of trajectories is read.
void declare_track_reading(OptionReader& reader, TrajectoryOptions& tracks);
/// Adds the option that names a part of a recorded crowd's time, with a help of its own.
void declare_track_part(OptionReader& reader, const char* help, TrajectoryOptions& tracks);
/// Adds the options of a recorded crowd.
void declare_trajectories(OptionReader& reader, DemoOptions& options);
/// Makes the scene `tracks`, if a recorded crowd is named. `--up` is the crowd's where it has the crowd's name, or no
/// model is named. Returns a contradiction, "--start: goes with --trajectories".
std::optional<std::string> settle_trajectories(const OptionReader& reader, DemoOptions& options);

/// Returns the demo's help as the tables of app/commands/command_line/README.md.
std::string demo_options_as_markdown();

}  // namespace throng::app
