// Between "one character's bones in a row" (poses, palettes) and "one bone's characters in a vector" (hierarchy).
#if defined(THRONG_KERNEL_TRANSPOSE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_TRANSPOSE_INL_H
#undef THRONG_KERNEL_TRANSPOSE_INL_H
#else
#define THRONG_KERNEL_TRANSPOSE_INL_H
#endif

#include <cstring>

#include "engine/anim/kernel/lanes/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

inline constexpr int block_floats = 4;  // a block of 128 bits, inside which shuffles are cheap

template <class V>
struct FourVectors {
  V v[4];
};

#if HWY_TARGET != HWY_SCALAR

/// Transposes inside every block: block b of out[i] holds lane i of block b of v0, v1, v2 and v3.
template <class D, class V = hn::Vec<D>>
HWY_INLINE FourVectors<V> transpose_blocks(D d, V v0, V v1, V v2, V v3) {
  const hn::Repartition<double, D> pairs;
  const auto low01 = hn::BitCast(pairs, hn::InterleaveLower(d, v0, v1));
  const auto low23 = hn::BitCast(pairs, hn::InterleaveLower(d, v2, v3));
  const auto high01 = hn::BitCast(pairs, hn::InterleaveUpper(d, v0, v1));
  const auto high23 = hn::BitCast(pairs, hn::InterleaveUpper(d, v2, v3));
  return {{hn::BitCast(d, hn::InterleaveLower(pairs, low01, low23)),
           hn::BitCast(d, hn::InterleaveUpper(pairs, low01, low23)),
           hn::BitCast(d, hn::InterleaveLower(pairs, high01, high23)),
           hn::BitCast(d, hn::InterleaveUpper(pairs, high01, high23))}};
}

#endif

#if HWY_TARGET <= HWY_AVX3  // and its extensions, which are the bits below

/// Four blocks from memory, each an insertion that needs no shuffle: Highway would combine halves in registers.
template <class D, class BlockAt>
HWY_INLINE hn::Vec<D> load_four_blocks(D /*d*/, BlockAt&& block_at) {
  __m512 blocks = _mm512_castps128_ps512(_mm_load_ps(block_at(0)));
  blocks = _mm512_insertf32x4(blocks, _mm_load_ps(block_at(1)), 1);
  blocks = _mm512_insertf32x4(blocks, _mm_load_ps(block_at(2)), 2);
  return hn::Vec<D>{_mm512_insertf32x4(blocks, _mm_load_ps(block_at(3)), 3)};
}

/// Transposes whole blocks: out[i] holds block i of v0, v1, v2 and v3. Highway has no such shuffle of two vectors'
/// blocks.
template <class V>
HWY_INLINE FourVectors<V> transpose_whole_blocks(V v0, V v1, V v2, V v3) {
  const __m512 low01 = _mm512_shuffle_f32x4(v0.raw, v1.raw, 0x44);
  const __m512 high01 = _mm512_shuffle_f32x4(v0.raw, v1.raw, 0xEE);
  const __m512 low23 = _mm512_shuffle_f32x4(v2.raw, v3.raw, 0x44);
  const __m512 high23 = _mm512_shuffle_f32x4(v2.raw, v3.raw, 0xEE);
  return {{V{_mm512_shuffle_f32x4(low01, low23, 0x88)}, V{_mm512_shuffle_f32x4(low01, low23, 0xDD)},
           V{_mm512_shuffle_f32x4(high01, high23, 0x88)}, V{_mm512_shuffle_f32x4(high01, high23, 0xDD)}}};
}

#endif

#if HWY_TARGET != HWY_SCALAR

/// Loads one vector of 128-bit blocks, block i from block_at(i).
template <int first = 0, class D, class BlockAt>
HWY_INLINE hn::Vec<D> load_blocks(D d, BlockAt&& block_at) {
  if constexpr (lane_count<D> == block_floats) {
    return hn::Load(d, block_at(first));
  } else if constexpr (lane_count<D> == 4 * block_floats) {
    return load_four_blocks(d, block_at);
  } else {
    const hn::Half<D> half;
    return hn::Combine(d, load_blocks<first + lane_count<D> / 2 / block_floats>(half, block_at),
                       load_blocks<first>(half, block_at));
  }
}

/// Loads blocks that lie `stride` floats apart.
template <class D>
HWY_INLINE hn::Vec<D> load_blocks(D d, const float* from, int stride) {
  return load_blocks(d, [=](int block) { return from + block * stride; });
}

#endif

