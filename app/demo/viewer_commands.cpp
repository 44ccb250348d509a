#include "app/demo/viewer_commands.h"

namespace throng::app {
namespace {

anim::Status view_selected(Show& show) {
  const auto selected = show.stage().selected();
  if (!selected) return anim::Done{};
  const std::size_t character = show.stage().crowd().characters()[*selected];
  if (character >= show.stage().people().size()) return anim::Error{"a thing is not shown alone, only a character is"};
  return show.view({.character = character, .agent = selected});
}

void apply_preview(Show& show) {
  const std::size_t character = show.viewer()->character();
  const auto preview = show.viewer()->preview();
  if (!preview) return;
  RoleClips clips = show.stage().characters()[character].roles.clips;
  clips[index_of(preview->role)] = preview->clip;
  show.leave_viewer();
  show.set_roles(character, clips);
}

}  // namespace

anim::Status obey_viewer(Show& show, const ViewerCommands& commands) {
  if (commands.view_selected) return view_selected(show);
  if (commands.view) return show.view(*commands.view);
  if (show.viewer() == nullptr) return anim::Done{};
  if (commands.settings) show.viewer()->choose(*commands.settings);
  if (commands.scrub) show.viewer()->scrub(*commands.scrub);
  if (commands.face_front) show.viewer()->turntable().face_front();
  if (commands.apply_preview) {
    apply_preview(show);
  } else if (commands.leave) {
    show.leave_viewer();
  }
  return anim::Done{};
}

}  // namespace throng::app
