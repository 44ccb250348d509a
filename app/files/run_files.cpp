#include "app/files/run_files.h"

#include <algorithm>
#include <string_view>
#include <system_error>

#include "engine/anim/import/bytes/refusal.h"
#include "engine/anim/import/model_files.h"
#include "engine/base/files/input_file.h"
#include "engine/base/files/output_file.h"
#include "engine/base/json/json.h"

namespace throng::app {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view standard_output = "-";

/// Returns whether two names are of one file, whether it exists or not.
bool are_one(const fs::path& a, const fs::path& b) {
  if (a == standard_output || b == standard_output) return a == b;
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  const fs::path whole_a = fs::weakly_canonical(a, error), whole_b = fs::weakly_canonical(b, error);
  return !whole_a.empty() && whole_a == whole_b;
}

const NamedFile* same_among(std::span<const NamedFile> others, const fs::path& file) {
  const auto found = std::ranges::find_if(
      others, [&](const NamedFile& other) { return !other.file.empty() && are_one(other.file, file); });
  return found == others.end() ? nullptr : &*found;
}

/// Returns the files that a .gltf names. The import refuses a file that cannot be read.
std::vector<fs::path> files_named_by(const fs::path& model) {
  std::vector<fs::path> files;
  if (model.extension() != ".gltf") return files;
  const auto text = read_text(model, "a .gltf", most_json_bytes);
  const auto json = text ? parse_json(*text) : text.error();
  if (!json) return files;
  const import::ModelFiles beside({.path = model});
  std::vector<std::string> repairs;
  for (const char* const kind : {"buffers", "images"}) {
    for (const Json& each : (*json)[kind].elements()) {
      try {
        files.push_back(beside.find(each.value("uri", std::string()), kind, repairs));
      } catch (const import::Refusal&) {  // there is no such file
      }
    }
  }
  return files;
}

Error refused(const NamedFile& file, const NamedFile& other, std::string_view what) {
  return {file.option + " " + file.file.string() + ": " + other.option + " " + std::string(what) + "; name another"};
}

}  // namespace

void RunFiles::read_model(const std::string& model) {
  if (model.empty()) return;
  std::error_code error;
  const fs::path file = fs::exists(model, error) ? model : model.substr(0, model.rfind('#'));
  std::vector<fs::path> all{file};
  for (fs::directory_iterator entry(file, error), end; !error && entry != end; entry.increment(error)) {
    all.push_back(entry->path());
  }
  for (const fs::path& each : all) {
    read.push_back({"the model", each});
    for (const fs::path& named : files_named_by(each)) read.push_back({"the model", named});
    for (const char* const ending : {".throng.json", ".lod.json"}) {
      read.push_back({"the model", fs::path(each.string() + ending)});
    }
  }
}

Status check(const RunFiles& files) {
  for (std::size_t i = 0; i < files.written.size(); ++i) {
    const NamedFile& output = files.written[i];
    if (output.file.empty() || is_device_or_pipe(output.file)) continue;
    if (const NamedFile* const input = same_among(files.read, output.file)) {
      return refused(output, *input, "reads this file");
    }
    if (const NamedFile* const other = same_among(std::span(files.written).first(i), output.file)) {
      return refused(output, *other, "writes this file too");
    }
  }
  for (const auto& [option, file] : files.written) {
    if (file.empty() || file == standard_output) continue;
    if (Status writable = check_can_be_written(option, file); !writable) return writable;
  }
  return Done{};
}

std::vector<std::string> report_or_remove_parts(const RunFiles& files) {
  std::vector<std::string> lines;
  for (const auto& [option, file] : files.written) {
    if (file.empty() || file == standard_output || is_device_or_pipe(file)) continue;
    for (const fs::path& part : parts_left_beside(file)) {
      std::error_code error;
      const bool removed = files.remove_parts && fs::remove(part, error);
      lines.push_back(part.string() + (removed ? " is removed: a run that was killed had left it"
                                               : " is left of a run that was killed; --remove-parts removes it"));
    }
  }
  return lines;
}

}  // namespace throng::app
