#include "engine/render/shader/program_variants.h"

#include <cstddef>
#include <utility>

namespace throng::render {

ProgramVariants::ProgramVariants(ShaderLibrary& shaders, ProgramFiles files, std::vector<std::string> switches)
    : shaders_(&shaders),
      files_(std::move(files)),
      switches_(std::move(switches)),
      built_(std::size_t{1} << switches_.size()) {
  with(0);
}

const gl::Program& ProgramVariants::with(std::uint32_t bits) {
  const gl::Program*& built = built_[bits];
  if (built == nullptr) {
    ProgramFiles files = files_;
    for (std::size_t i = 0; i < switches_.size(); ++i) {
      if ((bits >> i & 1U) != 0) files.switches.push_back(switches_[i]);
    }
    built = &shaders_->load(files);
  }
  return *built;
}

}  // namespace throng::render
