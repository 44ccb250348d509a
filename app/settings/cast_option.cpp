#include "app/settings/cast_option.h"

#include <filesystem>
#include <system_error>
#include <utility>

namespace throng::app {
namespace {

bool is_there(const std::string& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

Complaint read_entry(const std::string& text, CastEntry& entry) {
  const std::size_t star = is_there(text) ? std::string::npos : text.rfind('*');
  entry.file = text.substr(0, star);
  if (entry.file.empty()) return "must be FILE*SHARE, with commas between several; FILE may be a folder";
  if (star == std::string::npos) return {};
  const Complaint complaint = read_number(text.substr(star + 1), least_share, most_share, entry.share.emplace());
  return complaint ? Complaint("the share of " + entry.file + " " + *complaint + ", as in " + entry.file + "*2")
                   : Complaint();
}

}  // namespace

ValueReader cast_entries(std::vector<CastEntry>& target) {
  return [&target](const std::string& text) -> Complaint {
    std::vector<CastEntry> entries;
    for (const std::string& part : parts_between_commas(text)) {
      if (Complaint complaint = read_entry(part, entries.emplace_back())) return complaint;
    }
    if (entries.size() > most_models) return "must be " + std::to_string(most_models) + " files and folders at most";
    target = std::move(entries);
    return {};
  };
}

ValueReader cast_or_rules(std::vector<CastEntry>& target, std::string& rules) {
  return [&rules, entries = cast_entries(target)](const std::string& text) -> Complaint {
    if (!text.ends_with(".json")) return entries(text);
    rules = text;
    return {};
  };
}

}  // namespace throng::app
