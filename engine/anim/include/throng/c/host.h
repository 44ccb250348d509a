#ifndef THRONG_C_HOST_H
#define THRONG_C_HOST_H

/* What a host may do in the library's place; host.h says what it promises. Each function gets the `user` that it was
 * set with. */

/* NOLINTBEGIN: this is C, also where a C++ compiler reads it */
#include "throng/c/base.h"

typedef void (*throng_misuse_hook)(const char* call, const char* reason, void* user);
/* Sets the function that hears of calls that break their contract; null: one line each on standard error. */
THRONG_C void throng_set_misuse_hook(throng_misuse_hook hook, void* user);

/* Runs job(context, 0) to job(context, count - 1), each once, and returns when all are done. */
typedef void (*throng_job)(void* context, int index);
typedef void (*throng_executor)(int count, throng_job job, void* context, void* user);

typedef void* (*throng_allocate)(size_t bytes, size_t alignment, void* user);
typedef void (*throng_release)(void* memory, size_t bytes, size_t alignment, void* user);
/* Sets the functions that give large memory from now on, both or neither. No other thread is in the library then. */
THRONG_C int throng_set_memory_hooks(throng_allocate allocate, throng_release release, void* user);

typedef void (*throng_thread_hook)(int pu, void* user);
/* Sets the function that each new thread calls first, with the number of its PU; null: none. */
THRONG_C void throng_set_thread_hook(throng_thread_hook hook, void* user);

typedef void (*throng_begin_zone)(const char* name, int pu, void* user);
typedef void (*throng_end_zone)(int pu, void* user);
/* Sets the functions that hear of zones, for a profiler: both, or neither. No thread is in the library then. */
THRONG_C int throng_set_zone_hooks(throng_begin_zone begin, throng_end_zone end, void* user);

/* NOLINTEND */
#endif
