#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace throng::house {

/// A text of the project. `path` is from the project's folder, with slashes.
struct SourceFile {
  std::string path;
  std::vector<std::string> lines;
};

using Tree = std::vector<SourceFile>;

SourceFile source_file(std::string path, const std::string& text);

/// Reads every file of ours that a person writes: code, shaders, scripts, build files, pages.
Tree read_project(const std::filesystem::path& project);

/// The findings of a rule, one line each, "path:line: what is wrong". There are none when the rule is kept. The
/// functions below find where their rule is broken.
using Findings = std::vector<std::string>;

/// A file of a house (floors.h) includes its own room or lower floors; nothing under engine/ includes app/, assets/
/// or tests/.
Findings includes_that_climb(const Tree& tree);

/// Every room that the plan of the house has is in the tree.
Findings rooms_without_files(const Tree& tree);

/// No folder of engine/, app/, assets/ or shaders/ holds more than 60 files of code.
Findings rooms_too_full(const Tree& tree);

/// Of the engine, engine/anim and engine/render see engine/base alone, and engine/tracks sees engine/anim too.
/// engine/crowd joins engine/anim with the plain data of engine/render, and app/ joins all. Of a show, the panel sees
/// plain data alone: requests, reports, cameras and what level of detail decides.
Findings includes_that_join(const Tree& tree);

/// Only the few files that speak with a part that others made see it.
Findings parts_seen_elsewhere(const Tree& tree);

/// Only engine/base/files opens files, and only engine/base/json parses JSON. Tests may do both.
Findings files_opened_elsewhere(const Tree& tree);

/// app/main.cpp parses and dispatches: it includes app/, engine/base/files/ and the standard library, and has no
/// fractions.
Findings maths_in_main(const Tree& tree);

/// No file of code has more than 350 lines.
Findings files_too_long(const Tree& tree);

/// No file names a path that only one machine has.
Findings machine_paths(const Tree& tree);

/// The C++ of the README is, line by line, the program that tests/library builds and runs.
Findings readme_program_that_differs(const Tree& tree);

/// Every folder of engine/ and app/ with files in it says in a README what it is.
Findings folders_without_readme(const Tree& tree);

/// Each row `| section | it asks for | `file` | `Suite.Test` |` of engine/anim/README.md names a file below engine/anim
/// and a test that are there. A page without such rows is a finding.
Findings paper_rows_without_file_or_test(const Tree& tree);

}  // namespace throng::house
