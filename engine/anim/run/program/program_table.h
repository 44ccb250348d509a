#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/anim/run/program/pose_program.h"

namespace throng::anim {

/// The programs of one skeleton, each once, however many agents run it. A crowd has few graphs that look different, so
/// a frame finds programs in L1. Two graphs look alike if they have the same program. Programs stay until the table
/// goes. A new program seldom allocates, since graphs change in the frame.
class ProgramTable {
 public:
  ProgramTable();

  /// Returns memory to write a program in.
  PoseProgram& draft() { return draft_; }
  /// Returns the program that is equal to the written one. Keeps the written program if there was none.
  const PoseProgram& same_as_draft();
  std::size_t size() const { return hashes_.size(); }

 private:
  void add_unused();

  PoseProgram draft_;
  std::vector<std::uint64_t> hashes_;                   // [program], beside each other since all are looked through
  std::vector<std::unique_ptr<PoseProgram>> programs_;  // they stay where they are; the last ones are not used yet
};

}  // namespace throng::anim
