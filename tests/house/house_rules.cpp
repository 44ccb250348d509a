#include "tests/house/house_rules.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string_view>

#include "tests/house/floors.h"
#include "tests/house/includes.h"

namespace throng::house {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_lines = 350;

SourceFile read_file(const fs::path& project, const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(project / path, std::ios::binary).rdbuf();
  return source_file(path, text.str());
}

std::string finding(const std::string& path, std::size_t line, const std::string& what) {
  return path + ":" + std::to_string(line) + ": " + what;
}

Findings findings_among(const std::vector<Include>& includes, const std::string& what, auto is_wrong) {
  Findings findings;
  for (const Include& include : includes) {
    if (!is_wrong(include)) continue;
    findings.push_back(finding(include.file->path, include.line, "includes " + include.target + ": " + what));
  }
  return findings;
}

void append(Findings& findings, const Findings& more) { findings.insert(findings.end(), more.begin(), more.end()); }

bool climbs_in_its_house(const Include& include) {
  return std::ranges::any_of(houses(),
                             [&](const House& house) { return climbs(house, include.file->path, include.target); });
}

bool leaves_the_engine(const Include& include) {
  const auto starts = [&](std::string_view folder) { return include.target.starts_with(folder); };
  return starts("app/") || starts("assets/") || starts("tests/");
}

/// The headers of a part, and where they may be included: folders end in /, files are whole.
struct Part {
  std::string_view headers;
  std::vector<std::string_view> seen_by;
};

const std::vector<Part>& parts() {
  static const std::vector<Part> all{
      {"tiny_gltf", {"engine/anim/import/"}},
      {"nlohmann/", {"engine/base/json/", "engine/anim/import/", "assets/"}},
      {"imgui",
       {"engine/render/passes/overlay_renderer.cpp", "engine/render/passes/imgui_versions.h", "app/window/panel/"}},
      {"CLI/", {"app/commands/command_line/"}},
      {"GLFW/", {"engine/render/gl/window_context.cpp", "app/window/window_input.cpp", "app/window/full_screen.cpp"}},
      {"EGL/", {"engine/render/gl/egl_context.cpp", "engine/crowd/examples/own_opengl.h"}},
      {"glad/", {"engine/render/"}},
      {"hwy/",
       {"engine/anim/kernel/", "engine/base/simd_targets.h", "app/people/crowd/steering/near_bodies.cpp",
        "app/people/crowd/steering/step_strip.cpp"}},
      {"oneapi/tbb/", {"engine/anim/run/tbb_executor.h", "engine/anim/run/tbb_executor.cpp"}},
      {"stb_image", {"engine/anim/import/pixels/"}},
      {"webp/", {"engine/anim/import/pixels/"}},
      {"png.h", {"engine/render/image.cpp", "engine/crowd/examples/own_opengl.h"}},
      {"meshoptimizer", {"engine/anim/import/", "engine/render/"}},
      {"draco/", {"engine/anim/import/"}},
      {"sqlite3.h", {"engine/tracks/database.cpp"}},
      {"expat.h", {"engine/tracks/text/xml_text.cpp"}},
  };
  return all;
}

bool is_seen_by(const Part& part, const std::string& path) {
  return std::any_of(part.seen_by.begin(), part.seen_by.end(), [&](std::string_view place) {
    return place.ends_with('/') ? path.starts_with(place) : path == place;
  });
}

}  // namespace

SourceFile source_file(std::string path, const std::string& text) {
  SourceFile file{std::move(path), {}};
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) file.lines.push_back(line);
  return file;
}

Tree read_project(const fs::path& project) {
  static const std::set<std::string> pages{".md", ".txt", ".cmake", ".sh", ".json", ""};
  Tree tree;
  for (const std::string_view top : {"engine", "app", "assets", "shaders", "tests", "scripts", ".ci"}) {
    for (const auto& entry : fs::recursive_directory_iterator(project / top)) {
      const std::string path = entry.path().lexically_relative(project).generic_string();
      const bool is_page = pages.contains(entry.path().extension().string()) && !path.starts_with("tests/data/");
      if (entry.is_regular_file() && (is_code(path) || is_page)) tree.push_back(read_file(project, path));
    }
  }
  for (const char* const top : {"README.md", "CHANGELOG.md", "CMakeLists.txt"}) tree.push_back(read_file(project, top));
  return tree;
}

Findings includes_that_climb(const Tree& tree) {
  Findings findings;
  for (const House& house : houses()) {
    append(findings, findings_among(includes_of(tree, house.folder), "a file sees its own room and lower floors",
                                    climbs_in_its_house));
  }
  append(findings, findings_among(includes_of(tree, "engine/"), "nothing under engine/ needs it", leaves_the_engine));
  return findings;
}

