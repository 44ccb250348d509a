#include "engine/anim/import/accessor_reader.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <string>

#include "engine/anim/import/accessor_checks.h"
#include "engine/anim/import/refusal.h"

namespace throng::import {

namespace {

using Bytes = std::span<const std::byte>;

template <typename Component>
Component load(const std::byte* bytes) {
  Component value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

template <typename Component>
double normalise(Component value) {
  return std::max(static_cast<double>(value) / static_cast<double>(std::numeric_limits<Component>::max()), -1.0);
}

template <typename Component>
double convert(const std::byte* bytes, bool normalised) {
  const auto value = load<Component>(bytes);
  return normalised ? normalise(value) : static_cast<double>(value);
}

double read_component(const std::byte* bytes, int component_type, bool normalised) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return convert<std::int8_t>(bytes, normalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return convert<std::uint8_t>(bytes, normalised);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return convert<std::int16_t>(bytes, normalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return convert<std::uint16_t>(bytes, normalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return static_cast<double>(load<std::uint32_t>(bytes));
    default:
      return static_cast<double>(load<float>(bytes));
  }
}

template <typename Value>
class Reader {
 public:
  Reader(const Document& document, int index, const AccessorRule& rule)
      : document_(document),
        accessor_(accessor_at(document, index)),
        width_(element_width(accessor_)),
        name_(rule.what + ", " + label("accessor", static_cast<std::size_t>(index), accessor_.name)) {
    if (std::ranges::find(rule.types, accessor_.type) == rule.types.end()) refuse("has the wrong type");
    if (std::ranges::find(rule.components, accessor_.componentType) == rule.components.end()) {
      refuse("has the wrong component type");
    }
    const bool integer = accessor_.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT;
    if (integer && !rule.raw && !accessor_.normalized) refuse("has integers that are not marked as normalized");
  }

  std::vector<Value> read(std::size_t limit) {
    const std::size_t count = std::min(accessor_.count, limit);
    if (accessor_.bufferView < 0 && count > max_elements_without_view) {
      refuse("asks for " + std::to_string(accessor_.count) + " elements, but has no buffer view");
    }
    if (count > (max_decoded_values - document_.decoded_values) / width_) {
      refuse("brings the file's data to more than " + std::to_string(max_decoded_values) + " numbers");
    }
    document_.decoded_values += count * width_;
    values_.assign(count * width_, Value{});
    if (accessor_.bufferView >= 0) read_dense(count);
    if (accessor_.sparse.isSparse) read_sparse();
    return std::move(values_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw Refusal(name_ + ": " + what + "; export the file again");
  }

  Bytes view(int index) const { return document_.buffer_views.views[static_cast<std::size_t>(index)]; }

  void read_element(const std::byte* from, std::size_t element) {
    for (std::size_t component = 0; component < width_; ++component) {
      const double value =
          read_component(from + component_offset(accessor_, component), accessor_.componentType, accessor_.normalized);
      values_[element * width_ + component] = static_cast<Value>(value);
    }
  }

  void read_dense(std::size_t count) {
    const std::size_t stride = document_.gltf.bufferViews[static_cast<std::size_t>(accessor_.bufferView)].byteStride;
    const std::size_t step = stride != 0 ? stride : element_size(accessor_);
    const std::byte* from = view(accessor_.bufferView).data() + accessor_.byteOffset;
    for (std::size_t element = 0; element < count; ++element) read_element(from + element * step, element);
  }

  void read_sparse() {
    const auto& sparse = accessor_.sparse;
    const std::size_t index_size = component_size(sparse.indices.componentType);
    const std::byte* indices = view(sparse.indices.bufferView).data() + sparse.indices.byteOffset;
    const std::byte* values = view(sparse.values.bufferView).data() + sparse.values.byteOffset;
    for (std::size_t i = 0; i < static_cast<std::size_t>(sparse.count); ++i) {
      const auto element =
          static_cast<std::size_t>(read_component(indices + i * index_size, sparse.indices.componentType, false));
      if (element >= accessor_.count) refuse("sparse index " + std::to_string(element) + " is out of range");
      if (element * width_ < values_.size()) read_element(values + i * element_size(accessor_), element);
    }
  }

  const Document& document_;
  const tinygltf::Accessor& accessor_;
  std::size_t width_;
  std::string name_;
  std::vector<Value> values_;
};

}  // namespace

std::vector<float> read_floats(const Document& document, int accessor, const AccessorRule& rule, std::size_t limit) {
  return Reader<float>(document, accessor, rule).read(limit);
}

std::vector<std::uint32_t> read_integers(const Document& document, int accessor, const AccessorRule& rule) {
  return Reader<std::uint32_t>(document, accessor, rule).read(SIZE_MAX);
}

const tinygltf::Accessor& accessor_at(const Document& document, int accessor) {
  return document.gltf.accessors[static_cast<std::size_t>(accessor)];
}

}  // namespace throng::import
