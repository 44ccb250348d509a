#include "engine/render/frame/instance_stream.h"

#include <bit>

#include "engine/render/frame/frame_uniforms.h"

namespace throng::render {
namespace {

gl::Buffer create_storage(std::size_t records) {
  gl::Buffer buffer = gl::create_buffer();
  glNamedBufferStorage(buffer.id(), static_cast<GLsizeiptr>(records * sizeof(InstanceRecord)), nullptr,
                       GL_DYNAMIC_STORAGE_BIT);
  return buffer;
}

}  // namespace

InstanceStream::InstanceStream() {
  for (Turn& turn : turns_) turn = {create_storage(1), 1};
}

void InstanceStream::upload(std::span<const InstanceRecord> instances) {
  turn_ = (turn_ + 1) % turns_.size();
  Turn& turn = turns_[turn_];
  if (instances.size() > turn.capacity) {
    turn.capacity = std::bit_ceil(instances.size());
    turn.buffer = create_storage(turn.capacity);
  }
  if (!instances.empty()) {
    glNamedBufferSubData(turn.buffer.id(), 0, static_cast<GLsizeiptr>(instances.size_bytes()), instances.data());
  }
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, instances_binding, turn.buffer.id());
}

}  // namespace throng::render
