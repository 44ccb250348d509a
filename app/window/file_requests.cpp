#include "app/window/file_requests.h"

#include <system_error>
#include <utility>

#include "app/files/whole_path.h"
#include "app/show/described_crowd.h"
#include "app/show/kept_choices.h"
#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "app/window/wardrobe_requests.h"

namespace throng::app {
namespace {

std::filesystem::path crowd_file(const std::string& name) { return name + crowd_file_ending; }

}  // namespace

void FileRequests::take(const FileRequest& request) {
  std::visit([this](const auto& asked) { carry_out(asked); }, request);
}

void FileRequests::carry_out(const SavePreset& asked) {
  const std::filesystem::path file = preset_file(asked.preset);
  const Tuning& tuning = session_.editor.tuning();
  if (!messages().report(write_preset(file, {tuning, session_.camera.place()}), "Wrote " + whole_path(file))) return;
  session_.unsaved.keep(tuning, overlay_.tuning_pair());
  session_.reporter.report().preset_names = preset_names();
}

void FileRequests::carry_out(const LoadPreset& asked) {
  const Result<Preset> preset = read_preset(preset_file(asked.preset));
  if (!preset) return messages().say(preset.error().message, Message::Kind::refused);
  take(*preset);
}

void FileRequests::carry_out(const DeletePreset& asked) {
  const std::filesystem::path file = preset_file(asked.preset);
  std::error_code failed;
  std::filesystem::remove(file, failed);
  messages().report(failed ? Status(Error{file.string() + ": " + failed.message()}) : Done{},
                    "Deleted " + whole_path(file));
  session_.reporter.report().preset_names = preset_names();
}

void FileRequests::carry_out(const LoadIntoOther& asked) {
  const Result<Preset> preset = read_preset(preset_file(asked.preset));
  if (!preset) return messages().say(preset.error().message, Message::Kind::refused);
  overlay_.tuning_pair().take_other(preset->tuning, asked.preset);
  session_.unsaved.keep_other(preset->tuning);
}

void FileRequests::carry_out(const SaveCrowd& asked) {
  const std::filesystem::path file = crowd_file(asked.crowd);
  const CrowdSetup setup = described_here();
  if (!messages().report(write_crowd_file(file, setup), "Wrote " + whole_path(file))) return;
  keep(file, setup.pair);
  session_.reporter.report().crowd_names = crowd_names(".");
}

void FileRequests::carry_out(const OpenCrowd& asked) { open_crowd(crowd_file(asked.crowd)); }

CrowdSetup FileRequests::described_here() const {
  CrowdSetup setup = described(session_.show, {session_.editor.tuning(), session_.camera.place()});
  setup.pair = overlay_.tuning_pair();
  setup.bookmarks = session_.camera.bookmarks();
  return setup;
}

void FileRequests::open_crowd(const std::filesystem::path& file) {
  const auto setup = read_crowd_file(file);
  if (!setup) return messages().say(setup.error().message, Message::Kind::refused);
  auto plan = session_.editor.plan_to_open(*setup);
  if (!plan) return messages().say(file.string() + ": " + plan.error().message, Message::Kind::refused);
  session_.loading.begin(
      std::move(*plan),
      [this, opened = *setup, file](const ShownTracks& tracks) {
        if (!session_.editor.open(opened, file.string(), tracks)) return;
        session_.camera.take_back(session_.show);
        take_kept(opened);
        keep(file, opened.pair);
        messages().say("Opened " + whole_path(file));
      },
      file.string());
}

const CharacterSource& FileRequests::character() const { return session_.show.stage().characters()[shown()]; }

void FileRequests::keep(const std::filesystem::path& file, const TuningPair& pair) {
  session_.unsaved.keep(session_.editor.tuning());
  if (pair.has_two()) session_.unsaved.keep_other(pair.other());
  session_.unsaved.keep(session_.crowd_work());
  session_.reporter.report().crowd = std::filesystem::path(file).replace_extension().string();
  session_.note_recent(file);
}

void FileRequests::take_kept(const CrowdSetup& setup) {
  overlay_.tuning_pair() = setup.pair;
  if (setup.pair.has_two()) session_.unsaved.keep_other(setup.pair.other());
  session_.camera.take_bookmarks(setup.bookmarks);
}

void FileRequests::take(const Preset& preset) {
  Tuning tuning = preset.tuning;
  tuning.inspection = with_kept_values(session_.editor.tuning().inspection, tuning.inspection);
  if (!session_.editor.take(Apply{tuning})) return;
  session_.unsaved.keep(session_.editor.tuning(), overlay_.tuning_pair());
  if (preset.camera) session_.camera.put(*preset.camera, session_.show);
}

void FileRequests::carry_out(const SaveRules& asked) {
  const auto rules = saved(asked, session_.show.stage(), shown());
  if (dress(rules)) messages().say("Wrote " + whole_path(rules->file));
}

void FileRequests::carry_out(const LoadRules& asked) {
  const auto rules = loaded(asked, session_.show.stage(), shown());
  if (dress(rules)) messages().say("Read " + whole_path(rules->file));
}

bool FileRequests::dress(const Result<SetRules>& rules) {
  if (!rules) return messages().say(rules.error().message, Message::Kind::refused), false;
  if (!session_.editor.take(*rules)) return false;
  session_.reporter.describe_character(session_.show, shown());
  return true;
}

void FileRequests::carry_out(const SaveRoles&) { say_where(save_roles(character())); }
void FileRequests::carry_out(const SaveBody&) { say_where(save_rig(character())); }
void FileRequests::carry_out(const SaveBones&) { say_where(save_bone_lod(character())); }
void FileRequests::carry_out(const ExportLod&) { say_where(export_lod(session_.show, shown())); }

void FileRequests::say_where(const Result<std::filesystem::path>& written) {
  if (written) return messages().say("Wrote " + whole_path(*written));
  messages().say(written.error().message, Message::Kind::refused);
}

}  // namespace throng::app
