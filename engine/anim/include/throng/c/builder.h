#ifndef THRONG_C_BUILDER_H
#define THRONG_C_BUILDER_H

/* Builds a character of a host's own data; see character_builder.h. Calls copy what they are given. They refuse null
 * pointers, structs of a wrong size and unknown constants; throng_builder_build() names the first of all other faults.
 * A bone or a clip is named by the number that its function returned. */

/* NOLINTBEGIN: this is C, also where a C++ compiler reads it */
#include "throng/c/base.h"
#include "throng/c/characters.h"
#include "throng/c/files.h"

/* A bone of a character to be built. */
typedef struct throng_bone_to_build {
  uint32_t size;
  uint32_t parent;           /* a bone that was added before; THRONG_NONE: a root */
  throng_transform rest;     /* a clip without keys for the bone leaves it there */
  const char* name;          /* null: "" */
  const char* role;          /* the part of the body, in the words of VRM 1.0; null: its name may tell */
  const float* inverse_bind; /* 16, column by column: from the meshes to the bone as it was bound; null: as it rests */
} throng_bone_to_build;
THRONG_DEFAULT(throng_bone_to_build)

/* throng_bone_keys::form: how a track goes between two keys; see KeyForm of character_builder.h. */
enum { THRONG_FORM_LINEAR, THRONG_FORM_STEP, THRONG_FORM_CUBIC_SPLINE };

/* The keys of one property of a bone. Before the first and after the last, the nearest holds. */
typedef struct throng_bone_keys {
  const float* seconds; /* `count`, ascending, from 0 to the clip's duration */
  const float* values;  /* a vector or rotation a key; three of them with THRONG_FORM_CUBIC_SPLINE */
  uint32_t count;
  uint32_t form; /* THRONG_FORM_... */
} throng_bone_keys;

/* Begins a character. `name` is the skeleton's, for messages. */
THRONG_C throng_builder* throng_builder_create(const char* name);
THRONG_C void throng_builder_free(throng_builder* builder);
/* Adds a bone, and returns its number in the builder. throng_character_find_bone tells it in the character. */
THRONG_C uint32_t throng_builder_add_bone(throng_builder* builder, const throng_bone_to_build* bone);
/* Adds a clip that lasts so many seconds, and returns its number in the builder and in the character. */
THRONG_C uint32_t throng_builder_add_clip(throng_builder* builder, const char* name, double seconds);
THRONG_C int throng_builder_set_translations(throng_builder* builder, uint32_t clip, uint32_t bone,
                                             const throng_bone_keys* keys);
THRONG_C int throng_builder_set_rotations(throng_builder* builder, uint32_t clip, uint32_t bone,
                                          const throng_bone_keys* keys);
THRONG_C int throng_builder_set_scales(throng_builder* builder, uint32_t clip, uint32_t bone,
                                       const throng_bone_keys* keys);
/* Names a moment of a clip, for throng_agent_keys. */
THRONG_C int throng_builder_add_data_key(throng_builder* builder, uint32_t clip, const char* name, double seconds);
/* Adds a number over the time of a clip, for throng_agent_curve: `count` times and values, linear in between. */
THRONG_C int throng_builder_add_curve(throng_builder* builder, uint32_t clip, const char* name, const float* seconds,
                                      const float* values, uint32_t count);
/* Adds a part of the surface. Its vertices stand in the bind pose, in model space, and `palette_entries` are bones of
 * the builder. */
THRONG_C int throng_builder_add_mesh(throng_builder* builder, const throng_mesh* mesh);
/* Builds a file of one character. The builder stays as it is. Null options: the defaults. */
THRONG_C throng_file* throng_builder_build(const throng_builder* builder, const throng_load_options* options);

/* NOLINTEND */
#endif
