#if defined(THRONG_KERNEL_GENERAL_PALETTE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_GENERAL_PALETTE_INL_H
#undef THRONG_KERNEL_GENERAL_PALETTE_INL_H
#else
#define THRONG_KERNEL_GENERAL_PALETTE_INL_H
#endif

#include "engine/anim/kernel/palette/palette_stage-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// Any affine transform: point -> matrix * point + translation.
template <class V>
struct Affine {
  static constexpr bool turns_as_quaternion = false;
  Matrices<V> matrix;
  Vectors<V> translation;
};
static_assert(branch_slot_floats >= 9 + 3);

template <class D, class V = hn::Vec<D>>
HWY_INLINE Affine<V> identity(D d) {
  const V zero = hn::Zero(d);
  const V one = hn::Set(d, 1.0F);
  return {{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}, {zero, zero, zero}};
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE Affine<V> load_affine(D d, const float* slot, int stride) {
  return {load_matrices(d, slot, stride), load_vectors(d, slot + 9 * stride, stride)};
}

template <class D, class V>
HWY_INLINE void store_affine(D d, const Affine<V>& affine, float* slot, int stride) {
  store(d, affine.matrix, slot, stride);
  store(d, affine.translation, slot + 9 * stride, stride);
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE Affine<V> broadcast_affine(D d, const float* rows) {
  return {{broadcast_vector(d, rows), broadcast_vector(d, rows + 4), broadcast_vector(d, rows + 8)},
          {hn::Set(d, rows[3]), hn::Set(d, rows[7]), hn::Set(d, rows[11])}};
}

template <class V>
HWY_INLINE Vectors<V> row_times_matrix(const Vectors<V>& row, const Matrices<V>& m) {
  return {hn::MulAdd(row.z, m.z.x, hn::MulAdd(row.y, m.y.x, hn::Mul(row.x, m.x.x))),
          hn::MulAdd(row.z, m.z.y, hn::MulAdd(row.y, m.y.y, hn::Mul(row.x, m.x.y))),
          hn::MulAdd(row.z, m.z.z, hn::MulAdd(row.y, m.y.z, hn::Mul(row.x, m.x.z)))};
}

/// b, then a.
template <class V>
HWY_INLINE Affine<V> product(const Affine<V>& a, const Affine<V>& b) {
  return {{row_times_matrix(a.matrix.x, b.matrix), row_times_matrix(a.matrix.y, b.matrix),
           row_times_matrix(a.matrix.z, b.matrix)},
          transform_add(a.matrix, b.translation, a.translation)};
}

template <class V>
HWY_INLINE Vectors<V> scaled(const Vectors<V>& row, const Vectors<V>& scale) {
  return {hn::Mul(row.x, scale.x), hn::Mul(row.y, scale.y), hn::Mul(row.z, scale.z)};
}

/// Translation * rotation * scale, from one bone's ten components.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Affine<V> load_local(D d, const float* input, int stride) {
  const auto lengthened = scaled(load_quaternions(d, input, stride), hn::Set(d, root_of_two));
  const Matrices<V> rotation = rotation_matrices(d, lengthened);
  const Vectors<V> scale = load_vectors(d, input + 7 * stride, stride);
  return {{scaled(rotation.x, scale), scaled(rotation.y, scale), scaled(rotation.z, scale)},
          load_vectors(d, input + 4 * stride, stride)};
}

/// Writes palette entries in groups of four, whichever bones they belong to.
template <class D>
class EntryWriter {
 public:
  EntryWriter(const ModelPaletteJob& job, int lane, int first_entry)
      : job_(job),
        lane_(lane),
        packet_(any_packet(job, lane, lane_count<D>)),
        next_(first_entry),
        stage_(job.palettes + lane, packet_, first_entry, memory_) {}

  template <class V>
  HWY_INLINE void add(D d, const Affine<V>& entry) {
    if (packet_.stores == StorePolicy::prefetched) stage_.prefetch(staged_);
    stage_.put(d, staged_++, entry.matrix, entry.translation);
    if (staged_ == Stage::entries) flush();
  }

  HWY_INLINE void flush() {
    stage_.turn();
    stage_.write(staged_);
    if (packet_.hashed) stage_.add_hashes(job_.hierarchy->skin_joint.data() + next_, staged_, job_.hashes + lane_);
    next_ += staged_;
    staged_ = 0;
  }

 private:
  using Stage = PaletteStage<D, matrix_rows, AnyPacket>;
  const ModelPaletteJob& job_;
  int lane_;
  AnyPacket packet_;
  int next_;
  int staged_ = 0;
  typename Stage::Memory memory_;
  Stage stage_;
};

/// Returns the first entry of the bones from `begin` on. Entries are in the order of bones.
inline int first_entry_from(const HierarchyProgram& program, int begin, int end) {
  for (int bone = begin; bone < end; ++bone) {
    const HierarchyStep& step = program.steps[static_cast<std::size_t>(bone)];
    if (step.entry_count > 0) return step.first_entry;
  }
  return 0;
}

/// The bones [begin, end) of one packet, for one vector of characters of a strip of `width`:
///     global = parent's global * prefix * T * R * S,   entry = global * post
/// `beside` is called for each bone.
template <int width, class D, class Beside>
HWY_INLINE void general_palette_lanes(D d, const ModelPaletteJob& job, int lane, int begin, int end, Beside beside) {
  constexpr int lanes = lane_count<D>;
  const HierarchyProgram& program = *job.hierarchy;
  const float* local = job.local + lane * general_components * packet_bones;
  alignas(64) FloatArray<4 * general_components * lanes> inputs;
  EntryWriter<D> writer(job, lane, first_entry_from(program, begin, end));
  auto global = begin == 0 ? identity(d) : load_affine(d, job.carry + lane, width);
  for (int bone = begin; bone < end; ++bone) {
    const int in_packet = bone - begin;
    if (in_packet % 4 == 0) gather_four_bones<general_components>(d, local + in_packet, general_components, inputs);
    const HierarchyStep step = program.steps[static_cast<std::size_t>(bone)];
    if (step.load >= 0) {
      global = load_affine(d, job.branch_slots + step.load * branch_slot_floats * width + lane, width);
    } else if (step.load == HierarchyStep::from_root) {
      global = identity(d);
    }
    if (program.has_prefix[static_cast<std::size_t>(bone)] != 0) {
      global = product(global, broadcast_affine(d, program.prefixes.data() + bone * matrix_floats));
    }
    global = product(global, load_local(d, inputs + in_packet % 4 * general_components * lanes, lanes));
    if (step.store >= 0) {
      store_affine(d, global, job.branch_slots + step.store * branch_slot_floats * width + lane, width);
    }
    beside.write(d, bone, global);
    for (int entry = step.first_entry; entry < step.first_entry + step.entry_count; ++entry) {
      writer.add(d, product(global, broadcast_affine(d, program.posts.data() + entry * matrix_floats)));
    }
  }
  writer.flush();
  store_affine(d, global, job.carry + lane, width);
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
