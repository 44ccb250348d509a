// Between "one character's bones in a row" (poses, palettes) and "one bone's characters in a vector" (hierarchy).
#if defined(THRONG_KERNEL_TRANSPOSE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_TRANSPOSE_INL_H
#undef THRONG_KERNEL_TRANSPOSE_INL_H
#else
#define THRONG_KERNEL_TRANSPOSE_INL_H
#endif

#include <cstring>

#include "engine/anim/kernel/kernels.h"
#include "engine/anim/kernel/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

inline constexpr int block_floats = 4;  // what shuffles inside 128-bit blocks move together
inline constexpr int matrix_floats = 12;

/// Four vectors of blocks, transposed block by block: out[i] has lane i of the block of v0, v1, v2, v3.
template <class V>
struct FourVectors {
  V v[4];
};

#if HWY_TARGET != HWY_SCALAR

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

/// One vector of 128-bit blocks that lie `stride` floats apart.
template <class D>
HWY_INLINE hn::Vec<D> load_blocks(D d, const float* from, int stride) {
  if constexpr (lane_count<D> == block_floats) {
    return hn::Load(d, from);
  } else {
    const hn::Half<D> half;
    return hn::Combine(d, load_blocks(half, from + lane_count<D> / 2 / block_floats * stride, stride),
                       load_blocks(half, from, stride));
  }
}

#endif

#if HWY_TARGET == HWY_AVX3

/// out[i] has block i of v0, v1, v2, v3. Highway has no such shuffle of two vectors' blocks.
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

/// Components of four bones of lane_count<D> characters: out is [bone][component][character].
template <int components, class D>
HWY_INLINE void gather_four_bones(D d, const float* local, float* out) {
  constexpr int lanes = lane_count<D>;
  constexpr int character_stride = components * packet_bones;
  for (int component = 0; component < components; ++component) {
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

/// Up to four palette entries of lane_count<D> characters on their way out: three whole cache lines a character, which
/// leave in ascending order, so that the destination may be write-combined memory.
///
///     rows = [character % 4][entry][row] of (character / 4 blocks of 4 floats)      vectors of 4 lanes and more
///          = [character][entry][row] of 4 floats                                    narrower ones
template <class D>
class PaletteStage {
 public:
  static constexpr int lanes = lane_count<D>;
  static constexpr int entries = 4;

  template <class V>
  HWY_INLINE void put_row(D d, int entry, int row, const Vectors<V>& xyz, V w) {
    if constexpr (lanes >= block_floats) {
      const auto characters = transpose_blocks(d, xyz.x, xyz.y, xyz.z, w);
      for (int k = 0; k < 4; ++k) hn::Store(characters.v[k], d, rows_ + ((k * entries + entry) * 3 + row) * lanes);
    } else {
      alignas(16) FloatArray<lanes> components[4];
      hn::Store(xyz.x, d, components[0]);
      hn::Store(xyz.y, d, components[1]);
      hn::Store(xyz.z, d, components[2]);
      hn::Store(w, d, components[3]);
      for (int lane = 0; lane < lanes; ++lane) {
        for (int k = 0; k < 4; ++k) rows_[((lane * entries + entry) * 3 + row) * 4 + k] = components[k][lane];
      }
    }
  }

  template <class V>
  HWY_INLINE void put(D d, int entry, const Matrices<V>& m, const Vectors<V>& translation) {
    put_row(d, entry, 0, m.x, translation.x);
    put_row(d, entry, 1, m.y, translation.y);
    put_row(d, entry, 2, m.z, translation.z);
  }

  /// Fetches for writing what one of every four characters will write: spread over the four entries, the lines arrive
  /// while they are computed.
  HWY_INLINE void prefetch(PaletteMatrix* const* palettes, int characters, int first, int quarter) const {
    for (int character = quarter; character < characters; character += 4) {
      const float* line = reinterpret_cast<float*>(palettes[character] + first);
      for (int at = 0; at < entries * matrix_floats; at += 16) __builtin_prefetch(line + at, 1, 3);
    }
  }

  /// Writes entries [first, first + count) of palettes[0, characters).
  HWY_INLINE void write(PaletteMatrix* const* palettes, int characters, int first, int count) const {
    if constexpr (lanes == 16) {
      if (count == entries && characters == lanes) return write_all_lines(palettes, first);
    }
    for (int character = 0; character < characters; ++character) {
      float* out = reinterpret_cast<float*>(palettes[character] + first);
      if (count == entries) {
        write_entries(character, out);
      } else {
        write_blocks(character, count, out);
      }
    }
  }

  void add_hashes(const std::int16_t* joints, int characters, int count, std::uint64_t* hashes) const {
    for (int character = 0; character < characters; ++character) {
      for (int entry = 0; entry < count; ++entry) {
        PaletteMatrix matrix;
        for (int row = 0; row < 3; ++row) {
          std::memcpy(matrix.rows[row], block(character, entry * 3 + row), sizeof(matrix.rows[row]));
        }
        hashes[character] += palette_entry_hash(static_cast<std::uint32_t>(joints[entry]), matrix);
      }
    }
  }

 private:
  /// Row `index` (entry * 3 + row) of one character.
  const float* block(int character, int index) const {
    if constexpr (lanes >= block_floats) {
      return rows_ + (character % 4 * entries * 3 + index) * lanes + character / 4 * block_floats;
    } else {
      return rows_ + (character * entries * 3 + index) * block_floats;
    }
  }

  /// All sixteen characters, a line of four of them at a time.
  HWY_INLINE void write_all_lines(PaletteMatrix* const* palettes, int first) const {
    const D d;
    for (int k = 0; k < 4; ++k) {
      for (int line = 0; line < 3; ++line) {
        const float* in = rows_ + (k * entries * 3 + line * 4) * lanes;
        const auto lines = transpose_whole_blocks(hn::Load(d, in), hn::Load(d, in + lanes), hn::Load(d, in + 2 * lanes),
                                                  hn::Load(d, in + 3 * lanes));
        for (int b = 0; b < 4; ++b) {
          hn::StoreU(lines.v[b], d, reinterpret_cast<float*>(palettes[4 * b + k] + first) + line * lanes);
        }
      }
    }
  }

  HWY_INLINE void write_entries(int character, float* out) const {
    if constexpr (lanes >= block_floats) {
      const D d;
      for (int at = 0; at < entries * matrix_floats; at += lanes) {
        hn::StoreU(load_blocks(d, block(character, at / block_floats), lanes), d, out + at);
      }
    } else {
      write_blocks(character, entries, out);
    }
  }

  HWY_INLINE void write_blocks(int character, int count, float* out) const {
    for (int index = 0; index < count * 3; ++index) {
      std::memcpy(out + index * block_floats, block(character, index), block_floats * sizeof(float));
    }
  }

  alignas(64) FloatArray<entries * matrix_floats * lanes> rows_;
};

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
