#include "engine/anim/import/buffer_views.h"

#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

#include "engine/anim/import/meshopt_codec.h"
#include "engine/anim/import/refusal.h"

namespace throng::import {

namespace {

using nlohmann::json;
using Bytes = std::span<const std::byte>;

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
std::vector<Bytes> load_buffers(const json& document, std::optional<Bytes> binary_chunk, const ModelFiles& files,
                                std::vector<std::vector<std::byte>>& storage, std::vector<std::string>& repairs) {
  std::vector<Bytes> buffers;
  for (const json& buffer : document.value("buffers", json::array())) {
    const auto uri = buffer.find("uri");
    const std::string name = "buffer " + std::to_string(buffers.size());
    try {
      if (uri != buffer.end()) {
        storage.push_back(files.read(uri->get_ref<const std::string&>(), name, repairs));
        buffers.push_back(require_length(storage.back(), buffer));
      } else {
        buffers.push_back(buffers.empty() && binary_chunk ? require_length(*binary_chunk, buffer) : Bytes{});
      }
    } catch (const Refusal& refusal) {
      throw Refusal(name + ": " + refusal.what());
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

/// EXT_meshopt_compression and the extension of the KHR that it became describe a view alike.
const json* find_meshopt(const json& view) {
  const auto extensions = view.find("extensions");
  if (extensions == view.end()) return nullptr;
  for (const char* const name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    if (const auto found = extensions->find(name); found != extensions->end()) return &*found;
  }
  return nullptr;
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
    throw Refusal(name + ", meshopt compression: " + refusal.what() + "; export the file again");
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

BufferViews load_buffer_views(const json& document, std::optional<Bytes> binary_chunk, const ModelFiles& files,
                              std::vector<std::string>& repairs) {
  BufferViews result;
  const std::vector<Bytes> buffers = load_buffers(document, binary_chunk, files, result.storage, repairs);
  std::size_t decompressed = 0;
  for (const json& view : document.value("bufferViews", json::array())) {
    const std::string name = "buffer view " + std::to_string(result.views.size());
    check_stride(view, name);
    const json* const meshopt = find_meshopt(view);
    if (meshopt == nullptr) {
      result.views.push_back(slice(view, buffers, name));
      continue;
    }
    result.storage.push_back(decompress(view, *meshopt, buffers, name));
    result.views.emplace_back(result.storage.back());
    decompressed += result.views.back().size();
    if (decompressed > max_decompressed_size) throw Refusal(name + ": views decompress to more than 512 MiB");
  }
  return result;
}

}  // namespace throng::import
