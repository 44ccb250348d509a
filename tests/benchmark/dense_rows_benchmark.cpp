// Rows of a sampled stream that hold moving lanes only, beside the padded rows that it has: the same arithmetic on 16
// rotations, once from two padded rows and once from two dense ones, whose 64-bit lanes (one component of four bones)
// AVX-512 expands over those that stand still. See engine/anim/asset/README.md for what was measured.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>

#if defined(__x86_64__)
#include <immintrin.h>

#define THRONG_WITH_AVX512 __attribute__((target("avx512f,avx512bw,avx512dq,avx512vl,fma")))

namespace throng::anim {
namespace {

constexpr int rows = 40;
constexpr int packets = 4;
constexpr int group_words = 64;                      // four components of 16 bones
constexpr int group_lanes = group_words * 2 / 8;     // of 64 bits
constexpr int padded_words = packets * group_words;  // a row
constexpr float unit = -1.0F / 32768.0F / 32767.0F;

/// A clip of four packets in which `moving` of each packet's 16 lanes move, as both kinds of rows.
struct Clip {
  Clip(int moving, std::size_t number) {
    std::mt19937 random(static_cast<unsigned>(number));
    std::array<int, group_lanes> order{};
    for (std::uint16_t& mask : masks) {
      std::iota(order.begin(), order.end(), 0);
      std::shuffle(order.begin(), order.end(), random);
      for (int i = 0; i < moving; ++i)
        mask = static_cast<std::uint16_t>(mask | (1U << order.at(static_cast<std::size_t>(i))));
    }
    still.resize(padded_words);
    for (std::int16_t& word : still) word = static_cast<std::int16_t>(16000 + random() % 768);
    for (int row = 0; row < rows; ++row) add_row(random);
    dense.resize(dense.size() + group_words);  // loads of whole vectors may reach behind the last lane
  }

  void add_row(std::mt19937& random) {
    for (int packet = 0; packet < packets; ++packet) {
      for (int lane = 0; lane < group_lanes; ++lane) {
        const bool moves = (masks[static_cast<std::size_t>(packet)] >> lane & 1U) != 0;
        for (int word = 0; word < 4; ++word) {
          const auto at = static_cast<std::size_t>(packet * group_words + lane * 4 + word);
          const auto value = moves ? static_cast<std::int16_t>(16000 + random() % 768) : still[at];
          padded.push_back(value);
          if (moves) dense.push_back(value);
        }
      }
    }
  }
  std::size_t dense_words() const { return (dense.size() - group_words) / rows; }

