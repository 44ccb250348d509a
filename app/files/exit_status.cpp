#include "app/files/exit_status.h"

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <system_error>

#include <sys/resource.h>
#include <unistd.h>

#include "engine/anim/base/plain_text.h"

namespace throng::app {
namespace {

/// Needs no memory, which there may be none of, and runs no destructor, since threads may be at work.
[[noreturn]] void end_at_once() {
  const auto say = [](std::string_view text) {
    [[maybe_unused]] const auto written = write(STDERR_FILENO, text.data(), text.size());
  };
  say("throng: ");
  say(std::current_exception() ? sentence_of_failure() : "a part of it failed that must not; please report it");
  say("\n");
  _exit(exit_job_failed);
}

bool memory_has_a_limit() {
  rlimit limit{};
  return getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

}  // namespace

int end_with(ExitStatus status, std::string_view sentence) {
  std::fprintf(stderr, "throng: %s\n", anim::plain_text(sentence).c_str());
  return status;
}

std::string_view sentence_of_failure() {
  static char text[512];
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return memory_has_a_limit() ? "no memory is left of what this process may take; raise the limit (ulimit -v)"
                                : "the machine has no memory left; ask for fewer agents or smaller models";
  } catch (const std::length_error&) {
    return "the machine has not as much memory as this takes; ask for fewer agents or smaller models";
  } catch (const std::system_error& error) {
    std::snprintf(text, sizeof(text), "the system refuses: %s", error.what());
  } catch (const std::exception& error) {
    std::snprintf(text, sizeof(text), "%s", error.what());
  } catch (...) {
    return "something failed without a reason; please report it";
  }
  return text;
}

void end_in_words() {
  std::set_terminate(end_at_once);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace throng::app
