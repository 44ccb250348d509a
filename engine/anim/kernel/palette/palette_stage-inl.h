#if defined(THRONG_KERNEL_PALETTE_STAGE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_PALETTE_STAGE_INL_H
#undef THRONG_KERNEL_PALETTE_STAGE_INL_H
#else
#define THRONG_KERNEL_PALETTE_STAGE_INL_H
#endif

#include <cstdint>
#include <cstring>
#include <type_traits>

#include "engine/anim/kernel/lanes/transpose-inl.h"
#include "engine/anim/kernel/palette/model_palette.h"
#include "engine/anim/kernel/palette/palette_hash.h"
#include "engine/base/compiler.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

inline bool on_whole_lines(const PaletteDestination* palettes, int characters) {
  std::uintptr_t addresses = 0;
  for (int i = 0; i < characters; ++i) addresses |= reinterpret_cast<std::uintptr_t>(palettes[i].memory());
  return addresses % 64 == 0;
}

/// The way in which one vector of characters writes a packet.
struct AnyPacket {
  int characters;
  StorePolicy stores;
  bool displaced;
  bool hashed;
};

inline AnyPacket any_packet(const ModelPaletteJob& job, int lane, int lanes) {
  AnyPacket packet{.characters = HWY_MIN(job.characters - lane, lanes),
                   .stores = job.stores,
                   .displaced = job.displaced != 0,
                   .hashed = job.hashes != nullptr};
  if (packet.stores == StorePolicy::streaming && !on_whole_lines(job.palettes + lane, packet.characters)) {
    packet.stores = StorePolicy::plain;
  }
  return packet;
}

/// The usual case, known to the compiler: a character in every lane and no hashes. It frees registers.
template <int lanes, StorePolicy policy, bool with_positions>
struct UsualPacket {
  static constexpr int characters = lanes;
  static constexpr StorePolicy stores = policy;
  static constexpr bool displaced = with_positions;
  static constexpr bool hashed = false;
};

/// Calls write() with a UsualPacket that is the same, or with `packet`.
template <int lanes, class Write>
HWY_INLINE void write_as_usual(const AnyPacket& packet, Write&& write) {
  const bool usual = packet.characters == lanes && !packet.hashed;
  if (usual && packet.stores == StorePolicy::prefetched) {
    if (packet.displaced) return write(UsualPacket<lanes, StorePolicy::prefetched, true>());
    return write(UsualPacket<lanes, StorePolicy::prefetched, false>());
  }
  if (usual && packet.stores == StorePolicy::streaming) {
    if (packet.displaced) return write(UsualPacket<lanes, StorePolicy::streaming, true>());
    return write(UsualPacket<lanes, StorePolicy::streaming, false>());
  }
  write(packet);
}

inline constexpr int matrix_floats = sizeof(PaletteMatrix) / sizeof(float);
inline constexpr int matrix_rows = sizeof(PaletteMatrix) / 16;
inline constexpr int packed_rows = sizeof(PackedPaletteEntry) / 16;
template <int rows>
using PaletteEntryOf = std::conditional_t<rows == matrix_rows, PaletteMatrix, PackedPaletteEntry>;

/// Memory of a PaletteStage. It lies outside the stage, so that the compiler keeps the stage in registers.
template <class D, int rows>
struct PaletteStageMemory {
  static constexpr int group_floats = 4 * rows * block_floats * lane_count<D>;
  alignas(64) FloatArray<group_floats> groups[2];
  alignas(64) float* group_lines[static_cast<std::size_t>(lane_count<D>)];  // destinations of the group that is put
};

/// Collects palette entries, each `rows` of 16 bytes, in groups of four and writes them as whole cache lines. Lines of
/// a character are written in ascending order, so that the destination may be write-combined memory. While one group
/// is put, a part of the previous group is written after each entry, so that memory receives lines evenly and not in
/// bursts.
///
///     group = [character % 4][entry][row] of (character / 4 blocks of 4 floats)      vectors of 4 lanes and more
///           = [character][entry][row] of 4 floats                                    narrower ones
template <class D, int rows, class Packet>
class PaletteStage {
 public:
  static constexpr int lanes = lane_count<D>;
  static constexpr int entries = 4;
  using Memory = PaletteStageMemory<D, rows>;

