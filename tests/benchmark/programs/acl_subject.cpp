#include "tests/benchmark/programs/acl_subject.h"

#ifdef THRONG_HAS_ACL

#include <utility>
#include <vector>

#include <rtm/macros.h>
#include <rtm/matrix3x4f.h>

#include "tests/benchmark/programs/acl_clip.h"

namespace throng::app {
namespace {

void store(const rtm::matrix3x4f& matrix, anim::PaletteMatrix& out) {
  rtm::vector4f rows[3];
  RTM_MATRIXF_TRANSPOSE_4X3(matrix.x_axis, matrix.y_axis, matrix.z_axis, matrix.w_axis, rows[0], rows[1], rows[2]);
  for (int row = 0; row < 3; ++row) rtm::vector_store(rows[row], out.rows[row]);
}

class RigidAclSubject final : public AclSubject {
 public:
  RigidAclSubject(const LocalBones& bones, std::span<const BenchAgent> agents, const BenchPalettes& palettes)
      : AclSubject(agents, palettes),
        parents_(bones.parents),
        from_(parents_.size()),
        to_(parents_.size()),
        models_(parents_.size()) {
    for (const LocalPlace& place : bones.bind_pose) bind_pose_.push_back(acl_place(place));
    for (const LocalPlace& place : bones.inverse_binds) {
      inverse_binds_.push_back(rtm::matrix_from_qv(acl_place(place)));
    }
  }

  /// Returns whether ACL takes all clips.
  bool compress(const anim::Character& character, const LocalBones& bones) {
    clips_ = std::vector<AclClip>(character.clips.size());
    for (std::size_t clip = 0; clip < clips_.size(); ++clip) {
      if (!clips_[clip].compress(character.skeleton, bones, character.clips[clip])) return false;
    }
    return true;
  }

  void sample() override {
    advance();
    for (const BenchAgent& agent : agents()) sample(agent);
  }

  std::size_t bytes() const override {
    std::size_t sum = 0;
    for (const AclClip& clip : clips_) sum += clip.bytes();
    return sum;
  }

 private:
  void sample(int clip_index, Ticks start, std::vector<rtm::qvf>& pose) {
    AclClip& clip = clips_[static_cast<std::size_t>(clip_index)];
    AclPoseWriter writer(bind_pose_, pose);
    clip.sample(time_in_clip(start, clip.duration()), writer);
  }

  void sample(const BenchAgent& agent) {
    sample(agent.from_clip, agent.from_start, from_);
    sample(agent.to_clip, agent.to_start, to_);
  }

  void pose(std::size_t agent) override {
    const BenchAgent& plays = agents()[agent];
    sample(plays);
    anim::PaletteMatrix* const palette = palette_of(agent);
    for (std::size_t bone = 0; bone < models_.size(); ++bone) {
      const int parent = parents_[bone];
      const rtm::matrix3x4f local = rtm::matrix_from_qv(rtm::qv_lerp(from_[bone], to_[bone], plays.fraction));
      models_[bone] = parent < 0 ? local : rtm::matrix_mul(local, models_[static_cast<std::size_t>(parent)]);
      store(rtm::matrix_mul(inverse_binds_[bone], models_[bone]), palette[bone]);
    }
  }

  std::vector<AclClip> clips_;
  std::vector<int> parents_;
  std::vector<rtm::qvf> bind_pose_, from_, to_;
  std::vector<rtm::matrix3x4f> models_, inverse_binds_;
};

}  // namespace

Result<std::unique_ptr<AclSubject>> make_acl_subject(const BenchCharacter& whom, std::span<const BenchAgent> agents,
                                                     const BenchPalettes& palettes) {
  const Status sampled = has_local_clips(*whom.character);
  if (!sampled) return sampled.error();
  const LocalBones bones = local_bones(whom.model);
  auto subject = std::make_unique<RigidAclSubject>(bones, agents, palettes);
  if (!subject->compress(*whom.character, bones)) return Error{"it does not take a clip of this model"};
  return std::unique_ptr<AclSubject>(std::move(subject));
}

}  // namespace throng::app

#else

namespace throng::app {

Result<std::unique_ptr<AclSubject>> make_acl_subject(const BenchCharacter&, std::span<const BenchAgent>,
                                                     const BenchPalettes&) {
  return Error{"it and RTM were not installed when this program was built"};
}

}  // namespace throng::app

#endif
