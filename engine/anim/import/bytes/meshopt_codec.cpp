#include "engine/anim/import/bytes/meshopt_codec.h"

#include <meshoptimizer.h>

#include "engine/anim/import/bytes/meshopt_attributes.h"
#include "engine/anim/import/bytes/refusal.h"

namespace throng::import {

namespace {

// The densest packing of each codec: an attribute takes at least 2 bits for 16 elements of a byte, a triangle or an
// index at least a byte.
constexpr std::uint64_t attribute_bytes_a_byte = 64;
constexpr std::uint64_t new_attribute_bytes_a_byte = 1024;  // of version 1: 2 bits for 256 elements of a byte
constexpr std::uint64_t indices_a_byte = 3;

void check_element(const MeshoptView& view) {
  const bool attributes = view.mode == "ATTRIBUTES";
  if (!attributes && view.mode != "TRIANGLES" && view.mode != "INDICES") {
    throw Refusal("mode " + view.mode + " is unknown");
  }
  const std::uint64_t stride = view.stride;
  const bool known = attributes ? stride > 0 && stride % 4 == 0 && stride <= 256 : stride == 2 || stride == 4;
  if (!known) throw Refusal("a stride of " + std::to_string(stride) + " bytes is impossible");
  if (view.mode == "TRIANGLES" && view.count % 3 != 0) throw Refusal("its count is no multiple of 3");
}

void check_count(const MeshoptView& view) {
  const bool is_new = is_attribute_stream_v1(view.bytes);
  const std::uint64_t attribute_bytes =
      view.bytes.size() * (is_new ? new_attribute_bytes_a_byte : attribute_bytes_a_byte);
  const std::uint64_t most =
      view.mode == "ATTRIBUTES" ? attribute_bytes / view.stride : view.bytes.size() * indices_a_byte;
  if (view.count == 0 || view.count > most) {
    throw Refusal(std::to_string(view.bytes.size()) + " bytes cannot hold " + std::to_string(view.count) + " elements");
  }
}

void apply_filter(const MeshoptView& view, std::vector<std::byte>& elements) {
  const auto count = static_cast<std::size_t>(view.count);
  const auto stride = static_cast<std::size_t>(view.stride);
  if (view.filter == "NONE") return;
  if (view.filter == "OCTAHEDRAL" && (stride == 4 || stride == 8)) {
    meshopt_decodeFilterOct(elements.data(), count, stride);
  } else if (view.filter == "QUATERNION" && stride == 8) {
    meshopt_decodeFilterQuat(elements.data(), count, stride);
  } else if (view.filter == "EXPONENTIAL") {
    meshopt_decodeFilterExp(elements.data(), count, stride);
  } else if (view.filter == "COLOR" && (stride == 4 || stride == 8)) {
    decode_color_filter(elements, stride);
  } else {
    throw Refusal("filter " + view.filter + " with a stride of " + std::to_string(stride) + " bytes is impossible");
  }
}

int decode_elements(const MeshoptView& view, std::vector<std::byte>& elements) {
  const auto count = static_cast<std::size_t>(view.count);
  const auto stride = static_cast<std::size_t>(view.stride);
  const auto* bytes = reinterpret_cast<const unsigned char*>(view.bytes.data());
  if (view.mode == "ATTRIBUTES" && is_attribute_stream_v1(view.bytes)) {
    decode_attributes_v1(view.bytes, stride, elements);
    return 0;
  }
  if (view.mode == "ATTRIBUTES") {
    return meshopt_decodeVertexBuffer(elements.data(), count, stride, bytes, view.bytes.size());
  }
  if (view.mode == "TRIANGLES") {
    return meshopt_decodeIndexBuffer(elements.data(), count, stride, bytes, view.bytes.size());
  }
  return meshopt_decodeIndexSequence(elements.data(), count, stride, bytes, view.bytes.size());
}

}  // namespace

std::uint64_t decoded_meshopt_size(const MeshoptView& view) {
  check_element(view);
  check_count(view);
  return view.count * view.stride;
}

std::vector<std::byte> decode_meshopt(const MeshoptView& view) {
  std::vector<std::byte> elements(static_cast<std::size_t>(decoded_meshopt_size(view)));
  if (decode_elements(view, elements) != 0) throw Refusal("its bytes do not decode");
  apply_filter(view, elements);
  return elements;
}

}  // namespace throng::import