  /// `palettes` is [packet.characters]. Entries are written from `first` on.
  HWY_INLINE PaletteStage(const PaletteDestination* palettes, Packet packet, int first, Memory& memory)
      : packet_(packet), group_lines_(memory.group_lines), put_(memory.groups[0]), written_(memory.groups[1]) {
    for (int i = 0; i < packet_.characters; ++i) {
      group_lines_[i] = reinterpret_cast<float*>(palettes[i].memory()) + first * entry_floats;
    }
  }

  template <class V>
  HWY_INLINE void put(D d, int entry, const Matrices<V>& m, const Vectors<V>& translation) {
    put_row(d, entry, 0, m.x, translation.x);
    put_row(d, entry, 1, m.y, translation.y);
    put_row(d, entry, 2, m.z, translation.z);
  }

  template <class V>
  HWY_INLINE void put_row(D d, int entry, int row, const Vectors<V>& xyz, V w) {
    if constexpr (lanes >= block_floats) {
      const auto characters = transpose_blocks(d, xyz.x, xyz.y, xyz.z, w);
      float* const to = put_ + (entry * rows + row) * lanes;
      for (int k = 0; k < 4; ++k) hn::Store(characters.v[k], d, to + k * entries * rows * lanes);
    } else {
      alignas(16) FloatArray<lanes> components[4];
      hn::Store(xyz.x, d, components[0]);
      hn::Store(xyz.y, d, components[1]);
      hn::Store(xyz.z, d, components[2]);
      hn::Store(w, d, components[3]);
      for (int lane = 0; lane < lanes; ++lane) {
        for (int k = 0; k < 4; ++k) put_[((lane * entries + entry) * rows + row) * 4 + k] = components[k][lane];
      }
    }
  }

  /// Ends a group that is complete. It is written from now on, and the next one is put.
  HWY_INLINE void turn() {
    float* const written = written_;
    written_ = put_;
    put_ = written;
    for (int i = 0; i < packet_.characters; ++i) group_lines_[i] += group_stride;
  }

  /// Prefetches the lines that a part of the characters will write of the group that is put.
  HWY_INLINE void prefetch(int part) const {
    for (int character = part; character < packet_.characters; character += entries) {
      const float* line = group_lines_[character];
      for (int at = 0; at < group_stride; at += line_floats) throng::prefetch(line + at);
    }
  }

  /// Writes the previous group for a part of the characters.
  HWY_INLINE void write_part(int part) const {
    if (all_together()) return write_lines_of_four(part, lines);
    for (int character = part; character < packet_.characters; character += entries) write_lines(character, lines);
  }

  /// Writes `count` entries of the previous group for all characters.
  HWY_INLINE void write(int count) const {
    const int whole_lines = count * entry_floats / line_floats;
    if (all_together()) {
      for (int k = 0; k < 4; ++k) write_lines_of_four(k, whole_lines);
    } else {
      for (int i = 0; i < packet_.characters; ++i) write_lines(i, whole_lines);
    }
    for (int i = 0; i < packet_.characters; ++i) write_rows(i, 4 * whole_lines, rows * count);
  }

  /// Adds the hashes of `count` entries of the previous group.
  void add_hashes(const std::int16_t* joints, int count, std::uint64_t* hashes) const {
    if constexpr (lanes >= block_floats) {
      add_hashes_by_fours(joints, count, hashes);
    } else {
      add_hashes_one_by_one(joints, count, hashes);
    }
  }

 private:
  static constexpr int entry_floats = rows * block_floats;
  static constexpr int line_floats = 16;
  static constexpr int group_stride = entries * entry_floats;
  static constexpr int lines = group_stride / line_floats;

