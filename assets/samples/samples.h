#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace throng::samples {

/// Returns a binary glTF file of a robot: boxes on the mannequin's skeleton, with four of its clips.
std::vector<std::byte> make_robot();

/// Returns the rows of two streams of people who cross, as text of the Jülich archive.
std::string make_crossing();
/// Returns the floor on which they cross, as Well-Known Text.
std::string crossing_floor();

}  // namespace throng::samples
