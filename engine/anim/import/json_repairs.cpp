#include "engine/anim/import/json_repairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "engine/anim/import/json_document.h"

namespace throng::import {

namespace {

using nlohmann::json;

std::string number_text(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", number);
  return text.data();
}

/// A rotation of length 0 stays, and is refused later.
void normalise_rotation(json& node, const std::string& name, std::vector<std::string>& repairs) {
  constexpr double tolerance = 5e-3;  // the error of rounding to three digits
  const auto rotation = node.find("rotation");
  if (rotation == node.end()) return;
  double largest = 0.0, squares = 0.0;
  for (const json& part : *rotation) largest = std::max(largest, std::abs(part.get<double>()));
  if (!(largest > 0.0)) return;
  for (const json& part : *rotation) {
    const double share = part.get<double>() / largest;  // its square is finite
    squares += share * share;
  }
  const double length = largest * std::sqrt(squares);
  if (std::abs(length - 1.0) <= tolerance) return;
  for (json& part : *rotation) part = part.get<double>() / length;
  repairs.push_back(name + ": its rotation has length " + number_text(length) + ", normalised");
}

void mend_last_row(json& node, const std::string& name, std::vector<std::string>& repairs) {
  const auto matrix = node.find("matrix");
  if (matrix == node.end()) return;
  bool mended = false;
  for (std::size_t column = 0; column < 4; ++column) {
    json& last = (*matrix)[column * 4 + 3];
    const double right = column == 3 ? 1.0 : 0.0;
    mended = mended || last.get<double>() != right;
    last = right;
  }
  if (mended) repairs.push_back(name + ": the last row of its matrix became 0, 0, 0, 1");
}

std::vector<std::int64_t> parents_of(const json& nodes) {
  std::vector<std::int64_t> parents(nodes.size(), -1);
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    for (const json& child : nodes[node].value("children", json::array())) {
      parents[child.get<std::size_t>()] = static_cast<std::int64_t>(node);
    }
  }
  return parents;
}

void name_children_in_scenes(const json& document, std::vector<std::string>& repairs) {
  const json& nodes = array_of(document, "nodes");
  const std::vector<std::int64_t> parents = parents_of(nodes);
  std::size_t index = 0;
  for (const json& scene : array_of(document, "scenes")) {
    const std::string name = json_label("scene", index++, scene);
    for (const json& root : scene.value("nodes", json::array())) {
      const auto node = root.get<std::size_t>();
      if (parents[node] < 0) continue;
      const auto parent = static_cast<std::size_t>(parents[node]);
      repairs.push_back(name + ": names " + json_label("node", node, nodes[node]) + ", a child of " +
                        json_label("node", parent, nodes[parent]) + "; taken where its parents place it");
    }
  }
}

}  // namespace

void repair_json(json& document, std::vector<std::string>& repairs) {
  name_children_in_scenes(document, repairs);
  std::size_t index = 0;
  for (json& node : elements(document, "nodes")) {
    const std::string name = json_label("node", index++, node);
    normalise_rotation(node, name, repairs);
    mend_last_row(node, name, repairs);
  }
}

}  // namespace throng::import
