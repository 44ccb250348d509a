#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace throng {

/// The things that a reader of trajectories finds odd, without refusing the file.
enum class TrackOddity : std::uint8_t {
  bad_row,    ///< skipped, with --lenient
  duplicate,  ///< a person has two rows at one time; the last one counts
  gap,        ///< a person has no row for longer than three rows of others
  teleport,   ///< a person goes faster than 12 metres a second
  overlap,    ///< two people stand on each other: closer than 0.1 metres; each pair counts once; a crowd of more
              ///< than 150,000 rows is searched in some of its frames
};

/// Counts how often an oddity was found, and says where first.
struct OddityCount {
  TrackOddity oddity{};
  std::size_t count = 0;
  std::string first;  ///< "person 7 at 3.20 s: 4.1 m in 0.04 s"
};

/// All oddities that were found, each kind at most once, in the order of TrackOddity.
struct TrackReport {
  std::vector<OddityCount> found;
};

}  // namespace throng
