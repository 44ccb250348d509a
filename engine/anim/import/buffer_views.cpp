#include "engine/anim/import/buffer_views.h"

#include <cstdint>
#include <string>

#include <meshoptimizer.h>
#include <nlohmann/json.hpp>

#include "engine/anim/import/refusal.h"
#include "engine/anim/import/source_file.h"

namespace throng::import {

namespace {

using nlohmann::json;
using Bytes = std::span<const std::byte>;

/// A buffer view as EXT_meshopt_compression describes it.
struct MeshoptView {
  Bytes bytes;
  std::uint64_t count = 0;   ///< elements
  std::uint64_t stride = 0;  ///< bytes an element
  std::string mode;          ///< ATTRIBUTES, TRIANGLES, INDICES
  std::string filter;        ///< NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL
};

// The densest packing of each codec: an attribute takes at least 2 bits for 16 elements of a byte, a triangle or an
// index at least a byte.
constexpr std::uint64_t attribute_bytes_a_byte = 64;
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
  const std::uint64_t most = view.mode == "ATTRIBUTES" ? view.bytes.size() * attribute_bytes_a_byte / view.stride
                                                       : view.bytes.size() * indices_a_byte;
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
  } else {
    throw Refusal("filter " + view.filter + " with a stride of " + std::to_string(stride) + " bytes is impossible");
  }
}

int decode_elements(const MeshoptView& view, std::vector<std::byte>& elements) {
  const auto count = static_cast<std::size_t>(view.count);
  const auto stride = static_cast<std::size_t>(view.stride);
  const auto* bytes = reinterpret_cast<const unsigned char*>(view.bytes.data());
  if (view.mode == "ATTRIBUTES") {
    return meshopt_decodeVertexBuffer(elements.data(), count, stride, bytes, view.bytes.size());
  }
  if (view.mode == "TRIANGLES") {
    return meshopt_decodeIndexBuffer(elements.data(), count, stride, bytes, view.bytes.size());
  }
  return meshopt_decodeIndexSequence(elements.data(), count, stride, bytes, view.bytes.size());
}

/// Decodes count * stride bytes. Before it allocates, it checks that the bytes can hold so many elements. Throws
/// Refusal.
std::vector<std::byte> decode_meshopt(const MeshoptView& view) {
  check_element(view);
  check_count(view);
  std::vector<std::byte> elements(static_cast<std::size_t>(view.count * view.stride));
  if (decode_elements(view, elements) != 0) throw Refusal("its bytes do not decode");
  apply_filter(view, elements);
  return elements;
}

/// Reads the bytes of a data URI or of a file beside the model.
std::vector<std::byte> read_uri(const std::string& uri, const std::filesystem::path& folder) {
  auto data = decode_data_uri(uri);
  return data ? std::move(*data) : read_file(resolve_uri(folder, uri));
}

Bytes require_length(Bytes bytes, const json& buffer) {
  const auto length = buffer["byteLength"].get<std::uint64_t>();
  if (bytes.size() < length) {
    throw Refusal("says " + std::to_string(length) + " bytes, but there are " + std::to_string(bytes.size()) +
                  "; copy or export the file again");
  }
  return bytes.first(static_cast<std::size_t>(length));
}

/// Returns the bytes of every buffer. The first buffer without uri is the BIN chunk if it is the first of all. Others
/// without uri are the fallback of compressed views, and no byte of them is read.
std::vector<Bytes> load_buffers(const json& document, std::optional<Bytes> binary_chunk,
                                const std::filesystem::path& folder, std::vector<std::vector<std::byte>>& storage) {
  std::vector<Bytes> buffers;
  for (const json& buffer : document.value("buffers", json::array())) {
    const auto uri = buffer.find("uri");
    try {
      if (uri != buffer.end()) {
        storage.push_back(read_uri(uri->get_ref<const std::string&>(), folder));
        buffers.push_back(require_length(storage.back(), buffer));
      } else {
        buffers.push_back(buffers.empty() && binary_chunk ? require_length(*binary_chunk, buffer) : Bytes{});
      }
    } catch (const Refusal& refusal) {
      throw Refusal("buffer " + std::to_string(buffers.size()) + ": " + refusal.what());
    }
  }
  return buffers;
}

/// Returns the part of a buffer that a view, or its compressed form, names.
Bytes slice(const json& view, const std::vector<Bytes>& buffers, const std::string& name) {
  const auto offset = view.value("byteOffset", std::uint64_t{0});
  const auto length = view["byteLength"].get<std::uint64_t>();
  const Bytes bytes = buffers[view["buffer"].get<std::size_t>()];
  if (length == 0) refuse(name, "has no bytes");
  if (offset > bytes.size() || length > bytes.size() - offset) {
    refuse(name, "bytes " + std::to_string(offset) + " and " + std::to_string(length) + " more, but its buffer has " +
                     std::to_string(bytes.size()));
  }
  return bytes.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
}

std::vector<std::byte> decompress(const json& view, const json& meshopt, const std::vector<Bytes>& buffers,
                                  const std::string& name) {
  const MeshoptView compressed{.bytes = slice(meshopt, buffers, name),
                               .count = meshopt["count"].get<std::uint64_t>(),
                               .stride = meshopt["byteStride"].get<std::uint64_t>(),
                               .mode = meshopt["mode"].get<std::string>(),
                               .filter = meshopt.value("filter", std::string("NONE"))};
  try {
    auto bytes = decode_meshopt(compressed);
    if (bytes.size() < view["byteLength"].get<std::uint64_t>()) throw Refusal("it holds fewer bytes than it says");
    return bytes;
  } catch (const Refusal& refusal) {
    throw Refusal(name + ", EXT_meshopt_compression: " + refusal.what() + "; export the file again");
  }
}

void check_stride(const json& view, const std::string& name) {
  const auto stride = view.find("byteStride");
  if (stride == view.end()) return;
  const auto bytes = stride->get<std::uint64_t>();
  if (bytes < 4 || bytes > 252 || bytes % 4 != 0) {
    refuse(name, "\"byteStride\" is " + std::to_string(bytes) + ", not a multiple of 4 from 4 to 252");
  }
}

}  // namespace

BufferViews load_buffer_views(const json& document, std::optional<Bytes> binary_chunk,
                              const std::filesystem::path& folder) {
  BufferViews result;
  const std::vector<Bytes> buffers = load_buffers(document, binary_chunk, folder, result.storage);
  std::size_t decompressed = 0;
  for (const json& view : document.value("bufferViews", json::array())) {
    const std::string name = "buffer view " + std::to_string(result.views.size());
    check_stride(view, name);
    const auto extensions = view.find("extensions");
    if (extensions == view.end() || !extensions->contains("EXT_meshopt_compression")) {
      result.views.push_back(slice(view, buffers, name));
      continue;
    }
    result.storage.push_back(decompress(view, (*extensions)["EXT_meshopt_compression"], buffers, name));
    result.views.emplace_back(result.storage.back());
    decompressed += result.views.back().size();
    if (decompressed > max_decompressed_size) throw Refusal(name + ": views decompress to more than 512 MiB");
  }
  return result;
}

}  // namespace throng::import
