#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/house/house_rules.h"

namespace throng::house {

/// A public function for C++, and the functions for C that do what it does. `why` is a sentence where one side is
/// empty.
struct CoverageRow {
  std::string cpp;  ///< "Class::function" or "function"; its overloads share a row
  std::vector<std::string> c;
  std::string why = {};
};

/// Returns what C has of the public headers of the animation library, and what it leaves out.
const std::vector<CoverageRow>& c_table();

/// Holds the table against the public headers, and finds: functions of either language in no row; rows that name a
/// function that there is not; rows with an empty side and no reason. Constructors, operators and functions that
/// THRONG_DEFAULT declares need no row.
Findings c_coverage_gaps(const Tree& tree, const std::vector<CoverageRow>& table);

/// A struct of the public headers, and the struct for C that has its members. `renamed` has the names of C for members
/// that are called otherwise there.
struct CStructRow {
  std::string cpp, c;
  std::map<std::string, std::string> renamed = {};
};

const std::vector<CStructRow>& c_structs();

/// Finds structs of the table that there are not, and their members that C lacks.
Findings c_struct_gaps(const Tree& tree, const std::vector<CStructRow>& table);

}  // namespace throng::house
