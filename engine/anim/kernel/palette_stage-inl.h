#if defined(THRONG_KERNEL_PALETTE_STAGE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_PALETTE_STAGE_INL_H
#undef THRONG_KERNEL_PALETTE_STAGE_INL_H
#else
#define THRONG_KERNEL_PALETTE_STAGE_INL_H
#endif

#include <cstring>

#include "engine/anim/kernel/kernels.h"
#include "engine/anim/kernel/transpose-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

inline constexpr int matrix_floats = 12;

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
      auto* out = reinterpret_cast<float*>(palettes[character] + first);
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
