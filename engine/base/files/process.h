#pragma once

#include <filesystem>
#include <span>
#include <string_view>

/// This process as its system knows it, and the system's other processes, variables and signals.
namespace throng {

/// The descriptors that a process begins with.
constexpr int standard_input = 0, standard_output = 1, standard_error = 2;

/// Returns the number of this process.
int process_id();
/// Returns whether no process has this number any longer.
bool is_gone(int process);

/// Returns whether a person sees the text that is written there.
bool is_terminal(int descriptor);
/// Returns whether this process may write a file, or make files in a folder. The number of the error is in errno.
bool may_write(const std::filesystem::path& place);

/// Writes to standard error and needs no memory. An error is not said.
void say_without_memory(std::string_view text);

/// Sets a variable of the environment, or takes it away. Call it while no other thread reads or writes one.
void set_variable(const char* name, const char* value);
void clear_variable(const char* name);

/// Sees to it that a pipe without a reader and a file that grows too large are errors of their writer.
void ignore_signals_of_writers();
/// Returns the signals that ask a program to end, as far as the system has them.
std::span<const int> ending_signals();
/// Calls `handler` at this signal, if it is not ignored.
void catch_signal(int signal, void (*handler)(int));
/// Takes this handler away, if the signal calls it.
void release_signal(int signal, void (*handler)(int));

}  // namespace throng
