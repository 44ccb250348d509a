#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace throng::making {

using Json = nlohmann::ordered_json;

/// glTF 2.0 section 3.6.2.2.
enum class ComponentType {
  byte = 5120,
  unsigned_byte = 5121,
  signed_short = 5122,
  unsigned_short = 5123,
  float32 = 5126
};
/// glTF 2.0 section 3.6.1.1.
enum class Target { none = 0, vertex_data = 34962, index_data = 34963 };

/// Collects the buffer's bytes and the accessors that describe them.
class BufferWriter {
 public:
  /// Appends the elements in a view of their own; returns the accessor's index.
  template <typename Element>
  std::size_t add(std::span<const Element> elements, const char* type, ComponentType component, Target target,
                  bool normalized = false) {
    const std::size_t view = add_view(std::as_bytes(elements), target);
    return add_accessor(view, 0, elements.size(), type, component, normalized);
  }

  /// Appends a view; `stride` is that of its elements where several accessors share it.
  std::size_t add_view(std::span<const std::byte> raw, Target target, std::size_t stride = 0) {
    const std::size_t offset = bytes_.size();
    bytes_.insert(bytes_.end(), raw.begin(), raw.end());
    while (bytes_.size() % 4 != 0) bytes_.push_back(std::byte{0});
    Json view{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", raw.size()}};
    if (stride > 0) view["byteStride"] = stride;
    if (target != Target::none) view["target"] = static_cast<int>(target);
    views_.push_back(view);
    return views_.size() - 1;
  }

  std::size_t add_accessor(std::size_t view, std::size_t offset, std::size_t count, const char* type,
                           ComponentType component, bool normalized = false) {
    Json accessor{{"bufferView", view}};
    if (offset > 0) accessor["byteOffset"] = offset;
    accessor["componentType"] = static_cast<int>(component);
    accessor["count"] = count;
    accessor["type"] = type;
    if (normalized) accessor["normalized"] = true;
    accessors_.push_back(accessor);
    return accessors_.size() - 1;
  }

  /// Gives an accessor the least and the greatest value of every component; `elements` is not empty.
  template <std::size_t N, typename Number = float>
  void set_bounds(std::size_t accessor, std::type_identity_t<std::span<const std::array<Number, N>>> elements) {
    std::array<Number, N> low = elements[0];
    std::array<Number, N> high = elements[0];
    for (const auto& element : elements) {
      for (std::size_t i = 0; i < N; ++i) {
        low[i] = std::min(low[i], element[i]);
        high[i] = std::max(high[i], element[i]);
      }
    }
    accessors_[accessor]["min"] = low;
    accessors_[accessor]["max"] = high;
  }

  /// Puts the arrays of accessors, views and the one buffer into the file's JSON.
  void finish(Json& document) const {
    document["accessors"] = accessors_;
    document["bufferViews"] = views_;
    document["buffers"] = Json::array({{{"byteLength", bytes_.size()}}});
  }
  [[nodiscard]] const std::vector<std::byte>& bytes() const { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
  Json accessors_ = Json::array();
  Json views_ = Json::array();
};

}  // namespace throng::making