  std::array<std::uint16_t, packets> masks{};
  std::vector<std::int16_t> still;   // [packet][64]
  std::vector<std::int16_t> padded;  // [row][packet][64]
  std::vector<std::int16_t> dense;   // [row][moving lanes]
};

struct Group {
  __m512i low, high;  // x and y, z and w
};

THRONG_WITH_AVX512 inline Group load_padded(const std::int16_t* words) {
  return {_mm512_loadu_si512(words), _mm512_loadu_si512(words + 32)};
}

/// From the first moving lane on; the lanes that stand still come from the clip.
THRONG_WITH_AVX512 inline Group load_dense(const std::int16_t* words, unsigned mask, const Group& still) {
  const auto low = static_cast<__mmask8>(mask), high = static_cast<__mmask8>(mask >> 8U);
  return {_mm512_mask_expandloadu_epi64(still.low, low, words),
          _mm512_mask_expandloadu_epi64(still.high, high, words + 4 * std::popcount(mask & 0xFFU))};
}

/// The same with a whole load before the lanes are moved, which writes no memory operand into the shuffle.
THRONG_WITH_AVX512 inline Group load_then_expand(const std::int16_t* words, unsigned mask, const Group& still) {
  const auto low = static_cast<__mmask8>(mask), high = static_cast<__mmask8>(mask >> 8U);
  const __m512i first = _mm512_loadu_si512(words);
  const __m512i second = _mm512_loadu_si512(words + 4 * std::popcount(mask & 0xFFU));
  return {_mm512_mask_expand_epi64(still.low, low, first), _mm512_mask_expand_epi64(still.high, high, second)};
}

/// Unit rotations between two rows, as engine/anim/kernel/pose/sample-inl.h has them.
THRONG_WITH_AVX512 inline void rotations_between(const Group& from, const Group& to, int fraction, float* out) {
  const __m512i weights = _mm512_set1_epi32(static_cast<int>((static_cast<unsigned>(fraction - 32768) & 0xFFFFU) |
                                                             (static_cast<unsigned>(-fraction) << 16U)));
  const auto weigh = [&](__m512i pairs) THRONG_WITH_AVX512 {
    return _mm512_maskz_cvtepi32_ps(0xFFFF, _mm512_madd_epi16(pairs, weights));
  };
  const __m512 x = weigh(_mm512_unpacklo_epi16(from.low, to.low)), y = weigh(_mm512_unpackhi_epi16(from.low, to.low));
  const __m512 z = weigh(_mm512_unpacklo_epi16(from.high, to.high)),
               w = weigh(_mm512_unpackhi_epi16(from.high, to.high));
  const __m512 length = _mm512_fmadd_ps(w, w, _mm512_fmadd_ps(z, z, _mm512_fmadd_ps(y, y, _mm512_mul_ps(x, x))));
  const __m512 lack = _mm512_fnmadd_ps(length, _mm512_set1_ps(unit * unit), _mm512_set1_ps(1.0F));
  __m512 scale = _mm512_fmadd_ps(lack, _mm512_set1_ps(0.37481848F * unit), _mm512_set1_ps(0.37095027F * unit));
  scale = _mm512_fmadd_ps(lack, scale, _mm512_set1_ps(0.50008201F * unit));
  scale = _mm512_fmadd_ps(lack, scale, _mm512_set1_ps(0.99999975F * unit));
  _mm512_store_ps(out, _mm512_mul_ps(x, scale));
  _mm512_store_ps(out + 16, _mm512_mul_ps(y, scale));
  _mm512_store_ps(out + 32, _mm512_mul_ps(z, scale));
  _mm512_store_ps(out + 48, _mm512_mul_ps(w, scale));
}

struct alignas(64) Pose {
  float rotations[packets][4][16];
};

/// Where each of many characters is, in which clip.
struct Moment {
  std::size_t clip;
  int row;
  int fraction;
};
std::vector<Moment> moments(std::size_t clips) {
  std::mt19937 random(1);
  std::vector<Moment> all(1024);
  for (Moment& each : all) {
    each = {random() % clips, static_cast<int>(random() % (rows - 1)), static_cast<int>(random() % 32768U)};
  }
  return all;
}

THRONG_WITH_AVX512 void sample_padded(const Clip& clip, const Moment& at, Pose& pose) {
  const std::int16_t* from = clip.padded.data() + at.row * padded_words;
  for (int packet = 0; packet < packets; ++packet) {
    const std::int16_t* group = from + packet * group_words;
    rotations_between(load_padded(group), load_padded(group + padded_words), at.fraction,
                      &pose.rotations[packet][0][0]);
  }
}

template <Group (*load)(const std::int16_t*, unsigned, const Group&)>
THRONG_WITH_AVX512 void sample_dense(const Clip& clip, const Moment& at, Pose& pose) {
  const auto row_words = static_cast<int>(clip.dense_words());
  const std::int16_t* from = clip.dense.data() + at.row * row_words;
  for (int packet = 0; packet < packets; ++packet) {
    const unsigned mask = clip.masks[static_cast<std::size_t>(packet)];
    const Group still = load_padded(clip.still.data() + packet * group_words);
    rotations_between(load(from, mask, still), load(from + row_words, mask, still), at.fraction,
                      &pose.rotations[packet][0][0]);
    from += 4 * std::popcount(mask);
  }
}

template <void (*sample)(const Clip&, const Moment&, Pose&)>
void run(benchmark::State& state, bool dense) {
  std::vector<Clip> clips;
  const auto clip_count = static_cast<std::size_t>(state.range(1));
  for (std::size_t i = 0; i < clip_count; ++i) clips.emplace_back(static_cast<int>(state.range(0)), i);
  const std::vector<Moment> all = moments(clip_count);
  std::array<Pose, 8> poses{};  // as many as are sampled before any is blended
  for ([[maybe_unused]] const auto& round : state) {
    for (std::size_t i = 0; i < all.size(); ++i) sample(clips[all[i].clip], all[i], poses[i % poses.size()]);
    benchmark::DoNotOptimize(poses);
  }
  const double bones = static_cast<double>(all.size()) * packets * 16;
  state.counters["ns_per_bone"] =
      benchmark::Counter(bones * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["row_bytes"] =
      static_cast<double>(2 * (dense ? clips.front().dense_words() : std::size_t{padded_words}));
}

}  // namespace

void register_dense_rows() {
  if (__builtin_cpu_supports("avx512bw") == 0) return;
  for (const int moving : {16, 10, 4}) {
    const auto add = [moving](const char* name, void (*body)(benchmark::State&, bool), bool dense) {
      benchmark::RegisterBenchmark(name, body, dense)
          ->ArgNames({"moving_lanes", "clips"})
          ->Args({moving, 2})
          ->Args({moving, 76});
    };
    add("rows/padded", run<sample_padded>, false);
    add("rows/dense", run<sample_dense<load_dense>>, true);
    add("rows/dense_loaded_first", run<sample_dense<load_then_expand>>, true);
  }
}

}  // namespace throng::anim

#else

namespace throng::anim {
void register_dense_rows() {}
}  // namespace throng::anim

#endif
