#include "engine/anim/import/accessor_checks.h"

#include <cstdint>
#include <limits>

#include "engine/anim/import/refusal.h"

namespace throng::import {

namespace {

std::size_t matrix_rows(int type) {
  switch (type) {
    case TINYGLTF_TYPE_MAT2:
      return 2;
    case TINYGLTF_TYPE_MAT3:
      return 3;
    case TINYGLTF_TYPE_MAT4:
      return 4;
    default:
      return 0;
  }
}

/// Says whether `count` elements of `size` bytes, `stride` apart, from `offset` on, lie inside `available` bytes.
bool fits(std::size_t available, std::size_t offset, std::size_t count, std::size_t stride, std::size_t size) {
  if (count == 0) return offset <= available;
  if (offset > available || size > available - offset) return false;
  return count - 1 <= (available - offset - size) / stride;
}

class AccessorCheck {
 public:
  AccessorCheck(const Document& document, std::size_t index)
      : document_(document),
        accessor_(document.gltf.accessors[index]),
        name_(label("accessor", index, accessor_.name)) {}

  void run() const {
    if (component_size(accessor_.componentType) == 0) refuse("component type is unknown");
    if (accessor_.count == 0) refuse("has no elements");
    if (accessor_.bufferView >= 0) check_view();
    if (accessor_.sparse.isSparse) check_sparse();
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw Refusal(name_ + ": " + what + "; export the file again");
  }

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
    const bool is_index = sparse.indices.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                          sparse.indices.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                          sparse.indices.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    if (!is_index) refuse("its sparse indices are no unsigned integers");
    if (sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0) refuse("a sparse offset is out of range");
    if (!fits(view_size(sparse.indices.bufferView), static_cast<std::size_t>(sparse.indices.byteOffset), count,
              index_size, index_size)) {
      refuse("its sparse indices do not fit into their buffer view");
    }
    const std::size_t size = element_size(accessor_);
    if (!fits(view_size(sparse.values.bufferView), static_cast<std::size_t>(sparse.values.byteOffset), count, size,
              size)) {
      refuse("its sparse values do not fit into their buffer view");
    }
  }

  const Document& document_;
  const tinygltf::Accessor& accessor_;
  std::string name_;
};

}  // namespace

void check_accessors(const Document& document) {
  for (std::size_t index = 0; index < document.gltf.accessors.size(); ++index) AccessorCheck(document, index).run();
}

std::size_t component_size(int component_type) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

std::size_t element_width(const tinygltf::Accessor& accessor) {
  return static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
}

std::size_t component_offset(const tinygltf::Accessor& accessor, std::size_t component) {
  const std::size_t size = component_size(accessor.componentType);
  const std::size_t rows = matrix_rows(accessor.type);
  if (rows == 0) return component * size;
  const std::size_t column_pitch = (rows * size + 3) / 4 * 4;
  return component / rows * column_pitch + component % rows * size;
}

std::size_t element_size(const tinygltf::Accessor& accessor) {
  const std::size_t rows = matrix_rows(accessor.type);
  if (rows == 0) return element_width(accessor) * component_size(accessor.componentType);
  return component_offset(accessor, rows * rows - rows) + (rows * component_size(accessor.componentType) + 3) / 4 * 4;
}

}  // namespace throng::import
