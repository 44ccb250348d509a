#if defined(_WIN32)

#include "engine/base/files/child_process.h"
#include "engine/base/files/piped_program.h"

namespace throng {
namespace {

constexpr const char* never_starts = "starting programs is not there on Windows";

}  // namespace

Result<EndedChild> run_child(const std::vector<std::string>& words, const ChildTreatment&) {
  return Error{words.front() + " cannot be run: " + never_starts};
}

std::string ask_in_child(const std::function<std::string()>&, unsigned) { return {}; }

Result<std::string> own_program() { return Error{never_starts}; }

Result<PipedProgram> PipedProgram::start(const std::vector<std::string>&) { return Error{never_starts}; }

PipedProgram::PipedProgram(PipedProgram&&) noexcept = default;
PipedProgram::~PipedProgram() = default;
bool PipedProgram::write(std::span<const std::byte>) { return false; }
int PipedProgram::finish() { return -1; }
std::optional<int> PipedProgram::look() { return -1; }
void PipedProgram::ask_to_end() const {}
void PipedProgram::give_way() const {}

}  // namespace throng

#endif  // _WIN32
