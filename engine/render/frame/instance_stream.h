#pragma once

#include <array>
#include <span>

#include "engine/render/gl/handles.h"
#include "engine/render/instance_record.h"

namespace throng::render {

/// Carries the records of each frame to the device. It takes turns with several buffers, so that copying never waits
/// for an earlier frame. Buffers grow and never shrink.
class InstanceStream {
 public:
  InstanceStream();

  /// Copies the records and binds them as storage block `instances_binding`.
  void upload(std::span<const InstanceRecord> instances);

 private:
  struct Turn {
    gl::Buffer buffer;
    std::size_t capacity = 0;  ///< records
  };

  static constexpr std::size_t frames_in_flight = 3;
  std::array<Turn, frames_in_flight> turns_;
  std::size_t turn_ = 0;
};

}  // namespace throng::render
