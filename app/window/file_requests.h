#pragma once

#include <filesystem>

#include "app/show/request/crowd_file.h"
#include "app/show/request/request.h"
#include "app/window/panel/overlay.h"
#include "app/window/window_session.h"

namespace throng::app {

/// Reads and writes the files that a person asks for in the panel, and says what came of it.
class FileRequests {
 public:
  FileRequests(WindowSession& session, Overlay& overlay) : session_(session), overlay_(overlay) {}

  void take(const FileRequest& request);
  /// Describes all that is open, as a crowd file holds it.
  CrowdSetup described_here() const;
  /// Opens a crowd file: all that described_here() told when it was saved.
  void open_crowd(const std::filesystem::path& file);
  /// Takes the parts of a crowd file that only a window keeps: the tunings to compare, and the bookmarks of the camera.
  void take_kept(const CrowdSetup& setup);

 private:
  void carry_out(const SavePreset& asked);
  void carry_out(const LoadPreset& asked);
  void carry_out(const DeletePreset& asked);
  void carry_out(const LoadIntoOther& asked);
  void carry_out(const SaveCrowd& asked);
  void carry_out(const OpenCrowd& asked);
  void carry_out(const SaveRules& asked);
  void carry_out(const LoadRules& asked);
  void carry_out(const SaveRoles& asked);
  void carry_out(const SaveBody& asked);
  void carry_out(const SaveBones& asked);
  void carry_out(const ExportLod& asked);
  void take(const Preset& preset);
  /// Notes that this crowd file has all that the person works on.
  void keep(const std::filesystem::path& file, const TuningPair& pair);
  void say_where(const Result<std::filesystem::path>& written);
  bool dress(const Result<SetRules>& rules);
  CharacterNumber shown() const { return session_.reporter.report().character; }
  const CharacterSource& character() const;
  Messages& messages() { return session_.messages(); }

  WindowSession& session_;
  Overlay& overlay_;
};

}  // namespace throng::app
