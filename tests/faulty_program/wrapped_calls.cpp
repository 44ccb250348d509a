// The linker puts these in place of the functions that CMakeLists.txt lists for --wrap. Each fails as the system would.
#include <cerrno>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

#include <dirent.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/faulty_program/faults.h"

using throng::test::Call;
using throng::test::must_fail;

namespace {

/// Returns whether a call has to fail, and leaves the error where the system does.
bool fails(Call kind, int error) {
  const bool failed = must_fail(kind);
  if (failed) errno = error;
  return failed;
}

}  // namespace

// NOLINTBEGIN(bugprone-reserved-identifier, readability-identifier-naming): the linker makes these names
extern "C" {

void* __real_malloc(std::size_t size);
void* __real_calloc(std::size_t count, std::size_t size);
void* __real_realloc(void* old, std::size_t size);
void* __real_aligned_alloc(std::size_t alignment, std::size_t size);
int __real_posix_memalign(void** result, std::size_t alignment, std::size_t size);
int __real_open(const char* path, int flags, ...);
int __real_openat(int folder, const char* path, int flags, ...);
FILE* __real_fopen(const char* path, const char* mode);
DIR* __real_opendir(const char* path);
ssize_t __real_read(int descriptor, void* bytes, std::size_t count);
ssize_t __real_write(int descriptor, const void* bytes, std::size_t count);
int __real_fsync(int descriptor);
int __real_rename(const char* from, const char* to);
void* __real_mmap(void* address, std::size_t length, int protection, int flags, int descriptor, off_t offset);
int __real_pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*), void* argument);
int __real_gladLoadGL(void (*(*load)(const char*))());

void* __wrap_malloc(std::size_t size) { return fails(Call::allocation, ENOMEM) ? nullptr : __real_malloc(size); }

void* __wrap_calloc(std::size_t count, std::size_t size) {
  return fails(Call::allocation, ENOMEM) ? nullptr : __real_calloc(count, size);
}

void* __wrap_realloc(void* old, std::size_t size) {
  return fails(Call::allocation, ENOMEM) ? nullptr : __real_realloc(old, size);
}

void* __wrap_aligned_alloc(std::size_t alignment, std::size_t size) {
  return fails(Call::allocation, ENOMEM) ? nullptr : __real_aligned_alloc(alignment, size);
}

int __wrap_posix_memalign(void** result, std::size_t alignment, std::size_t size) {
  return must_fail(Call::allocation) ? ENOMEM : __real_posix_memalign(result, alignment, size);
}

int __wrap_open(const char* path, int flags, ...) {
  std::va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  return fails(Call::open, EMFILE) ? -1 : __real_open(path, flags, mode);
}

int __wrap_openat(int folder, const char* path, int flags, ...) {
  std::va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  return fails(Call::open, EMFILE) ? -1 : __real_openat(folder, path, flags, mode);
}

FILE* __wrap_fopen(const char* path, const char* mode) {
  return fails(Call::open, EMFILE) ? nullptr : __real_fopen(path, mode);
}

DIR* __wrap_opendir(const char* path) { return fails(Call::open, EMFILE) ? nullptr : __real_opendir(path); }

ssize_t __wrap_read(int descriptor, void* bytes, std::size_t count) {
  return fails(Call::read, EIO) ? -1 : __real_read(descriptor, bytes, count);
}

// Words about what failed must come through.
ssize_t __wrap_write(int descriptor, const void* bytes, std::size_t count) {
  const bool failed = descriptor != STDERR_FILENO && fails(Call::write, ENOSPC);
  return failed ? -1 : __real_write(descriptor, bytes, count);
}

int __wrap_fsync(int descriptor) { return fails(Call::write, EIO) ? -1 : __real_fsync(descriptor); }

int __wrap_rename(const char* from, const char* to) { return fails(Call::rename, EIO) ? -1 : __real_rename(from, to); }

void* __wrap_mmap(void* address, std::size_t length, int protection, int flags, int descriptor, off_t offset) {
  return fails(Call::map, ENOMEM) ? MAP_FAILED : __real_mmap(address, length, protection, flags, descriptor, offset);
}

int __wrap_pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*), void* argument) {
  return must_fail(Call::thread) ? EAGAIN : __real_pthread_create(thread, attributes, run, argument);
}

int __wrap_gladLoadGL(void (*(*load)(const char*))()) {
  const int version = __real_gladLoadGL(load);
  throng::test::wrap_gl_functions();
  return version;
}

}  // extern "C"
// NOLINTEND(bugprone-reserved-identifier, readability-identifier-naming)
