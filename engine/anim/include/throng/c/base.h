#ifndef THRONG_C_BASE_H
#define THRONG_C_BASE_H

/* What all headers for C share: how functions are declared, ids, places, bounds and errors. */

/* NOLINTBEGIN: this is C, also where a C++ compiler reads it */
#include <stddef.h>
#include <stdint.h>

#if !defined(_WIN32)
#define THRONG_SHOWN __attribute__((visibility("default")))
#elif defined(THRONG_BUILDS_C)
#define THRONG_SHOWN __declspec(dllexport)
#else
#define THRONG_SHOWN __declspec(dllimport)
#endif

#ifdef __cplusplus
#define THRONG_C extern "C" THRONG_SHOWN
#else
#define THRONG_C THRONG_SHOWN
#endif

#define THRONG_NONE UINT32_MAX

/* THRONG_DEFAULT(NAME) declares NAME_default(), which returns a struct with the defaults of the C++ headers and its
 * size. NAME_fill() writes it for languages that read no C: `size` is the size of the caller's struct. */
#define THRONG_DEFAULT(NAME)                         \
  THRONG_C int NAME##_fill(NAME* into, size_t size); \
  static inline NAME NAME##_default(void) {          \
    NAME one;                                        \
    NAME##_fill(&one, sizeof(NAME));                 \
    return one;                                      \
  }

typedef struct throng_file throng_file;           /* what was loaded from a model or a pack */
typedef struct throng_character throng_character; /* a skeleton and its clips, shared and read-only */
typedef struct throng_builder throng_builder;     /* a character of the host's own data, in the making */
typedef struct throng_machine throng_machine;     /* a state machine for a character, shared and read-only */
typedef struct throng_crowd throng_crowd;         /* agents; one thread at a time calls it */
typedef struct throng_snapshot throng_snapshot;   /* the state of a crowd at a moment */
typedef struct throng_lod throng_lod;             /* level of detail of a crowd */

/* An agent or a character of a crowd. Its number is THRONG_NONE if it is invalid. */
typedef struct throng_id {
  uint32_t number;
  uint32_t generation; /* THRONG_NONE: the present owner of the number */
} throng_id;

/* The place of a thing: it is turned first, then moved. */
typedef struct throng_place {
  float position[3]; /* metres */
  float rotation[4]; /* a unit quaternion */
} throng_place;

/* A transform relative to the parent bone: scale first, then rotation, then translation. */
typedef struct throng_transform {
  float translation[3];
  float rotation[4];
  float scale[3];
} throng_transform;

/* A ball that holds something, in metres. */
typedef struct throng_bounding_sphere {
  float centre[3];
  float radius;
} throng_bounding_sphere;

/* A box along the axes that holds something, in metres. */
typedef struct throng_bounding_box {
  float low[3];
  float high[3];
} throng_bounding_box;

THRONG_C int throng_version(void);
THRONG_C const char* throng_version_text(void);
/* Returns why the last failed call of this thread failed. Valid until the next call fails. */
THRONG_C const char* throng_last_error(void);

/* NOLINTEND */
#endif
