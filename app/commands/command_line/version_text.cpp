#include "app/commands/command_line/version_text.h"

#include <string_view>

#include "throng/render/context.h"

#include "app/files/program_version.h"
#include "app/output/regression/origin.h"
#include "engine/anim/kernel/kernels.h"
#include "engine/base/files/child_process.h"
#include "engine/base/text/joined.h"
#include "engine/base/text/plain_text.h"

namespace throng::app {
namespace {

constexpr unsigned most_seconds = 5;

std::string simd_line() {
  return joined(anim::compiled_targets()) + "; this machine takes " + anim::best_kernels().target;
}

std::string contexts_line() {
  return std::string("window, egl") + (render::gl::osmesa_is_installed() ? ", osmesa" : "; osmesa is not installed");
}

/// Runs in the child.
std::string ask_driver() {
  auto context = render::gl::make_egl_context({.force_software = true});
  if (!context) return "none; " + context.error().message;
  const std::string version = mesa_version((*context)->version());
  return (version.empty() ? (*context)->version() : version) + ", " + (*context)->renderer();
}

std::string mesa_line() {
  const std::string said = ask_in_child(ask_driver, most_seconds);
  return said.empty() ? "unknown; the driver of EGL's software device did not answer" : plain_text(said);
}

std::string ffmpeg_line() {
  const auto ended = run_child({"ffmpeg", "-version"}, {.seconds = most_seconds});
  if (!ended) return "not installed";
  constexpr std::string_view before = "ffmpeg version ";
  if (ended->status != 0 || !ended->output.starts_with(before)) return "unknown; it does not say its version";
  const std::size_t end = ended->output.find_first_of(" \n", before.size());
  return plain_text(ended->output.substr(before.size(), end - before.size()));
}

}  // namespace

std::string version_text() {
  return "throng " + program_version() + "\ncommit: " + program_commit() + "\nSIMD: " + simd_line() +
         "\ncontexts: " + contexts_line() + "\nMesa: " + mesa_line() + "\nffmpeg: " + ffmpeg_line() + "\n";
}

}  // namespace throng::app
