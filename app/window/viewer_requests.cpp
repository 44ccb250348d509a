#include "app/window/viewer_requests.h"

#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "app/show/viewer/viewer.h"

namespace throng::app {
namespace {

class ViewerTaker {
 public:
  explicit ViewerTaker(Show& show) : show_(show) {}

  anim::Status take(const View& view) const { return show_.open_viewer(view.what); }
  anim::Status take(const ViewSelected&) const {
    const auto selected = show_.stage().selected();
    if (!selected) return anim::Done{};
    const std::size_t character = show_.stage().crowd().characters()[*selected];
    if (character >= show_.stage().people().size())
      return anim::Error{"a thing is not shown alone, only a character is"};
    return show_.open_viewer({.character = character, .agent = selected});
  }
  anim::Status take(const LeaveViewer&) const { return show_.leave_viewer(), anim::Done{}; }
  anim::Status take(const SetViewer& asked) const {
    if (show_.viewer() != nullptr) show_.viewer()->choose(asked.settings);
    return anim::Done{};
  }
  anim::Status take(const ScrubViewer& asked) const {
    if (show_.viewer() != nullptr) show_.viewer()->scrub(asked.seconds);
    return anim::Done{};
  }
  anim::Status take(const FaceFront&) const {
    if (show_.viewer() != nullptr) show_.viewer()->turntable().face_front();
    return anim::Done{};
  }
  // The caller makes a request of it.
  anim::Status take(const ApplyPreview&) const { return take(LeaveViewer{}); }

 private:
  Show& show_;
};

}  // namespace

std::optional<SetRoles> previewed_roles(const Show& show) {
  const auto preview = show.viewer() != nullptr ? show.viewer()->preview() : std::nullopt;
  if (!preview) return {};
  const std::size_t character = show.viewer()->character();
  RoleClips clips = show.stage().characters()[character].roles.clips;
  clips[index_of(preview->role)] = preview->clip;
  return SetRoles{static_cast<CharacterNumber>(character), clips};
}

anim::Status take(const ViewerRequest& request, Show& show) {
  return std::visit([&](const auto& asked) { return ViewerTaker(show).take(asked); }, request);
}

}  // namespace throng::app
