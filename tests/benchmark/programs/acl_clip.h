#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <acl/core/ansi_allocator.h>
#include <acl/core/compressed_tracks.h>
#include <acl/decompression/decompress.h>
#include <rtm/qvf.h>

#include "engine/anim/bake/character.h"
#include "tests/benchmark/programs/local_poses.h"

namespace throng::app {

inline rtm::qvf acl_place(const LocalPlace& place) {
  const glm::quat& q = place.rotation;
  const glm::vec3& p = place.position;
  return rtm::qv_set(rtm::quat_set(q.x, q.y, q.z, q.w), rtm::vector_set(p.x, p.y, p.z));
}

/// Writes a sampled pose. What stays at the bind pose is not stored in clips, and comes from there. Scale is left out,
/// as rigid skeletons have none.
struct AclPoseWriter : acl::track_writer {
  const rtm::qvf* bind_pose;
  rtm::qvf* pose;

  AclPoseWriter(const std::vector<rtm::qvf>& bind, std::vector<rtm::qvf>& out)
      : bind_pose(bind.data()), pose(out.data()) {}

  static constexpr bool skip_all_scales() { return true; }
  static constexpr acl::default_sub_track_mode get_default_rotation_mode() {
    return acl::default_sub_track_mode::variable;
  }
  static constexpr acl::default_sub_track_mode get_default_translation_mode() {
    return acl::default_sub_track_mode::variable;
  }
  rtm::quatf RTM_SIMD_CALL get_variable_default_rotation(std::uint32_t bone) const { return bind_pose[bone].rotation; }
  rtm::vector4f RTM_SIMD_CALL get_variable_default_translation(std::uint32_t bone) const {
    return bind_pose[bone].translation;
  }
  void RTM_SIMD_CALL write_rotation(std::uint32_t bone, rtm::quatf_arg0 rotation) const {
    pose[bone].rotation = rotation;
  }
  void RTM_SIMD_CALL write_translation(std::uint32_t bone, rtm::vector4f_arg0 translation) const {
    pose[bone].translation = translation;
  }
};

/// Has ACL read what this version of it writes, and nothing else.
struct AclSettings : acl::default_transform_decompression_settings {
  static constexpr acl::compressed_tracks_version16 version_supported() {
    return acl::compressed_tracks_version16::latest;
  }
};

/// A clip that ACL keeps. Agents share it, and its context too: that holds no more than a moment.
class AclClip {
 public:
  AclClip() = default;
  AclClip(const AclClip&) = delete;
  AclClip& operator=(const AclClip&) = delete;
  ~AclClip();

  /// Returns whether ACL takes the clip.
  bool compress(const anim::Skeleton& skeleton, const LocalBones& bones, const anim::BakedClip& clip);
  std::size_t bytes() const { return tracks_->get_size(); }
  Ticks duration() const { return duration_; }
  void sample(Ticks time, AclPoseWriter& writer) {
    context_.seek(static_cast<float>(to_seconds(time - first_sample_)), acl::sample_rounding_policy::none);
    context_.decompress_tracks(writer);
  }

 private:
  acl::ansi_allocator allocator_;
  acl::compressed_tracks* tracks_ = nullptr;
  acl::decompression_context<AclSettings> context_;
  Ticks duration_{}, first_sample_{};
};

}  // namespace throng::app
