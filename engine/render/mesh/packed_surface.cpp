#include "engine/render/mesh/packed_surface.h"

#include <algorithm>
#include <cstring>

namespace throng::render {
namespace {

constexpr std::size_t array_alignment = alignof(PackedSurface);

/// Appends arrays, each from a multiple of array_alignment.
class ArrayWriter {
 public:
  template <typename T>
  void add(std::span<const T> elements) {
    bytes_.resize((bytes_.size() + array_alignment - 1) / array_alignment * array_alignment);
    const std::span<const std::byte> bytes = std::as_bytes(elements);
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  }
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

/// Finds the arrays again. An array that does not fit leaves this and all that follow empty.
class ArrayReader {
 public:
  explicit ArrayReader(std::span<const std::byte> bytes) : bytes_(bytes), at_(sizeof(PackedSurface)) {}

  template <typename T>
  std::span<const T> take(std::size_t count) {
    at_ = (at_ + array_alignment - 1) / array_alignment * array_alignment;
    if (failed_ || at_ > bytes_.size() || count > (bytes_.size() - at_) / sizeof(T))
      return failed_ = true, std::span<const T>();
    const auto* first = reinterpret_cast<const T*>(bytes_.data() + at_);
    at_ += count * sizeof(T);
    return {first, count};
  }
  bool read_all() const { return !failed_ && at_ == bytes_.size(); }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_;
  bool failed_ = false;
};

std::uint32_t count_of(std::size_t size) { return static_cast<std::uint32_t>(size); }

/// Deals out the runs of all LODs and levels. A run that is not there leaves `failed` true.
class RunDealer {
 public:
  RunDealer(std::span<const MaterialRun> runs, std::span<const PackedSurfaceLod> lods) : runs_(runs), lods_(lods) {}

  /// Gives the next `count` levels to a piece; none where there are not so many.
  void deal(std::size_t count, SurfacePiece& piece) {
    if (count > lods_.size()) failed_ = true, count = 0;
    for (const PackedSurfaceLod& lod : lods_.first(count)) {
      if (lod.runs > runs_.size()) failed_ = true;
      if (failed_) return;
      piece.runs_by_level.emplace_back(runs_.begin(), runs_.begin() + lod.runs);
      piece.triangles_by_level.push_back(lod.triangles);
      piece.error_by_level.push_back(lod.error);
      runs_ = runs_.subspan(lod.runs);
    }
    lods_ = lods_.subspan(count);
  }
  bool dealt_all() const { return !failed_ && runs_.empty() && lods_.empty(); }

 private:
  std::span<const MaterialRun> runs_;
  std::span<const PackedSurfaceLod> lods_;
  bool failed_ = false;
};

/// Returns false if there are not as many of anything as there should be.
bool deal_runs(RunDealer dealer, std::span<const PackedSurfacePiece> pieces, SurfaceParts& parts) {
  for (const PackedSurfacePiece& packed : pieces) {
    if (packed.levels == 0 || packed.levels > largest_mesh_lod_count) return false;
    SurfacePiece& piece = parts.pieces.emplace_back();
    piece.first_lod = packed.first_lod;
    dealer.deal(packed.levels, piece);
  }
  return dealer.dealt_all();
}

bool lies_within(const MaterialRun& run, std::size_t indices) {
  return run.first_index <= indices && run.index_count <= indices - run.first_index;
}

}  // namespace

std::vector<std::byte> pack_surface(const SurfaceView& surface) {
  std::vector<MaterialRun> runs;
  std::vector<PackedSurfaceLod> lods;
  std::vector<PackedSurfacePiece> pieces;
  for (const SurfacePiece& piece : surface.pieces) {
    pieces.push_back({piece.first_lod, count_of(piece.runs_by_level.size())});
    for (std::size_t level = 0; level < piece.runs_by_level.size(); ++level) {
      const std::vector<MaterialRun>& of_level = piece.runs_by_level[level];
      runs.insert(runs.end(), of_level.begin(), of_level.end());
      lods.push_back({count_of(of_level.size()), piece.triangles_by_level[level], piece.error_by_level[level]});
    }
  }
  const std::size_t levels = surface.vertices.empty() ? 0 : surface.entries.size() / surface.vertices.size();
  const PackedSurface header{.layout = packed_surface_layout,
                             .detail_coords = count_of(surface.detail_coords.size()),
                             .levels = count_of(levels),
                             .indices = count_of(surface.indices.size()),
                             .runs = count_of(runs.size()),
                             .vertices = count_of(surface.vertices.size()),
                             .lods = pieces.front().levels,
                             .vertex_count = surface.vertex_count,
                             .first_bone_end = surface.first_bone_end,
                             .bone_end_count = surface.bone_end_count,
                             .tangents = count_of(surface.tangents.size()),
                             .pieces = count_of(pieces.size() - 1)};
  ArrayWriter writer;
  writer.add(std::span(&header, 1));
  writer.add(surface.vertices);
  writer.add(surface.detail_coords);
  writer.add(surface.tangents);
  writer.add(surface.entries);
  writer.add(surface.indices);
  writer.add(std::span<const MaterialRun>(runs));
  writer.add(std::span<const PackedSurfacePiece>(pieces).subspan(1));
  writer.add(std::span<const PackedSurfaceLod>(lods));
  return writer.take();
}

Result<SurfaceView> view_packed_surface(std::span<const std::byte> packed) {
  const Error damaged{"its packed surface is damaged; bake it again"};
  PackedSurface header;
  if (packed.size() < sizeof header) return damaged;
  std::memcpy(&header, packed.data(), sizeof header);
  if (header.layout != packed_surface_layout) {
    return Error{"its packed surface is of another version of throng; bake it again"};
  }
  ArrayReader reader(packed);
  SurfaceView surface;
  surface.vertices = reader.take<SurfaceVertex>(header.vertices);
  surface.detail_coords = reader.take<DetailCoords>(header.detail_coords);
  surface.tangents = reader.take<PackedTangent>(header.tangents);
  surface.entries = reader.take<PaletteEntries>(std::size_t{header.levels} * header.vertices);
  surface.indices = reader.take<std::uint32_t>(header.indices);
  const auto runs = reader.take<MaterialRun>(header.runs);
  std::vector<PackedSurfacePiece> pieces{{.first_lod = 0, .levels = header.lods}};
  const auto worn = reader.take<PackedSurfacePiece>(header.pieces);
  pieces.insert(pieces.end(), worn.begin(), worn.end());
  std::size_t lods = 0;
  for (const PackedSurfacePiece& piece : pieces) lods += piece.levels;
  const RunDealer dealer(runs, reader.take<PackedSurfaceLod>(lods));
  surface.vertex_count = header.vertex_count;
  surface.first_bone_end = header.first_bone_end;
  surface.bone_end_count = header.bone_end_count;
  const auto fits = [&](const MaterialRun& run) { return lies_within(run, surface.indices.size()); };
  if (!reader.read_all() || !deal_runs(dealer, pieces, surface) || !std::ranges::all_of(runs, fits)) return damaged;
  return surface;
}

Result<SurfaceParts> surface_parts(const CrowdMeshData& data) {
  if (data.packed_surface.empty()) return static_cast<SurfaceParts>(build_surface(data));
  const Result<SurfaceView> packed = view_packed_surface(data.packed_surface);
  if (!packed) return packed.error();
  return static_cast<SurfaceParts>(*packed);
}

}  // namespace throng::render
