#pragma once

#include <string>

namespace throng::app {

/// Keeps the commit that the program was built from, which main() knows. Call it before all else.
void set_program_commit(const char* commit);

/// Returns "1.0.0".
std::string program_version();

/// Returns the commit, which ends in "-dirty" where files had changed since; "unknown" where main() did not say it.
std::string program_commit();

}  // namespace throng::app
