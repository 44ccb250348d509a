#include "app/files/program_version.h"

namespace throng::app {
namespace {

const char* built_commit = "unknown";

}  // namespace

void set_program_commit(const char* commit) { built_commit = commit; }
std::string program_version() { return THRONG_VERSION; }
std::string program_commit() { return built_commit; }

}  // namespace throng::app