Findings rooms_without_files(const Tree& tree) {
  Findings findings;
  for (const House& house : houses()) {
    for (const std::vector<std::string>& floor : house.floors) {
      for (const std::string& room : floor) {
        const std::string folder = house.folder + room + "/";
        if (std::ranges::none_of(tree, [&](const SourceFile& file) { return file.path.starts_with(folder); })) {
          findings.push_back(folder + ": is planned and has no file");
        }
      }
    }
  }
  return findings;
}

Findings rooms_too_full(const Tree& tree) {
  constexpr std::size_t most_files = 60;
  std::map<std::string, std::size_t> files;
  for (const SourceFile& file : tree) {
    if (is_code(file.path) && !file.path.starts_with("tests/"))
      ++files[fs::path(file.path).parent_path().generic_string()];
  }
  Findings findings;
  for (const auto& [folder, count] : files) {
    if (count > most_files) findings.push_back(finding(folder, count, "files: which rooms are inside?"));
  }
  return findings;
}

Findings includes_that_join(const Tree& tree) {
  struct Part {
    std::string_view folder, within;
    std::vector<std::string_view> sees;
  };
  static const std::vector<Part> parts_that_stand_alone{
      {"engine/base/",
       "engine/",
       {"engine/anim/include/throng/standard.h", "engine/anim/include/throng/host.h",
        "engine/anim/include/throng/math.h"}},
      {"engine/anim/", "engine/", {"engine/base/"}},
      {"engine/render/",
       "engine/",
       {"engine/base/", "engine/anim/include/throng/host.h", "engine/anim/include/throng/result.h"}},
      {"engine/tracks/", "engine/", {"engine/base/", "engine/anim/"}},
      {"engine/crowd/",
       "engine/",
       {"engine/base/", "engine/anim/", "engine/render/include/throng/render/agent_look.h",
        "engine/render/include/throng/render/crowd_batch.h", "engine/render/include/throng/render/crowd_draw.h",
        "engine/render/include/throng/render/crowd_mesh_data.h",
        "engine/render/include/throng/render/instance_record.h",
        "engine/render/include/throng/render/mesh_error_value.h",
        "engine/render/include/throng/render/palette_page.h"}},
      {"app/window/panel/",
       "app/show/",
       {"app/show/camera/", "app/show/lod/", "app/show/report/", "app/show/request/"}}};
  Findings findings;
  for (const Part& part : parts_that_stand_alone) {
    const auto joins = [&](const Include& include) {
      if (include.file->path.find("/examples/") != std::string::npos) return false;  // an example is a host
      const auto starts = [&](std::string_view folder) { return include.target.starts_with(folder); };
      return starts(part.within) && !starts(part.folder) && std::ranges::none_of(part.sees, starts);
    };
    append(findings, findings_among(includes_of(tree, part.folder), "this part stands without it", joins));
  }
  return findings;
}

Findings parts_seen_elsewhere(const Tree& tree) {
  Findings findings;
  for (const std::string_view folder : {"engine/", "app/"}) {
    for (const Part& part : parts()) {
      append(findings, findings_among(includes_of(tree, folder), "few files speak with it, not this one",
                                      [&](const Include& include) {
                                        return include.target.starts_with(part.headers) &&
                                               !is_seen_by(part, include.file->path);
                                      }));
    }
  }
  return findings;
}

Findings files_opened_elsewhere(const Tree& tree) {
  static const std::regex opens(
      R"(\b([io]?fstream|f(re|d)?open|_w?s?open|O_(RDONLY|WRONLY|RDWR|CREAT)|CreateFile\w?|mko?stemps?|tmpfile)\b)");
  static const std::regex parses(R"(\b(json::parse|sax_parse)\b)");
  Findings findings;
  for (const SourceFile& file : tree) {
    if (!is_code(file.path) || file.path.starts_with("tests/")) continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const std::string& line = file.lines[i];
      if (!file.path.starts_with("engine/base/files/") && std::regex_search(line, opens)) {
        findings.push_back(finding(file.path, i + 1, "engine/base/files alone opens files"));
      }
      if (file.path != "engine/base/json/json_tree.h" && std::regex_search(line, parses)) {
        findings.push_back(finding(file.path, i + 1, "parse_json_tree() alone parses JSON"));
      }
    }
  }
  return findings;
}

