#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace throng::app {

/// What a sweep found, for a person, for programs, and drawn (empty: there is nothing to draw).
struct BenchReport {
  std::string text;
  nlohmann::ordered_json json;
  std::string plot;
};

}  // namespace throng::app
