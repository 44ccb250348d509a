#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/render/shader/shader_library.h"

namespace throng::render {

/// A program that is built once for each set of switches, which are macros that its files ask for (#ifdef). A processor
/// that draws computes both sides of a branch, so code that a picture does not need must not be in its program.
class ProgramVariants {
 public:
  /// Builds the variant without any switch. `shaders` must outlive this object.
  ProgramVariants(ShaderLibrary& shaders, ProgramFiles files, std::vector<std::string> switches);

  /// Returns the variant that has the switches whose bits are set, counted from the first. Builds it at the first call;
  /// the status of the library says whether that went well.
  const gl::Program& with(std::uint32_t bits);

 private:
  ShaderLibrary* shaders_;
  ProgramFiles files_;
  std::vector<std::string> switches_;
  std::vector<const gl::Program*> built_;  // [bits]; null until it is asked for
};

}  // namespace throng::render
