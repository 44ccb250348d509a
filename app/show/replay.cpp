#include "app/show/replay.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "app/files/byte_hash.h"
#include "app/settings/tuning_values.h"
#include "app/show/show.h"
#include "app/show/stage/rewind.h"
#include "app/show/stage/stage.h"

namespace throng::app {
namespace {

// Counts the agents whose hashes differ from the recorded ones, and names the first of them.
struct Difference {
  std::uint32_t first = 0;
  std::size_t agents = 0;
};

Difference difference(std::span<const std::uint64_t> hashes, std::span<const std::uint16_t> recorded) {
  Difference found;
  for (std::uint32_t agent = 0; agent < hashes.size(); ++agent) {
    if (short_hash(hashes[agent]) == recorded[agent]) continue;
    if (found.agents++ == 0) found.first = agent;
  }
  return found;
}

// Compares all but the files, which may have moved.
bool are_equal(std::span<const CharacterSource> people, std::span<const ChosenCharacter> recorded_people) {
  const auto is_equal = [](const CharacterSource& person, ChosenCharacter as_recorded) {
    as_recorded.file = person.file;
    as_recorded.clip_files = person.clip_files;
    return exactly(person) == as_recorded;
  };
  return std::ranges::equal(people, recorded_people, is_equal);
}

// Files that the command line names stand in for the recorded files.
void take_files(std::span<const ChosenCharacter> characters, DemoOptions& options) {
  const bool is_built_in = characters.front().file.empty();
  if (is_built_in && options.clips_from.empty()) options.clips_from = characters.front().clip_files;
  if (is_built_in) return;
  options.cast = entries_of(characters);
  if (options.clips_from.empty()) return;
  for (CastEntry& entry : options.cast) entry.clip_files.reset();
}

// Files that stand in for recorded files have their sizes and places, where there are as many.
void place_as_recorded(std::span<const ChosenCharacter> characters, DemoOptions& options) {
  if (options.models.size() != characters.size()) return;
  options.cast = cast_of(std::exchange(options.models, {}));
  for (std::size_t i = 0; i < characters.size(); ++i) options.cast[i].placement = characters[i].placement;
}

std::string name_of(std::uint32_t agent, const Stage& stage) {
  if (agent >= stage.crowd().size()) return "the camera of the cut scene";
  return "agent " + std::to_string(agent) + ", " + stage.character_of(agent).name;
}

}  // namespace

Result<std::unique_ptr<Replay>> Replay::open(const std::filesystem::path& file) {
  auto reader = RecordingReader::open(file);
  if (!reader) return reader.error();
  return std::unique_ptr<Replay>(new Replay(file, std::move(*reader)));
}

DemoOptions Replay::options(const DemoOptions& given) {
  given_ = given;
  const RecordingHeader& header = reader_->header();
  DemoOptions options = given;
  if (options.models.empty()) {
    take_files(header.characters, options);
  } else {
    place_as_recorded(header.characters, options);
  }
  options.tuning = with_own_scheduling(header.tuning);
  options.placement = header.characters.front().placement;
  options.values_given.all = true;
  if (std::ranges::find(given.given, "--size") == given.given.end()) {
    options.width = header.width;
    options.height = header.height;
  }
  return options;
}

Tuning Replay::with_own_scheduling(Tuning tuning) const {
  for (const TuningValue& value : tuning_values()) {
    const bool given = std::ranges::find(given_.given, value.option_name()) != given_.given.end();
    if (given && value.only_schedules) copy_value(value, given_.tuning, tuning);
  }
  return tuning;
}

Status Replay::begin(Show& show) const {
  show.keep_moments();
  return become_recorded_characters(show, show.stage().people());
}

Status Replay::become_recorded_characters(Show& show, std::span<const CharacterSource> people) const {
  const std::vector<ChosenCharacter>& recorded_people = reader_->header().characters;
  if (people.size() != recorded_people.size()) {
    return Error{file_.string() + ": is of " + std::to_string(recorded_people.size()) + " characters, and there are " +
                 std::to_string(people.size())};
  }
  const bool are_on_stage = people.data() == show.stage().people().data();
  if (are_on_stage && are_equal(people, recorded_people)) return Done{};
  std::vector<CharacterSource> characters(people.begin(), people.end());
  for (std::size_t i = 0; i < characters.size(); ++i) {
    const Status became = become(recorded_people[i], characters[i]);
    if (!became) return Error{file_.string() + ": " + became.error().message};
  }
  const Status replaced = show.replace_characters(std::move(characters));
  return replaced ? replaced : Status(Error{file_.string() + ": " + replaced.error().message});
}

Status Replay::begin_anew(Show& show) {
  const auto people = first_people_.empty() ? show.stage().people() : std::span<const CharacterSource>(first_people_);
  if (Status became = become_recorded_characters(show, people); !became) return became;
  if (Status begun = show.begin_anew(with_own_scheduling(reader_->header().tuning)); !begun) return begun;
  reader_->begin_anew();
  return Done{};
}

Result<bool> Replay::step(Show& show) {
  for (;;) {
    const Result<RecordedItem> item = reader_->next();
    if (!item) return item.error();
    if (std::holds_alternative<RecordedEnd>(*item)) return false;
    if (const auto* const frame = std::get_if<RecordedFrame>(&*item)) {
      show.animate_as(*frame);
      delta_ = frame->delta;
      if (const Status equal = compare(*frame, show.stage()); !equal) return equal.error();
      if (reader_->frames_read() > frames_equal_) {
        frames_equal_ = reader_->frames_read();
        agents_ = show.stage().crowd().size();
      }
      return true;
    }
    const CrowdRequest request = with_own_scheduling(std::get<CrowdRequest>(*item));
    if (may_go_back_ && first_people_.empty() && std::holds_alternative<SetCast>(request)) {
      first_people_.assign(show.stage().people().begin(), show.stage().people().end());
    }
    if (const Status repeated = show.take(request); !repeated) {
      return reader_->error_at(reader_->frames_read() + 1, repeated.error().message);
    }
  }
}

CrowdRequest Replay::with_own_scheduling(CrowdRequest request) const {
  if (auto* const values = std::get_if<Apply>(&request)) values->tuning = with_own_scheduling(values->tuning);
  return request;
}

Status Replay::compare(const RecordedFrame& frame, const Stage& stage) const {
  const auto hashes = stage.animated().agent_hashes();
  const auto recorded_hashes = reader_->agent_hashes();
  const std::uint64_t number = reader_->frames_read();
  if (hashes.size() != recorded_hashes.size()) {
    return reader_->error_at(number, "has " + std::to_string(hashes.size()) + " agents, recorded were " +
                                         std::to_string(recorded_hashes.size()));
  }
  const Difference found = difference(hashes, recorded_hashes);
  if (found.agents > 0) {
    return reader_->error_at(number, "is the first that differs, in " + name_of(found.first, stage) + "; in all, " +
                                         std::to_string(found.agents) + " of " + std::to_string(hashes.size()) +
                                         " agents are posed otherwise than recorded");
  }
  if (stage.system().figures().pose_hash() == frame.pose_hash) return Done{};
  return reader_->error_at(number, "is the first that differs, with pose hash " +
                                       hex_string(stage.system().figures().pose_hash()) + " instead of " +
                                       hex_string(frame.pose_hash) +
                                       ", and in no agent as far as 16 bits of each can tell");
}

std::string Replay::summary() const {
  return file_.string() + ": all " + std::to_string(frames_equal_) + " frames are equal, the last of " +
         std::to_string(agents_) + " agents";
}

}  // namespace throng::app
