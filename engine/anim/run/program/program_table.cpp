#include "engine/anim/run/program/program_table.h"

#include <array>
#include <bit>

#include "engine/base/hash.h"

namespace throng::anim {
namespace {

constexpr std::size_t usual_programs = 64;
constexpr std::size_t steps_to_reserve = 16;

/// Hashes the steps; the rest of a program nearly always follows from them.
std::uint64_t hash_of(const PoseProgram& program) {
  std::uint64_t hash = 0;
  for (const PoseStep& step : program.steps) {
    for (const std::uint64_t half : std::bit_cast<std::array<std::uint64_t, 2>>(step)) hash = chain_hash(hash, half);
  }
  return hash;
}

}  // namespace

ProgramTable::ProgramTable() {
  draft_.steps.reserve(PoseProgram::max_steps);
  hashes_.reserve(usual_programs);
  programs_.reserve(usual_programs);
  while (programs_.size() < usual_programs) add_unused();
}

void ProgramTable::add_unused() {
  programs_.push_back(std::make_unique<PoseProgram>());
  programs_.back()->steps.reserve(steps_to_reserve);
}

const PoseProgram& ProgramTable::same_as_draft() {
  const std::uint64_t hash = hash_of(draft_);
  for (std::size_t i = 0; i < hashes_.size(); ++i) {
    if (hashes_[i] == hash && *programs_[i] == draft_) return *programs_[i];
  }
  if (hashes_.size() == programs_.size()) add_unused();
  PoseProgram& program = *programs_[hashes_.size()];
  program = draft_;
  hashes_.push_back(hash);
  return program;
}

}  // namespace throng::anim
