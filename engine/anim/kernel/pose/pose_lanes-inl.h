// Some bones of a strip of poses, one pose a lane. They are read and written by quads.
#if defined(THRONG_KERNEL_POSE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_POSE_LANES_INL_H
#undef THRONG_KERNEL_POSE_LANES_INL_H
#else
#define THRONG_KERNEL_POSE_LANES_INL_H
#endif

#include <cassert>

#include "engine/anim/kernel/lanes/transpose-inl.h"
#include "engine/anim/kernel/pose/pose_view.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// One number of each character.
template <class D>
struct Lane {
  alignas(64) FloatArray<lane_count<D>> of;

  hn::Vec<D> load(D d) const { return hn::Load(d, of); }
  void store(D d, hn::Vec<D> value) { hn::Store(value, d, of); }
};

/// A bone among the bones that were read.
using BonePlace = int;

/// The bones of up to `most_quads` quads. Bones that are not written keep their bits.
template <class D, int most_quads>
class PoseLanes {
 public:
  using V = hn::Vec<D>;

  /// Every lane holds a pose, and all have the same bone count.
  void begin(const PoseView* const (&poses)[lane_count<D>]) {
    quad_count_ = 0;
    displaced_ = 0;
    stride_ = poses[0]->packet_stride;
    for (int lane = 0; lane < lane_count<D>; ++lane) {
      assert(poses[lane]->packet_stride == stride_ && poses[lane]->components == rigid_components);
      first_[lane] = poses[lane]->first;
      displaced_ |= poses[lane]->displaced_quads;
    }
  }
  /// Reads a quad unless it was read before.
  BonePlace place_of(int bone) {
    const int index = bone / quad_bones;
    int quad = 0;
    while (quad < quad_count_ && quads_[quad].index != index) ++quad;
    if (quad == quad_count_) load(quads_[quad_count_++], index);
    return quad * quad_bones + bone % quad_bones;
  }

  Quaternions<V> rotation(D d, BonePlace bone) const {
    const Lane<D>* const parts = parts_of(bone);
    return {parts[0].load(d), parts[quad_bones].load(d), parts[2 * quad_bones].load(d), parts[3 * quad_bones].load(d)};
  }
  /// The position is 0 where no pose displaces the bone.
  Vectors<V> position(D d, BonePlace bone) const {
    const Lane<D>* const parts = parts_of(bone) + first_position;
    if (!quads_[bone / quad_bones].displaced) return {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    return {parts[0].load(d), parts[quad_bones].load(d), parts[2 * quad_bones].load(d)};
  }
  void turn(D d, BonePlace bone, const Quaternions<V>& rotation) {
    Lane<D>* const parts = parts_of(bone);
    parts[0].store(d, rotation.x);
    parts[quad_bones].store(d, rotation.y);
    parts[2 * quad_bones].store(d, rotation.z);
    parts[3 * quad_bones].store(d, rotation.w);
    quads_[bone / quad_bones].turned = true;
  }
  /// Sets the position of a bone whose quad may be displaced.
  void move(D d, BonePlace bone, const Vectors<V>& position) {
    assert(quads_[bone / quad_bones].displaced);
    Lane<D>* const parts = parts_of(bone) + first_position;
    parts[0].store(d, position.x);
    parts[quad_bones].store(d, position.y);
    parts[2 * quad_bones].store(d, position.z);
    quads_[bone / quad_bones].moved = true;
  }

  /// Writes quads with changed bones to their poses.
  void store() const {
    for (int i = 0; i < quad_count_; ++i) {
      const Quad& quad = quads_[i];
      if (quad.turned) store_components<4>(quad, 0);
      if (quad.moved) store_components<3>(quad, 4);
    }
  }

 private:
  static constexpr int first_position = 4 * quad_bones;

  struct Quad {
    int index;  ///< of its bones, over quad_bones
    bool displaced, turned, moved;
    Lane<D> parts[rigid_components * quad_bones];
  };

  Lane<D>* parts_of(BonePlace bone) { return quads_[bone / quad_bones].parts + bone % quad_bones; }
  const Lane<D>* parts_of(BonePlace bone) const { return quads_[bone / quad_bones].parts + bone % quad_bones; }

  void find(const Quad& quad, float* (&quads)[lane_count<D>]) const {
    const std::size_t offset = static_cast<std::size_t>(quad.index / packet_quads) * stride_ +
                               static_cast<std::size_t>(quad.index % packet_quads * quad_bones);
    for (int lane = 0; lane < lane_count<D>; ++lane) quads[lane] = first_[lane] + offset;
  }
  void load(Quad& quad, int index) {
    assert(quad_count_ <= most_quads);
    quad.index = index;
    quad.displaced = is_in(quads_of_packet(displaced_, index / packet_quads), index % packet_quads);
    quad.turned = false;
    quad.moved = false;
    load_components<4>(quad, 0);
    if (quad.displaced) load_components<3>(quad, 4);
  }
  template <int components>
  void load_components(Quad& quad, int first) const {
    const D d;
    float* from[lane_count<D>];
    find(quad, from);
    FourVectors<V> bones[std::size_t{components}];
    load_rows_of_four<components>(d, from, first * packet_bones, packet_bones, bones);
    Lane<D>* part = quad.parts + first * quad_bones;
    for (const FourVectors<V>& component : bones) {
      for (int bone = 0; bone < quad_bones; ++bone) (part++)->store(d, component.v[bone]);
    }
  }
  template <int components>
  void store_components(const Quad& quad, int first) const {
    const D d;
    float* to[lane_count<D>];
    find(quad, to);
    FourVectors<V> bones[std::size_t{components}];
    const Lane<D>* part = quad.parts + first * quad_bones;
    for (FourVectors<V>& component : bones) {
      for (int bone = 0; bone < quad_bones; ++bone) component.v[bone] = (part++)->load(d);
    }
    for (float*& bone : to) bone += first * packet_bones;
    store_rows_of_four<components>(d, bones, to, packet_bones);
  }

  float* first_[lane_count<D>];
  std::size_t stride_;
  std::uint64_t displaced_;
  int quad_count_;
  Quad quads_[std::size_t{most_quads}];
};

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
