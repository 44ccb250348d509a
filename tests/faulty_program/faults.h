#pragma once

#include <cstddef>
#include <cstdint>

namespace throng::test {

/// A call to the system, or to the graphics device, that can fail without anyone's mistake.
enum class Call : std::uint8_t { allocation, open, read, write, rename, map, thread, gl };

inline constexpr std::size_t call_kinds = 8;

/// Names of the kinds, in their order.
inline constexpr const char* call_names[call_kinds] = {"allocation", "open", "read",   "write",
                                                       "rename",     "map",  "thread", "gl"};

/// Counts a call and says whether it has to fail. Any thread may call it; it takes no memory and no lock.
///
/// THRONG_FAULT in the environment says which: "write:3" the third write alone, "write:3+" the third and all that
/// follow. Calls before main() and after its end are not counted. At the end of the program the file that
/// THRONG_FAULT_COUNTS names gets a line for each kind, "write 17", so that the next run knows how far it can go.
bool must_fail(Call kind);

/// Makes calls of GL fail from now on, where THRONG_FAULT says so. Call it when glad has loaded its functions.
void wrap_gl_functions();

}  // namespace throng::test