  /// Computes palette_entry_hash of a row of every fourth character at a time.
  void add_hashes_by_fours(const std::int16_t* joints, int count, std::uint64_t* hashes) const {
    const hn::RebindToUnsigned<D> words;
    const hn::RepartitionToWide<decltype(words)> sums;
    using Sums = hn::Vec<decltype(sums)>;
    Sums sum[4] = {hn::Zero(sums), hn::Zero(sums), hn::Zero(sums), hn::Zero(sums)};
    for (int entry = 0; entry < count; ++entry) {
      const auto factor = hn::Set(words, palette_hash_factor(static_cast<std::uint32_t>(joints[entry])));
      for (int row = 0; row < rows; ++row) {
        const auto keys = hn::Mul(hn::LoadDup128(words, palette_hash_keys + row * block_floats), factor);
        for (int k = 0; k < 4; ++k) {
          const float* const from = written_ + ((k * entries + entry) * rows + row) * lanes;
          const auto keyed = hn::Add(hn::BitCast(words, hn::Load(D(), from)), keys);
          const auto next = hn::BitCast(words, hn::ShiftRight<32>(hn::BitCast(sums, keyed)));
          sum[k] = hn::Add(sum[k], hn::MulEven(keyed, next));
        }
      }
    }
    for (int k = 0; k < 4; ++k) {
      alignas(64) std::uint64_t halves[std::size_t{lanes / 2}];
      hn::Store(sum[k], sums, halves);
      for (int character = k; character < packet_.characters; character += 4) {
        hashes[character] += halves[character / 4 * 2] + halves[character / 4 * 2 + 1];
      }
    }
  }

  void add_hashes_one_by_one(const std::int16_t* joints, int count, std::uint64_t* hashes) const {
    for (int character = 0; character < packet_.characters; ++character) {
      for (int entry = 0; entry < count; ++entry) {
        FloatArray<entry_floats> written;
        for (int row = 0; row < rows; ++row) {
          std::memcpy(written + row * block_floats, row_of(character, entry * rows + row),
                      block_floats * sizeof(float));
        }
        hashes[character] += palette_entry_hash(static_cast<std::uint32_t>(joints[entry]), entry_of(written));
      }
    }
  }

  /// Returns whether there are 16 characters, whose lines one transposition gives.
  bool all_together() const { return lanes == 16 && packet_.characters == lanes; }

  /// The destination of the previous group.
  float* written_lines(int character) const { return group_lines_[character] - group_stride; }

  static PaletteEntryOf<rows> entry_of(const float* floats) {
    PaletteEntryOf<rows> entry;
    std::memcpy(&entry, floats, sizeof(entry));
    return entry;
  }

  /// Row `index` (entry * rows + row) of one character.
  const float* row_of(int character, int index) const {
    if constexpr (lanes >= block_floats) {
      return written_ + (character % 4 * entries * rows + index) * lanes + character / 4 * block_floats;
    } else {
      return written_ + (character * entries * rows + index) * block_floats;
    }
  }

  HWY_INLINE void write_vector(hn::Vec<D> vector, float* out) const {
    const D d;
    if (packet_.stores == StorePolicy::streaming) {
      hn::Stream(vector, d, out);
    } else {
      hn::StoreU(vector, d, out);
    }
  }

  /// The first lines of characters k, 4 + k, 8 + k and 12 + k of sixteen.
  HWY_INLINE void write_lines_of_four(int k, int count) const {
    if constexpr (lanes == 16) {
      const D d;
      const float* in = written_ + k * entries * rows * lanes;
      float* to[4];  // copied, since the compiler would read them again after each store
      for (int b = 0; b < 4; ++b) to[b] = written_lines(4 * b + k);
      for (int line = 0; line < count; ++line, in += 4 * lanes) {
        const auto four = transpose_whole_blocks(hn::Load(d, in), hn::Load(d, in + lanes), hn::Load(d, in + 2 * lanes),
                                                 hn::Load(d, in + 3 * lanes));
        for (int b = 0; b < 4; ++b) write_vector(four.v[b], to[b] + line * line_floats);
      }
    }
  }

  HWY_INLINE void write_lines(int character, int count) const {
    if constexpr (lanes >= block_floats) {
      const D d;
      float* const out = written_lines(character);
      for (int at = 0; at < count * line_floats; at += lanes) {
        write_vector(load_blocks(d, row_of(character, at / block_floats), lanes), out + at);
      }
    } else {
      write_rows(character, 0, 4 * count);
    }
  }

  /// Rows [begin, end) of a character.
  HWY_INLINE void write_rows(int character, int begin, int end) const {
    float* const out = written_lines(character);
    for (int row = begin; row < end; ++row) {
      std::memcpy(out + row * block_floats, row_of(character, row), block_floats * sizeof(float));
    }
  }

  Packet packet_;
  float** group_lines_;  // [lanes]
  float* put_;
  float* written_;
};

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
