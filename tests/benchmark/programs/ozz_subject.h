#pragma once

#include <memory>
#include <span>

#include "app/commands/bench/case.h"
#include "engine/base/result.h"
#include "tests/benchmark/programs/library_subject.h"

namespace throng::app {

/// Makes the subject that ozz-animation animates. Errors: no ozz was installed when this was built, or
/// has_local_clips() says no.
Result<std::unique_ptr<LibrarySubject>> make_ozz_subject(const BenchCharacter& whom, std::span<const BenchAgent> agents,
                                                         const BenchPalettes& palettes);

}  // namespace throng::app
