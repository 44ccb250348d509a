#pragma once

#include <memory>
#include <span>

#include "app/commands/bench/case.h"
#include "engine/base/result.h"
#include "tests/benchmark/programs/library_subject.h"

namespace throng::app {

/// A crowd whose clips the Animation Compression Library (ACL) keeps and samples. It does no more than that, so what
/// follows a sampling is ours, written with RTM, the library that it does its own vectors with.
class AclSubject : public LibrarySubject {
 public:
  /// Samples both clips of every agent, 1/60 s after the last time, and does nothing with them.
  virtual void sample() = 0;

 protected:
  using LibrarySubject::LibrarySubject;
};

/// Makes the subject. Errors: no ACL was installed when this was built, or has_local_clips() says no.
Result<std::unique_ptr<AclSubject>> make_acl_subject(const BenchCharacter& whom, std::span<const BenchAgent> agents,
                                                     const BenchPalettes& palettes);

}  // namespace throng::app
