#pragma once

#include <string>
#include <vector>

namespace throng::house {

/// The rooms of a tree from the ground up; rooms of one floor do not see each other.
struct House {
  std::string folder;  ///< the folder that the tree lies in; ends in a slash
  std::vector<std::vector<std::string>> floors;
};

/// Returns the houses: the libraries of the engine that have rooms, and app.
const std::vector<House>& houses();

/// Returns whether a file at `from` may not include `to`, since that lies no lower, or is a room that is not planned.
/// Files of other trees and those that lie in no room may include each other.
bool climbs(const House& house, const std::string& from, const std::string& to);

}  // namespace throng::house
