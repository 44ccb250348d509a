#pragma once

namespace throng::anim {

enum class StreamKind : unsigned char { sampled, keyframe };

}  // namespace throng::anim
