#include "app/output/output_folder.h"

#include <cstdio>
#include <system_error>

#include "app/files/json_file.h"
#include "app/files/program_version.h"
#include "app/files/program_words.h"
#include "engine/base/files/output_file.h"

namespace throng::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* run_name = "run.json";

Error refused_folder(std::string_view option, const fs::path& folder, const std::string& why) {
  return {std::string(option) + " " + folder.string() + ": " + why};
}

bool has_files(const fs::path& folder) {
  std::error_code error;
  return fs::directory_iterator(folder, error) != fs::directory_iterator();
}

std::string as_line(std::vector<std::string> words) {
  words.insert(words.begin(), "throng");
  return as_typed(words);
}

}  // namespace

Result<OutputFolder> OutputFolder::open(std::string_view option, const fs::path& folder,
                                        const std::vector<std::string>& run) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return refused_folder(option, folder, "cannot be made: " + error.message());
  const fs::path file = folder / run_name;
  if (fs::exists(file, error)) {
    const auto json = JsonFile(file, {.malformed = "remove the folder, or name another"}).read();
    if (!json) return json.error();
    const auto version = json->value("throng", std::string());
    const auto before = json->value("run", std::vector<std::string>());
    if (before == run && version == program_version()) return OutputFolder(folder);
    return refused_folder(option, folder,
                          "is of another run, `" + as_line(before) + "` of throng " + version +
                              "; name another folder, or remove this one");
  }
  if (has_files(folder)) {
    return refused_folder(option, folder, "has files, and no run.json says of which run; name another folder");
  }
  const Json json = {{"throng", program_version()}, {"run", run}};
  if (Status written = write_whole_file(file, json.dump() + "\n"); !written) return written.error();
  return OutputFolder(folder);
}

fs::path OutputFolder::file(std::string_view kind, int frame) const {
  char name[64];
  std::snprintf(name, sizeof(name), "%.*s_%06d.png", static_cast<int>(kind.size()), kind.data(), frame);
  return folder_ / name;
}

}  // namespace throng::app
