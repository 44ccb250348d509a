#include "engine/anim/import/buffer_views.h"

#include <cstdint>
#include <filesystem>
#include <map>

#include <nlohmann/json.hpp>

#include "engine/anim/import/bytes/meshopt_codec.h"
#include "engine/anim/import/bytes/refusal.h"
#include "engine/anim/import/json_document.h"

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

/// Reads the bytes of every buffer, each file once. The first buffer without uri is the BIN chunk if it is the first of
/// all. Others without uri are the fallback of compressed views, and no byte of them is read.
class BufferReader {
 public:
  BufferReader(ModelFiles& files, std::vector<std::vector<std::byte>>& storage, std::vector<std::string>& repairs,
               MemoryAccount& memory)
      : files_(files), storage_(storage), repairs_(repairs), memory_(memory) {}

  std::vector<Bytes> read(const json& document, std::optional<Bytes> binary_chunk) {
    std::vector<Bytes> buffers;
    for (const json& buffer : array_of(document, "buffers")) {
      const std::string name = "buffer " + std::to_string(buffers.size());
      try {
        if (const auto uri = buffer.find("uri"); uri != buffer.end()) {
          buffers.push_back(require_length(bytes_of(uri->get_ref<const std::string&>(), name), buffer));
        } else {
          buffers.push_back(buffers.empty() && binary_chunk ? require_length(*binary_chunk, buffer) : Bytes{});
        }
      } catch (const Refusal& refusal) {
        throw Refusal(name + ": " + refusal.what());
      }
    }
    return buffers;
  }

 private:
  Bytes bytes_of(const std::string& uri, const std::string& name) {
    const std::filesystem::path file = files_.find(uri, name, repairs_);
    if (const auto known = read_.find(file); known != read_.end()) return known->second;
    storage_.push_back(files_.read(uri, file, name, memory_));
    if (!file.empty()) read_.emplace(file, storage_.back());
    return storage_.back();
  }

  ModelFiles& files_;
  std::vector<std::vector<std::byte>>& storage_;
  std::vector<std::string>& repairs_;
  MemoryAccount& memory_;
  std::map<std::filesystem::path, Bytes> read_;
};

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
                                  const std::string& name, MemoryAccount& memory) {
  const MeshoptView compressed{.bytes = slice(meshopt, buffers, name),
                               .count = meshopt["count"].get<std::uint64_t>(),
                               .stride = meshopt["byteStride"].get<std::uint64_t>(),
                               .mode = meshopt["mode"].get<std::string>(),
                               .filter = meshopt.value("filter", std::string("NONE"))};
  try {
    memory.charge(decoded_meshopt_size(compressed), name);
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

BufferViews load_buffer_views(const json& document, std::optional<Bytes> binary_chunk, ModelFiles& files,
                              std::vector<std::string>& repairs, MemoryAccount& memory) {
  BufferViews result;
  const std::vector<Bytes> buffers = BufferReader(files, result.storage, repairs, memory).read(document, binary_chunk);
  for (const json& view : array_of(document, "bufferViews")) {
    const std::string name = "buffer view " + std::to_string(result.views.size());
    check_stride(view, name);
    const json* const meshopt = find_meshopt(view);
    if (meshopt == nullptr) {
      result.views.push_back(slice(view, buffers, name));
      continue;
    }
    result.storage.push_back(decompress(view, *meshopt, buffers, name, memory));
    result.views.emplace_back(result.storage.back());
  }
  return result;
}

}  // namespace throng::import
