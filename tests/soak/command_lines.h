#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tests/soak/random_values.h"

namespace throng::soak {

/// The models that rounds play with.
struct Models {
  std::string built_in;               ///< the file of the built-in character
  std::vector<std::string> features;  ///< small ones, each with another part of glTF
  std::vector<std::string> broken;    ///< those that are refused, or survive
};
Models find_models();

/// Returns a model, seldom the built-in one.
const std::string& any_model(const Models& models, Random& random);

/// Words of a command line that the parser takes, headless, with any of the demo's options. They write `run.rec`,
/// `stats.json` and other files into the folder in which the program works.
std::vector<std::string> any_demo_line(const Models& models, const std::filesystem::path& folder, Random& random);

/// Returns options that change no pose.
std::vector<std::string> any_scheduling(Random& random);

/// Returns a sentence about an option of the demo for which any_demo_line() has no values; nothing if it has all.
std::optional<std::string> option_left_out();

}  // namespace throng::soak
