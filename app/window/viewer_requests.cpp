#include "app/window/viewer_requests.h"

#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "app/show/viewer/viewer.h"

namespace throng::app {
namespace {

Status carry_out(const View& view, Show& show) { return show.open_viewer(view.what); }
Status carry_out(const ViewSelected&, Show& show) {
  const auto selected = show.stage().selected();
  if (!selected) return Done{};
  const std::size_t character = show.stage().crowd().characters()[*selected];
  if (character >= show.stage().people().size()) return Error{"a thing is not shown alone, only a character is"};
  return show.open_viewer({.character = character, .agent = selected});
}
Status carry_out(const LeaveViewer&, Show& show) { return show.leave_viewer(), Done{}; }
// The caller makes a request of it.
Status carry_out(const ApplyPreview&, Show& show) { return show.leave_viewer(), Done{}; }

void change(const SetViewer& asked, Viewer& viewer) { viewer.choose(asked.settings); }
void change(const ScrubViewer& asked, Viewer& viewer) { viewer.scrub(asked.seconds); }
void change(const FaceFront&, Viewer& viewer) { viewer.turntable().face_front(); }
template <typename OfViewer>
Status carry_out(const OfViewer& asked, Show& show) {
  if (show.viewer() != nullptr) change(asked, *show.viewer());
  return Done{};
}

}  // namespace

std::optional<SetRoles> previewed_roles(const Show& show) {
  const auto preview = show.viewer() != nullptr ? show.viewer()->preview() : std::nullopt;
  if (!preview) return {};
  const std::size_t character = show.viewer()->character();
  RoleClips clips = show.stage().characters()[character].roles.clips;
  clips[index_of(preview->role)] = preview->clip;
  return SetRoles{static_cast<CharacterNumber>(character), clips};
}

Status take(const ViewerRequest& request, Show& show) {
  return std::visit([&](const auto& asked) { return carry_out(asked, show); }, request);
}

}  // namespace throng::app
