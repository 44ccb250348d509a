#include "engine/render/shader/shader_source.h"

#include <algorithm>
#include <optional>
#include <regex>
#include <sstream>
#include <string_view>

#include "engine/base/files/input_file.h"

namespace throng::render {
namespace {

std::optional<std::string> included_file(const std::string& line) {
  constexpr std::string_view directive = "#include \"";
  if (!line.starts_with(directive)) return std::nullopt;
  return line.substr(directive.size(), line.find('"', directive.size()) - directive.size());
}

Status append_file(const std::filesystem::path& folder, const std::string& name, ShaderSource& source) {
  constexpr std::size_t most_bytes = std::size_t{1} << 20U;
  auto text = read_text(folder / name, "a shader", most_bytes);
  if (!text)
    return Error{"shader " + (folder / name).string() + ": " + text.error().message +
                 "; --data, or RendererOptions::data, names the folder that has shaders/"};
  std::istringstream input(std::move(*text));
  const std::size_t file = source.files.size();
  source.files.push_back(name);
  std::string line;
  for (std::size_t number = 1; std::getline(input, line); ++number) {
    const std::optional<std::string> included = included_file(line);
    if (!included) {
      source.text += line + "\n";
      source.lines.push_back({file, number});
    } else if (std::ranges::find(source.files, *included) == source.files.end()) {
      if (const Status appended = append_file(folder, *included, source); !appended) return appended.error();
    }
  }
  return Done{};
}

}  // namespace

Result<ShaderSource> read_shader_source(const std::filesystem::path& folder, const std::string& file,
                                        const std::vector<std::string>& switches) {
  ShaderSource source;
  if (const Status appended = append_file(folder, file, source); !appended) return appended.error();
  std::string defined;
  for (const std::string& name : switches) defined += "#define " + name + "\n";
  source.text.insert(std::min(source.text.find('\n'), source.text.size() - 1) + 1, defined);
  source.lines.insert(source.lines.begin() + std::min<std::ptrdiff_t>(1, std::ssize(source.lines)), switches.size(),
                      ShaderLine{});
  return source;
}

std::string first_complaint(const std::string& log, const ShaderSource& source) {
  // Mesa writes "0:line(column): message", others "0(line) : message". The 0 is the number of the string.
  static const std::regex position(R"(\d+[:(](\d+)(?:\(\d+\))?\)?\s*:\s*([^\n]*))");
  std::smatch found;
  const bool has_position = std::regex_search(log, found, position);
  const std::size_t line = has_position ? std::stoul(found[1]) : 0;
  if (line == 0 || line > source.lines.size()) return source.files[0] + ": " + log.substr(0, log.find('\n'));
  const ShaderLine& written = source.lines[line - 1];
  return source.files[written.file] + ":" + std::to_string(written.number) + ": " + found[2].str();
}

}  // namespace throng::render
