#pragma once

#include <stdexcept>
#include <string>

namespace throng::import {

/// Says why a file is refused, in a sentence without the file's name. It travels up inside of import and ends at
/// import_file, which puts the file's name before it.
class Refusal : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Refuses a file because of one of its objects, of which `object` is the name. Only another export mends it.
[[noreturn]] inline void refuse(const std::string& object, const std::string& what) {
  throw Refusal(object + ": " + what + "; export the file again");
}

}  // namespace throng::import
