#include "engine/render/mesh/collapse_cost.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace throng::render {
namespace {

using WeightSums = std::vector<std::pair<std::uint16_t, double>>;

void add_weight(WeightSums& sums, std::uint16_t entry, double weight) {
  if (weight == 0.0) return;
  const auto place = std::ranges::lower_bound(sums, entry, {}, &WeightSums::value_type::first);
  if (place != sums.end() && place->first == entry) {
    place->second += weight;
  } else {
    sums.insert(place, {entry, weight});
  }
}

double sum_of(const WeightSums& sums, std::uint16_t entry) {
  const auto place = std::ranges::lower_bound(sums, entry, {}, &WeightSums::value_type::first);
  return place != sums.end() && place->first == entry ? place->second : 0.0;
}

double squared_length(const SkinInfluences& influences) {
  double sum = 0.0;
  for (const float weight : influences.weights) sum += static_cast<double>(weight) * static_cast<double>(weight);
  return sum;
}

}  // namespace

void CollapseCost::add_plane(const glm::dvec3& normal, const glm::dvec3& point, double area) {
  const double d = -glm::dot(normal, point);
  const std::array<double, 6> products = {normal.x * normal.x, normal.x * normal.y, normal.x * normal.z,
                                          normal.y * normal.y, normal.y * normal.z, normal.z * normal.z};
  for (std::size_t i = 0; i < products.size(); ++i) matrix_.at(i) += area * products.at(i);
  vector_ += area * d * normal;
  scalar_ += area * d * d;
  plane_area_ += area;
}

void CollapseCost::add_influences(const SkinInfluences& influences, double area) {
  for (std::size_t i = 0; i < influences.weights.size(); ++i) {
    add_weight(weight_sums_, influences.entries.at(i), area * static_cast<double>(influences.weights.at(i)));
  }
  squared_weights_ += area * squared_length(influences);
  influence_area_ += area;
}

void CollapseCost::add(const CollapseCost& other) {
  for (std::size_t i = 0; i < matrix_.size(); ++i) matrix_.at(i) += other.matrix_.at(i);
  vector_ += other.vector_;
  scalar_ += other.scalar_;
  plane_area_ += other.plane_area_;
  for (const auto& [entry, weight] : other.weight_sums_) add_weight(weight_sums_, entry, weight);
  squared_weights_ += other.squared_weights_;
  influence_area_ += other.influence_area_;
}

double CollapseCost::plane_cost(const glm::dvec3& p) const {
  const auto& [xx, xy, xz, yy, yz, zz] = matrix_;
  const double quadratic =
      xx * p.x * p.x + yy * p.y * p.y + zz * p.z * p.z + 2.0 * (xy * p.x * p.y + xz * p.x * p.z + yz * p.y * p.z);
  return std::max(quadratic + 2.0 * glm::dot(vector_, p) + scalar_, 0.0);
}

double CollapseCost::influence_cost(const SkinInfluences& influences) const {
  double common = 0.0;
  for (std::size_t i = 0; i < influences.weights.size(); ++i) {
    common += static_cast<double>(influences.weights.at(i)) * sum_of(weight_sums_, influences.entries.at(i));
  }
  return std::max(squared_weights_ - 2.0 * common + influence_area_ * squared_length(influences), 0.0);
}

double CollapseCost::squared_distance(const glm::dvec3& point) const {
  return plane_area_ > 0.0 ? plane_cost(point) / plane_area_ : 0.0;
}

double CollapseCost::at(const glm::dvec3& point, const SkinInfluences& influences, double joint_travel) const {
  return plane_cost(point) + joint_travel * joint_travel * influence_cost(influences);
}

void ColorSpread::add(const glm::dvec3& color, double area) {
  sum_ += area * color;
  squares_ += area * glm::dot(color, color);
  area_ += area;
}

void ColorSpread::add(const ColorSpread& other) {
  sum_ += other.sum_;
  squares_ += other.squares_;
  area_ += other.area_;
}

double ColorSpread::at(const glm::dvec3& color) const {
  return std::max(squares_ - 2.0 * glm::dot(sum_, color) + area_ * glm::dot(color, color), 0.0);
}

}  // namespace throng::render
