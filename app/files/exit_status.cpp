#include "app/files/exit_status.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>
#include <system_error>

#include "engine/base/files/free_memory.h"
#include "engine/base/files/process.h"
#include "engine/base/text/plain_text.h"

namespace throng::app {
namespace {

/// Needs no memory, for none may be left, and runs no destructor, since threads may be at work.
[[noreturn]] void end_at_once() {
  say_without_memory("throng: ");
  say_without_memory(std::current_exception() ? sentence_of_failure()
                                              : "a part of it failed that must not; please report it");
  say_without_memory("\n");
  std::_Exit(exit_job_failed);
}

}  // namespace

int end_with(ExitStatus status, std::string_view sentence) {
  std::fprintf(stderr, "throng: %s\n", plain_text(sentence).c_str());
  return status;
}

int end_with(const Status& outcome) {
  return outcome ? static_cast<int>(exit_done) : end_with(exit_job_failed, outcome.error().message);
}

std::string_view sentence_of_failure() {
  static char text[512];
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return address_space_has_a_limit() ? "no memory is left of what this process may take; raise the limit (ulimit -v)"
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
  ignore_signals_of_writers();
}

}  // namespace throng::app
