#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

/// What OutputFile asks of the system. Calls fail as POSIX calls do: with -1, and the number of the error in errno.
namespace throng::output_calls {

/// Opens a file that must not be there yet.
int open_new(const std::filesystem::path& file);
/// Opens a device or a pipe, and does not wait for its reader.
int open_straight(const std::filesystem::path& file);
std::ptrdiff_t write(int descriptor, const char* bytes, std::size_t count);
/// Waits until the disk has all of it.
int sync(int descriptor);
int close(int descriptor);
/// Gives an open file the owner and the mode of another one, as far as this process may.
void take_rights(int descriptor, const std::filesystem::path& from);
/// Gives a file the name of another one, which it replaces.
int replace(const std::filesystem::path& part, const std::filesystem::path& file);
/// Returns the numbers of the errors which mean that the disk, or the user's share of it, is full.
std::span<const int> errors_of_a_full_disk();

}  // namespace throng::output_calls
