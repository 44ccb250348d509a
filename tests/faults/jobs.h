#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace throng::test {

/// A run of the program that loads, works, saves and quits.
struct Job {
  std::string name;
  std::vector<std::string> arguments;
  std::vector<std::filesystem::path> outputs;  ///< files that it writes
};

/// Returns a job for each way in which the program reads and writes, small enough to be run a thousand times. Makes
/// their model in `folder`: a .gltf with a buffer and a picture beside it.
std::vector<Job> jobs_in(const std::filesystem::path& folder);

}  // namespace throng::test
