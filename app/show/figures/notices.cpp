#include "app/show/figures/notices.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>
#include <vector>

#include "app/character/skin_choice.h"
#include "app/settings/option_values.h"
#include "engine/base/text/joined.h"
#include "engine/base/text/plain_text.h"

namespace throng::app {
namespace {

constexpr std::size_t most_notices = 3;  // of one kind, of a file
constexpr std::size_t most_lines = 12;   // of one kind, of a cast

void add_some(std::string& lines, const std::vector<std::string>& sentences, const std::string& name,
              const std::string& about_the_others) {
  const std::size_t said = sentences.size() <= most_notices + 1 ? sentences.size() : most_notices;
  for (std::size_t i = 0; i < said; ++i) add_line(lines, name + ": " + sentences[i] + ".");
  if (said == sentences.size()) return;
  add_line(lines, name + ": " + std::to_string(sentences.size() - said) + about_the_others);
}

void add_repairs(std::string& lines, const CharacterSource& character, const std::string& name) {
  add_some(lines, character.notes, name, " more such notes; throng inspect --clips-from lists them.");
  add_some(lines, character.repairs, name, " more things were repaired or left out; throng inspect lists them.");
}

// A large cast must not cover the picture with lines.
std::string shortened(const std::string& lines, const std::string& about) {
  std::size_t end = 0, count = 0;
  for (std::size_t at = 0; at < lines.size(); at = std::min(lines.find('\n', at), lines.size()) + 1) {
    if (++count == most_lines + 1) end = at - 1;
  }
  if (count <= most_lines + 1) return lines;
  return lines.substr(0, end) + "\n" + std::to_string(count - most_lines) + " more lines are about " + about +
         "; throng inspect says what is in a file.";
}

// The built-in character has no file. A pack may hold several files.
std::string short_name(const CharacterSource& character) {
  const CharacterFile wanted = character_file(character.file);
  const std::string file = std::filesystem::path(wanted.path).filename().string();
  if (file.empty()) return character.name;
  return plain_text(character.surface.bytes.empty() ? file : with_skin(file, wanted.skin));
}

// Nothing where the file has no other character, or a person chose this one.
std::string cast_sentence(const CharacterSource& character, const std::string& name) {
  if (character.cast.size() < 2 || !character_file(character.file).skin.empty()) return {};
  return name + ": shown is " + character.cast[character.cast_index] + " of " + std::to_string(character.cast.size()) +
         " characters, " + joined(character.cast, ", ", " and ") + "; --skin NAME shows another, --skin all shows all.";
}

}  // namespace

std::string software_notice(const std::string& renderer, const DeviceChoices& choices) {
  std::vector<std::string> parts, options;
  const auto add = [&](bool is_spared, const std::string& words, const char* option) {
    if (!is_spared) return;
    parts.push_back(words);
    options.emplace_back(option);
  };
  add(choices.agents > 0, counted(static_cast<std::size_t>(choices.agents), "agent"), "--agents");
  add(choices.no_multisampling, "no multisampling", "--msaa");
  add(choices.no_shadows && !choices.holds_rate, "no shadows", "--shadows");
  add(choices.error_px > 0, "errors of up to " + shortest_text(choices.error_px) + " pixels", "--error-px");
  add(choices.triangles > 0 && !choices.holds_rate,
      "at most " + with_thousands(static_cast<std::uint64_t>(choices.triangles)) + " triangles", "--triangle-budget");
  if (parts.empty()) return {};
  return "No graphics card draws here; the processor does, by " + renderer + ". To keep up it starts with " +
         joined(parts, ", ", " and ") + "; " + joined(options, ", ", " and ") +
         (options.size() == 1 ? " changes" : " change") + " that.";
}

std::string import_notice(std::span<const CharacterSource> characters) {
  std::string lines;
  std::set<std::string> said;
  for (const CharacterSource& character : characters) {
    const std::string name = short_name(character);
    add_line(lines, cast_sentence(character, name));
    if (said.insert(character_file(character.file).path + name).second) add_repairs(lines, character, name);
  }
  return shortened(lines, "other models");
}

std::string placement_notice(std::span<const CharacterSource> characters) {
  std::vector<std::pair<std::string, std::vector<std::string>>> reasons;  // with all characters that they apply to
  for (const CharacterSource& character : characters) {
    if (character.placement.is_plain) continue;
    const bool has_extent = character.placement.extent.has_value();
    const std::string remedy = has_extent ? "; --scale, --up and --ground overrule it." : ".";
    const std::string reason = character.placement.reasons + remedy;
    auto same = std::ranges::find(reasons, reason, &decltype(reasons)::value_type::first);
    if (same == reasons.end()) same = reasons.insert(same, {reason, {}});
    same->second.push_back(short_name(character));
  }
  std::string lines;
  for (const auto& [reason, names] : reasons) add_line(lines, joined(names, ", ", " and ") + ": " + reason);
  return shortened(lines, "sizes and places of other models");
}

std::string rules_notice(std::span<const Clothing> clothing) {
  std::string lines;
  std::set<std::string> said;
  for (const Clothing& each : clothing) {
    std::string own;
    add_some(own, each.doubts, each.origin, " more such things; mend these first.");
    if (said.insert(own).second) add_line(lines, own);
  }
  return lines;
}

std::string tracks_notice(const Trajectories& trajectories) {
  const std::string counts = trajectories.is_live ? "rows as they come."
                                                  : counted_people(trajectories.persons.size()) + ", " +
                                                        counted(trajectories.row_count, "row") + ".";
  std::string notice = trajectories.file + ": " + trajectories.format + ", " + counts;
  for (const std::string& sentence : trajectories.remarks) notice += " " + sentence;
  std::size_t odd = 0;
  for (const OddityCount& found : trajectories.report.found) odd += found.count;
  if (odd > 0) notice += " throng inspect lists " + counted(odd, "odd thing") + " in it.";
  return notice;
}

std::string plan_notice(std::size_t lines, std::size_t most) {
  const std::string why = lines > most ? std::to_string(most) + " are the most" : "they cross each other too often";
  return "Walls and floors are left out: the place has " + std::to_string(lines) + " lines, and " + why +
         "; --walls names simpler ones.";
}

std::string local_store_notice(const anim::AnimationSystem& system) {
  const std::size_t bytes = system.figures().schedule().local_store_bytes;
  if (system.options().local_store_bytes != 0 || bytes <= anim::usual_local_store_bytes) return {};
  const auto kib = [](std::size_t size) { return std::to_string(size / 1024) + " KiB"; };
  return "The local store is " + kib(bytes) + " instead of " + kib(anim::usual_local_store_bytes) +
         ": one character's largest task needs that much.";
}

std::string pu_notice(int asked, int running) {
  if (running >= asked) return {};
  return std::to_string(asked) + " PUs were asked for, but the system has no more threads: " +
         counted(static_cast<std::size_t>(running), "PU") + " run; --pus asks for fewer.";
}

std::string palette_notice(const ShownPoses& shown) {
  if (!shown.out_of_memory()) return {};
  return "Palette memory ran out: not every agent in view was drawn; fewer --agents would be.";
}

std::string palette_format_notice(const anim::AnimationSystem& system, std::span<const CharacterSource> characters) {
  if (system.options().palettes != PaletteFormat::packed) return {};
  std::string names;
  for (std::uint32_t character = 0; character < characters.size(); ++character) {
    if (system.characters().palette_format(character) == PaletteFormat::packed) continue;
    names += (names.empty() ? "" : ", ") + characters[character].name;
  }
  if (names.empty()) return {};
  return "Palettes stay float of " + names + ": packed ones hold rigid skeletons only.";
}

std::string stream_notice(const anim::AnimationSystem& system, std::span<const CharacterSource> characters) {
  if (system.options().stream != anim::StreamKind::keyframe) return {};
  const auto lacks_keys = [](const anim::BakedClip& clip) { return !clip.is_empty() && clip.keyframe() == nullptr; };
  std::string names;
  for (const CharacterSource& character : characters) {
    if (!std::ranges::any_of(character.character->clips, lacks_keys)) continue;
    names += (names.empty() ? "" : ", ") + character.name;
  }
  if (names.empty()) return {};
  return names + ": played from rows, because the pack has no keys; throng bake --keep-keys packs them.";
}

void add_line(std::string& lines, const std::string& sentence) {
  if (sentence.empty()) return;
  if (!lines.empty()) lines += '\n';
  lines += sentence;
}

}  // namespace throng::app