/// Rows of four floats: row r lies `offset + r * stride` floats behind from[lane]; out[r].v[i] gets its i-th of each
/// lane. An address is looked up once for all rows: sixteen do not stay in registers.
template <int rows, class D, class V = hn::Vec<D>>
HWY_INLINE void load_rows_of_four(D d, const float* const* from, int offset, int stride, FourVectors<V>* out) {
  if constexpr (lane_count<D> >= block_floats) {
    FourVectors<V> blocks[std::size_t{rows}];
    for (int lane = 0; lane < block_floats; ++lane) {
      const auto row_of = [&](int block) { return from[block * block_floats + lane]; };
      for (int row = 0; row < rows; ++row) {
        blocks[row].v[lane] = load_blocks(d, [&](int block) { return row_of(block) + offset + row * stride; });
      }
    }
    for (int row = 0; row < rows; ++row) {
      const V* const v = blocks[row].v;
      out[row] = transpose_blocks(d, v[0], v[1], v[2], v[3]);
    }
  } else {
    for (int row = 0; row < rows; ++row) {
      alignas(64) float lanes[block_floats][lane_count<D>];
      for (int i = 0; i < block_floats; ++i) {
        for (int lane = 0; lane < lane_count<D>; ++lane)
          std::memcpy(&lanes[i][lane], from[lane] + offset + row * stride + i, sizeof(float));
      }
      out[row] = {{hn::Load(d, lanes[0]), hn::Load(d, lanes[1]), hn::Load(d, lanes[2]), hn::Load(d, lanes[3])}};
    }
  }
}

#if HWY_TARGET != HWY_SCALAR

/// Stores block i to to[i * block_floats] + offset.
template <class D>
HWY_INLINE void store_blocks(D d, hn::Vec<D> blocks, float* const* to, int offset) {
  if constexpr (lane_count<D> == block_floats) {
    hn::Store(blocks, d, to[0] + offset);
  } else {
    const hn::Half<D> half;
    store_blocks(half, hn::LowerHalf(half, blocks), to, offset);
    store_blocks(half, hn::UpperHalf(half, blocks), to + lane_count<D> / 2, offset);
  }
}

#endif

/// The inverse, from the float `first` of each lane's destination on. Lanes that go to the same address hold the same
/// values, or are never read.
template <int rows, class D, class V = hn::Vec<D>>
HWY_INLINE void store_rows_of_four(D d, const FourVectors<V>* in, float* const* to, int stride, int first = 0) {
  if constexpr (lane_count<D> >= block_floats) {
    FourVectors<V> blocks[std::size_t{rows}];
    for (int row = 0; row < rows; ++row) {
      const V* const v = in[row].v;
      blocks[row] = transpose_blocks(d, v[0], v[1], v[2], v[3]);
    }
    for (int lane = 0; lane < block_floats; ++lane) {
      for (int row = 0; row < rows; ++row) store_blocks(d, blocks[row].v[lane], to + lane, first + row * stride);
    }
  } else {
    for (int row = 0; row < rows; ++row) {
      alignas(64) float lanes[block_floats][lane_count<D>];
      for (int i = 0; i < block_floats; ++i) hn::Store(in[row].v[i], d, lanes[i]);
      for (int lane = 0; lane < lane_count<D>; ++lane) {
        for (int i = 0; i < block_floats; ++i)
          std::memcpy(to[lane] + first + row * stride + i, &lanes[i][lane], sizeof(float));
      }
    }
  }
}

/// The first `wanted` components of four bones of lane_count<D> characters: out is [bone][component][character].
template <int components, class D>
HWY_INLINE void gather_four_bones(D d, const float* local, int wanted, float* out) {
  constexpr int lanes = lane_count<D>;
  constexpr int character_stride = components * packet_bones;
  for (int component = 0; component < wanted; ++component) {
    const float* in = local + component * packet_bones;
    if constexpr (lanes >= block_floats) {
      constexpr int block_stride = block_floats * character_stride;
      const auto bones =
          transpose_blocks(d, load_blocks(d, in, block_stride), load_blocks(d, in + character_stride, block_stride),
                           load_blocks(d, in + 2 * character_stride, block_stride),
                           load_blocks(d, in + 3 * character_stride, block_stride));
      for (int bone = 0; bone < 4; ++bone) hn::Store(bones.v[bone], d, out + (bone * components + component) * lanes);
    } else {
      for (int bone = 0; bone < 4; ++bone) {
        for (int lane = 0; lane < lanes; ++lane) {
          out[(bone * components + component) * lanes + lane] = in[lane * character_stride + bone];
        }
      }
    }
  }
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
