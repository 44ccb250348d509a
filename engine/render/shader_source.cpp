#include "engine/render/shader_source.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <regex>
#include <sstream>

namespace throng::render {
namespace {

std::optional<std::string> included_file(const std::string& line) {
  constexpr std::string_view directive = "#include \"";
  if (!line.starts_with(directive)) return std::nullopt;
  return line.substr(directive.size(), line.find('"', directive.size()) - directive.size());
}

std::string line_directive(std::size_t line, std::size_t file) {
  return "#line " + std::to_string(line) + " " + std::to_string(file) + "\n";
}

Status append_file(const std::filesystem::path& folder, const std::string& name, ShaderSource& source) {
  std::ifstream input(folder / name);
  if (!input) return Error{"cannot read shader " + (folder / name).string() + "; check --data"};
  const std::size_t file = source.files.size();
  source.files.push_back(name);
  // Nothing may stand before #version, which only the stage's own file has, in its first line.
  if (file != 0) source.text += line_directive(1, file);
  std::string line;
  for (std::size_t number = 1; std::getline(input, line); ++number) {
    const std::optional<std::string> included = included_file(line);
    if (!included) {
      source.text += line + "\n";
      continue;
    }
    if (std::ranges::find(source.files, *included) == source.files.end()) {
      if (const Status appended = append_file(folder, *included, source); !appended) return appended.error();
    }
    source.text += line_directive(number + 1, file);
  }
  return Done{};
}

}  // namespace

Result<ShaderSource> read_shader_source(const std::filesystem::path& folder, const std::string& file) {
  ShaderSource source;
  if (const Status appended = append_file(folder, file, source); !appended) return appended.error();
  return source;
}

std::string first_complaint(const std::string& log, const ShaderSource& source) {
  // Mesa writes "file:line(column): what", others "file(line) : what".
  static const std::regex position(R"((\d+)[:(](\d+)(?:\(\d+\))?\)?\s*:\s*([^\n]*))");
  std::smatch found;
  if (!std::regex_search(log, found, position)) return source.files[0] + ": " + log.substr(0, log.find('\n'));
  const std::size_t file = std::stoul(found[1]);
  return source.files[std::min(file, source.files.size() - 1)] + ":" + found[2].str() + ": " + found[3].str();
}

}  // namespace throng::render
