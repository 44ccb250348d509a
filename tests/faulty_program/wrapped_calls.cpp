// What the linker calls in place of the functions that CMakeLists.txt lists for --wrap: each fails as the system would.
#include <cerrno>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <new>

#include <dirent.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/faulty_program/faults.h"

using throng::test::Call;
using throng::test::must_fail;

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

void* __wrap_malloc(std::size_t size) {
  if (!must_fail(Call::allocation)) return __real_malloc(size);
  errno = ENOMEM;
  return nullptr;
}

void* __wrap_calloc(std::size_t count, std::size_t size) {
  if (!must_fail(Call::allocation)) return __real_calloc(count, size);
  errno = ENOMEM;
  return nullptr;
}

void* __wrap_realloc(void* old, std::size_t size) {
  if (!must_fail(Call::allocation)) return __real_realloc(old, size);
  errno = ENOMEM;
  return nullptr;
}

void* __wrap_aligned_alloc(std::size_t alignment, std::size_t size) {
  if (!must_fail(Call::allocation)) return __real_aligned_alloc(alignment, size);
  errno = ENOMEM;
  return nullptr;
}

int __wrap_posix_memalign(void** result, std::size_t alignment, std::size_t size) {
  return must_fail(Call::allocation) ? ENOMEM : __real_posix_memalign(result, alignment, size);
}

int __wrap_open(const char* path, int flags, ...) {
  std::va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  if (!must_fail(Call::open)) return __real_open(path, flags, mode);
  errno = EMFILE;
  return -1;
}

int __wrap_openat(int folder, const char* path, int flags, ...) {
  std::va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  if (!must_fail(Call::open)) return __real_openat(folder, path, flags, mode);
  errno = EMFILE;
  return -1;
}

FILE* __wrap_fopen(const char* path, const char* mode) {
  if (!must_fail(Call::open)) return __real_fopen(path, mode);
  errno = EMFILE;
  return nullptr;
}

DIR* __wrap_opendir(const char* path) {
  if (!must_fail(Call::open)) return __real_opendir(path);
  errno = EMFILE;
  return nullptr;
}

ssize_t __wrap_read(int descriptor, void* bytes, std::size_t count) {
  if (!must_fail(Call::read)) return __real_read(descriptor, bytes, count);
  errno = EIO;
  return -1;
}

// Words about what failed must come through.
ssize_t __wrap_write(int descriptor, const void* bytes, std::size_t count) {
  if (descriptor == STDERR_FILENO || !must_fail(Call::write)) return __real_write(descriptor, bytes, count);
  errno = ENOSPC;
  return -1;
}

int __wrap_fsync(int descriptor) {
  if (!must_fail(Call::write)) return __real_fsync(descriptor);
  errno = EIO;
  return -1;
}

int __wrap_rename(const char* from, const char* to) {
  if (!must_fail(Call::rename)) return __real_rename(from, to);
  errno = EIO;
  return -1;
}

void* __wrap_mmap(void* address, std::size_t length, int protection, int flags, int descriptor, off_t offset) {
  if (!must_fail(Call::map)) return __real_mmap(address, length, protection, flags, descriptor, offset);
  errno = ENOMEM;
  return MAP_FAILED;
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
