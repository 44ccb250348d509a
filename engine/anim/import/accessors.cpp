#include "engine/anim/import/accessors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/anim/import/bytes/refusal.h"

namespace throng::import {

namespace {

std::size_t matrix_rows(int type) {
  if (type == TINYGLTF_TYPE_MAT2) return 2;
  if (type == TINYGLTF_TYPE_MAT3) return 3;
  return type == TINYGLTF_TYPE_MAT4 ? 4 : 0;
}

/// Returns the numbers in one element: 1 to 16.
std::size_t element_width(const tinygltf::Accessor& accessor) {
  return static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
}

/// Returns the byte offset of a number in its element. Columns of small matrices start on 4-byte boundaries (glTF 2.0,
/// 3.6.2.4).
std::size_t component_offset(const tinygltf::Accessor& accessor, std::size_t component) {
  const std::size_t size = component_size(accessor.componentType);
  const std::size_t rows = matrix_rows(accessor.type);
  if (rows == 0) return component * size;
  const std::size_t column_pitch = (rows * size + 3) / 4 * 4;
  return component / rows * column_pitch + component % rows * size;
}

/// Returns the bytes of one element, without padding after it.
std::size_t element_size(const tinygltf::Accessor& accessor) {
  const std::size_t rows = matrix_rows(accessor.type);
  if (rows == 0) return element_width(accessor) * component_size(accessor.componentType);
  return component_offset(accessor, rows * rows - rows) + (rows * component_size(accessor.componentType) + 3) / 4 * 4;
}

/// Says whether `count` elements of `size` bytes, `stride` apart, from `offset` on, lie inside `available` bytes.
bool fits(std::size_t available, std::size_t offset, std::size_t count, std::size_t stride, std::size_t size) {
  if (count == 0) return offset <= available;
  if (offset > available || size > available - offset) return false;
  return count - 1 <= (available - offset - size) / stride;
}

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

/// Returns the element that the sparse value `i` replaces. The indices lie inside their view.
std::size_t sparse_index(const Document& document, const tinygltf::Accessor& accessor, std::size_t i) {
  const auto& indices = accessor.sparse.indices;
  const std::byte* from = document.buffer_views.views[static_cast<std::size_t>(indices.bufferView)].data() +
                          static_cast<std::size_t>(indices.byteOffset);
  const std::size_t size = component_size(indices.componentType);
  return static_cast<std::size_t>(read_component(from + i * size, indices.componentType, false));
}

class AccessorCheck {
 public:
  AccessorCheck(Document& document, std::size_t index)
      : document_(document),
        accessor_(document.gltf.accessors[index]),
        name_(label("accessor", index, accessor_.name)) {}

  /// A component type that only an extension knows is refused where something reads it.
  void run() const {
    if (component_size(accessor_.componentType) == 0) return;
    if (accessor_.count == 0) refuse("has no elements");
    if (accessor_.bufferView >= 0) check_view();
    if (accessor_.sparse.isSparse) check_sparse();
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const { import::refuse(name_, what); }

  std::size_t view_size(int view) const { return document_.buffer_views.views[static_cast<std::size_t>(view)].size(); }

  void check_view() const {
    const auto view = static_cast<std::size_t>(accessor_.bufferView);
    const std::size_t size = element_size(accessor_);
    const std::size_t stride = document_.gltf.bufferViews[view].byteStride;
    if (stride != 0 && stride < size) refuse("its elements are larger than the stride of their buffer view");
    if (!fits(view_size(accessor_.bufferView), accessor_.byteOffset, accessor_.count, stride != 0 ? stride : size,
              size)) {
      refuse(std::to_string(accessor_.count) + " elements do not fit into buffer view " + std::to_string(view));
    }
  }

  void check_sparse() const {
    const auto& sparse = accessor_.sparse;
    const auto count = static_cast<std::size_t>(sparse.count);
    if (sparse.count < 1 || count > accessor_.count) refuse("has more sparse elements than elements");
    const std::size_t index_size = component_size(sparse.indices.componentType);
    if (std::ranges::find(any_unsigned, sparse.indices.componentType) == any_unsigned.end()) {
      refuse("its sparse indices are no unsigned integers");
    }
    if (!std::in_range<std::size_t>(sparse.indices.byteOffset) ||
        !std::in_range<std::size_t>(sparse.values.byteOffset)) {
      refuse("a sparse offset is out of range");
    }
    if (!fits(view_size(sparse.indices.bufferView), static_cast<std::size_t>(sparse.indices.byteOffset), count,
              index_size, index_size)) {
      refuse("its sparse indices do not fit into their buffer view");
    }
    const std::size_t size = element_size(accessor_);
    if (!fits(view_size(sparse.values.bufferView), static_cast<std::size_t>(sparse.values.byteOffset), count, size,
              size)) {
      refuse("its sparse values do not fit into their buffer view");
    }
    check_sparse_order();
  }

  /// Every value goes where its index says, the last of equal ones wins.
  void check_sparse_order() const {
    const auto count = static_cast<std::size_t>(accessor_.sparse.count);
    std::size_t descents = 0;
    for (std::size_t i = 1; i < count; ++i) {
      if (sparse_index(document_, accessor_, i) <= sparse_index(document_, accessor_, i - 1)) ++descents;
    }
    if (descents == 0) return;
    document_.repairs.push_back(name_ + ": " + std::to_string(descents) +
                                " of its sparse indices do not ascend, taken in the file's order");
  }

  Document& document_;
  const tinygltf::Accessor& accessor_;
  std::string name_;
};

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
    document_.memory->charge(count * width_ * sizeof(Value), name_);
    values_.assign(count * width_, Value{});
    if (accessor_.bufferView >= 0) read_dense(count);
    if (accessor_.sparse.isSparse) read_sparse();
    return std::move(values_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const { import::refuse(name_, what); }

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
    const std::byte* values = view(sparse.values.bufferView).data() + sparse.values.byteOffset;
    for (std::size_t i = 0; i < static_cast<std::size_t>(sparse.count); ++i) {
      const std::size_t element = sparse_index(document_, accessor_, i);
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

std::size_t component_size(int component_type) {
  // tinygltf knows two types more than glTF.
  if (component_type == TINYGLTF_COMPONENT_TYPE_INT || component_type == TINYGLTF_COMPONENT_TYPE_DOUBLE) return 0;
  const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(component_type));
  return static_cast<std::size_t>(std::max(size, 0));
}

void check_accessors(Document& document) {
  for (std::size_t index = 0; index < document.gltf.accessors.size(); ++index) AccessorCheck(document, index).run();
}

std::vector<float> read_floats(const Document& document, int accessor, const AccessorRule& rule, std::size_t limit) {
  return Reader<float>(document, accessor, rule).read(limit);
}

std::vector<std::uint32_t> read_integers(const Document& document, int accessor, const AccessorRule& rule) {
  return Reader<std::uint32_t>(document, accessor, rule).read(SIZE_MAX);
}

bool all_finite(std::span<const float> values) {
  return std::ranges::all_of(values, [](float value) { return std::isfinite(value); });
}

const tinygltf::Accessor& accessor_at(const Document& document, int accessor) {
  return document.gltf.accessors[static_cast<std::size_t>(accessor)];
}

}  // namespace throng::import
