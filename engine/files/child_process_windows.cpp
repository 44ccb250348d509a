#if defined(_WIN32)

#include "engine/files/child_process.h"
#include "engine/files/piped_program.h"

namespace throng {

Result<EndedChild> run_child(const std::vector<std::string>& words, const ChildTreatment&) {
  return Error{words.front() + " cannot be run: starting programs is not there on Windows"};
}

std::string ask_in_child(const std::function<std::string()>&, unsigned) { return {}; }

Result<std::string> own_program() { return Error{"starting programs is not there on Windows"}; }

Result<PipedProgram> PipedProgram::start(const std::vector<std::string>&) {
  return Error{"starting programs is not there on Windows"};
}

PipedProgram::PipedProgram(PipedProgram&&) noexcept = default;
PipedProgram::~PipedProgram() = default;
bool PipedProgram::write(std::span<const std::byte>) { return false; }
int PipedProgram::finish() { return -1; }

}  // namespace throng

#endif  // _WIN32