Findings maths_in_main(const Tree& tree) {
  static const std::regex fraction(R"(.*\b(float|double|glm|std::(sin|cos|sqrt|pow))\b.*)");
  Findings findings =
      findings_among(includes_of(tree, "app/main.cpp"), "main parses and dispatches", [](const Include& include) {
        const bool standard = include.target.find('/') == std::string::npos;
        return include.target == "cmath" ||
               !(standard || include.target.starts_with("app/") || include.target.starts_with("engine/base/files/"));
      });
  for (const SourceFile& file : tree) {
    for (std::size_t i = 0; file.path == "app/main.cpp" && i < file.lines.size(); ++i) {
      if (std::regex_match(file.lines[i], fraction)) findings.push_back(finding(file.path, i + 1, "maths in main"));
    }
  }
  return findings;
}

Findings files_too_long(const Tree& tree) {
  Findings findings;
  for (const SourceFile& file : tree) {
    if (!is_code(file.path) || file.lines.size() <= most_lines) continue;
    findings.push_back(finding(file.path, file.lines.size(), "is there a second subject inside?"));
  }
  return findings;
}

Findings machine_paths(const Tree& tree) {
  // Built from two halves each, so that this file keeps its own rule.
  static const std::array<std::string, 5> homes{
      "/ho"
      "me/",
      "/ro"
      "ot/",
      "/wo"
      "rk/",
      "/Us"
      "ers/",
      "/tm"
      "p/"};
  Findings findings;
  for (const SourceFile& file : tree) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const bool has = std::any_of(homes.begin(), homes.end(), [&](const std::string& home) {
        const std::size_t at = file.lines[i].find(home);
        return at != std::string::npos && (at == 0 || !std::isalnum(static_cast<unsigned char>(file.lines[i][at - 1])));
      });
      if (has) findings.push_back(finding(file.path, i + 1, "a path that other machines lack"));
    }
  }
  return findings;
}

Findings readme_program_that_differs(const Tree& tree) {
  const auto lines_of = [&tree](const std::string& path) {
    const auto file = std::ranges::find(tree, path, &SourceFile::path);
    return file == tree.end() ? std::vector<std::string>{} : file->lines;
  };
  const std::string program = "tests/library/readme_program.cpp";
  const std::vector<std::string> readme = lines_of("README.md");
  const std::vector<std::string> built = lines_of(program);
  const auto fence = std::ranges::find(readme, "```cpp");
  const auto first = fence == readme.end() ? fence : fence + 1;
  const auto last = std::find(first, readme.end(), "```");
  const auto [here, there] = std::mismatch(first, last, built.begin(), built.end());
  if (first != last && here == last && there == built.end()) return {};
  return {finding("README.md", static_cast<std::size_t>(here - readme.begin()) + 1, "differs from " + program)};
}

Findings folders_without_readme(const Tree& tree) {
  std::set<std::string> folders;
  std::set<std::string> described;
  for (const SourceFile& file : tree) {
    const fs::path path = file.path;
    if (!file.path.starts_with("engine/") && !file.path.starts_with("app/")) continue;
    (path.filename() == "README.md" ? described : folders).insert(path.parent_path().generic_string());
  }
  Findings findings;
  std::set_difference(folders.begin(), folders.end(), described.begin(), described.end(), std::back_inserter(findings));
  return findings;
}

Findings paper_rows_without_file_or_test(const Tree& tree) {
  static const std::regex row(R"(^\|[^|]*\|[^|]*\| `([^`]+)` \| `(\w+\.\w+)` \|$)");
  static const std::regex declaration(R"(^TEST(?:_F|_P)?\((\w+), *(\w+).*)");
  constexpr std::string_view folder = "engine/anim/";
  std::set<std::string> files;
  std::set<std::string> tests;
  const SourceFile* page = nullptr;
  for (const SourceFile& file : tree) {
    files.insert(file.path);
    if (file.path == std::string(folder) + "README.md") page = &file;
    std::smatch match;
    for (const std::string& line : file.lines) {
      if (file.path.starts_with("tests/") && std::regex_match(line, match, declaration)) {
        tests.insert(match.str(1) + "." + match.str(2));
      }
    }
  }
  Findings findings;
  std::size_t rows = 0;
  for (std::size_t i = 0; page != nullptr && i < page->lines.size(); ++i) {
    std::smatch match;
    if (!std::regex_match(page->lines[i], match, row)) continue;
    ++rows;
    if (!files.contains(std::string(folder) + match.str(1))) {
      findings.push_back(finding(page->path, i + 1, "there is no file " + match.str(1)));
    }
    if (!tests.contains(match[2])) findings.push_back(finding(page->path, i + 1, "there is no test " + match.str(2)));
  }
  if (rows == 0) findings.push_back(std::string(folder) + "README.md: has no table of the paper");
  return findings;
}

}  // namespace throng::house
