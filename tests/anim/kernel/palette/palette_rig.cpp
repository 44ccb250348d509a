#include "tests/anim/kernel/palette/palette_rig.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <type_traits>

namespace throng::anim::kernel_rig {
namespace {

constexpr std::size_t guard_entries = 2;
constexpr unsigned char guard_byte = 0xA5;

/// One character's palette slot: 64-byte aligned, or only 16-byte aligned; guards before and after.
template <typename Entry>
class GuardedPalette {
 public:
  GuardedPalette(std::size_t entries, bool whole_lines) : storage_(entries + 3 * guard_entries + 8) {
    std::memset(storage_.data(), guard_byte, storage_.size() * sizeof(Entry));
    const auto address = reinterpret_cast<std::uintptr_t>(storage_.data());
    while ((address + offset_ * sizeof(Entry)) % 64 != 0 || offset_ < guard_entries) ++offset_;
    if (!whole_lines) ++offset_;
  }
  Entry* entries() { return storage_.data() + offset_; }
  std::vector<Entry> copy(std::size_t count) const {
    const auto first = storage_.begin() + static_cast<std::ptrdiff_t>(offset_);
    return {first, first + static_cast<std::ptrdiff_t>(count)};
  }
  bool intact_outside(std::size_t count) const {
    const auto* bytes = reinterpret_cast<const unsigned char*>(storage_.data());
    const std::size_t begin = offset_ * sizeof(Entry);
    const std::size_t end = begin + count * sizeof(Entry);
    for (std::size_t i = 0; i < storage_.size() * sizeof(Entry); ++i) {
      if ((i < begin || i >= end) && bytes[i] != guard_byte) return false;
    }
    return true;
  }

 private:
  std::size_t offset_ = 0;
  std::vector<Entry> storage_;
};

std::size_t entries_below(const HierarchyProgram& program, int bone_count) {
  std::size_t count = 0;
  for (int bone = 0; bone < bone_count; ++bone) {
    count += static_cast<std::size_t>(program.steps[static_cast<std::size_t>(bone)].entry_count);
  }
  return count;
}

struct alignas(64) Line {
  float floats[16];
};

/// Scratch of one strip, as a PU would lay it out.
struct Strip {
  Strip(int width, int components, int slots)
      : local(static_cast<std::size_t>(width * components)),
        carry(static_cast<std::size_t>(branch_slot_floats * width)),
        slots_(static_cast<std::size_t>(std::max(slots, 1) * branch_slot_floats * width)) {}
  std::vector<Line> local, carry, slots_;
};

/// Joints of each character; the last place is of lanes that nobody has.
class JointLines {
 public:
  JointLines(std::size_t characters, std::size_t floats)
      : characters_(characters), each_(floats / 16 + 1), lines_((characters + 1) * each_) {}
  float* of(std::size_t character) { return lines_[std::min(character, characters_) * each_].floats; }

 private:
  std::size_t characters_, each_;
  std::vector<Line> lines_;
};

}  // namespace

template <typename Entry>
CrowdResultOf<Entry> compute_palettes_of(const Kernels& kernels, const HierarchyProgram& program,
                                         const std::vector<StatePose>& characters, int width, int bone_count,
                                         const PaletteRequest& request) {
  const std::size_t entries = entries_below(program, bone_count);
  std::vector<GuardedPalette<Entry>> palettes;
  palettes.reserve(characters.size());
  for (std::size_t i = 0; i < characters.size(); ++i) {
    palettes.emplace_back(entries_below(program, program.bone_count), request.whole_lines || i % 2 == 0);
  }

  CrowdResultOf<Entry> result;
  result.hashes.assign(characters.size(), 0);
  const int components = characters.front().components();
  Strip strip(width, components, program.slot_count);
  const std::size_t joint_floats = request.joints == nullptr ? 0 : request.joints->bytes / sizeof(float);
  JointLines joints(characters.size(), joint_floats);
  for (std::size_t first = 0; first < characters.size(); first += static_cast<std::size_t>(width)) {
    ModelPaletteJob job;
    job.hierarchy = &program;
    job.bone_count = bone_count;
    job.width = width;
    job.stores = request.stores;
    job.displaced = request.displaced;
    job.format = std::is_same_v<Entry, PackedPaletteEntry> ? PaletteFormat::packed : PaletteFormat::matrices;
    job.characters = static_cast<int>(std::min(characters.size() - first, static_cast<std::size_t>(width)));
    job.local = strip.local.front().floats;
    job.carry = strip.carry.front().floats;
    job.branch_slots = strip.slots_.front().floats;
    std::array<PaletteDestination, widest_strip> destinations{};
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(job.characters); ++lane) {
      destinations[lane] = palettes[first + lane].entries();
    }
    job.palettes = destinations.data();
    std::array<float*, widest_strip> joints_to{};
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(width); ++lane)
      joints_to[lane] = joints.of(first + lane);
    job.joints = request.joints;
    job.joints_to = joints_to.data();
    if (request.hashed) job.hashes = result.hashes.data() + first;
    for (job.packet = 0; job.packet < packets_for(bone_count); ++job.packet) {
      for (int lane = 0; lane < width; ++lane) {
        const std::size_t character = std::min(first + static_cast<std::size_t>(lane), characters.size() - 1);
        std::memcpy(strip.local[static_cast<std::size_t>(lane) * static_cast<std::size_t>(components)].floats,
                    characters[character].packet(job.packet), packet_bytes(components));
      }
      kernels.model_palette(job);
    }
  }
  kernels.fence_stores();
  for (const GuardedPalette<Entry>& palette : palettes) {
    result.palettes.push_back(palette.copy(entries));
    result.guards_intact = result.guards_intact && palette.intact_outside(entries);
  }
  for (std::size_t i = 0; i < characters.size() && joint_floats > 0; ++i) {
    result.joints.emplace_back(joints.of(i), joints.of(i) + joint_floats);
  }
  return result;
}

CrowdResult compute_palettes(const Kernels& kernels, const HierarchyProgram& program,
                             const std::vector<StatePose>& characters, int width, int bone_count,
                             const PaletteRequest& request) {
  return compute_palettes_of<PaletteMatrix>(kernels, program, characters, width, bone_count, request);
}

PackedCrowdResult compute_packed_palettes(const Kernels& kernels, const HierarchyProgram& program,
                                          const std::vector<StatePose>& characters, int width, int bone_count,
                                          const PaletteRequest& request) {
  return compute_palettes_of<PackedPaletteEntry>(kernels, program, characters, width, bone_count, request);
}

bool same_bits(const std::vector<PackedPaletteEntry>& a, const std::vector<PackedPaletteEntry>& b) {
  return std::ranges::equal(
      a, b, [](const auto& left, const auto& right) { return std::ranges::equal(left.words, right.words); });
}

bool same_bits(const std::vector<PaletteMatrix>& a, const std::vector<PaletteMatrix>& b) {
  using Bits = std::array<std::uint32_t, sizeof(PaletteMatrix) / 4>;
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const PaletteMatrix& left, const PaletteMatrix& right) {
    return std::bit_cast<Bits>(left) == std::bit_cast<Bits>(right);
  });
}

}  // namespace throng::anim::kernel_rig
