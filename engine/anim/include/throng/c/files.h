#ifndef THRONG_C_FILES_H
#define THRONG_C_FILES_H

/* Loads models and packs, and saves packs. */

/* NOLINTBEGIN: this is C, also where a C++ compiler reads it */
#include "throng/c/base.h"

/* The bone that plays a part of the body: "head", "leftFoot" (VRM 1.0), and the bone's name in the file. */
typedef struct throng_bone_role {
  const char* role;
  const char* bone;
} throng_bone_role;

/* How a file is loaded; see LoadOptions of character.h. */
typedef struct throng_load_options {
  uint32_t size;
  uint32_t strict;        /* 1: files that need repairs are refused */
  uint32_t keep_meshes;   /* 1: for throng_character_mesh */
  uint32_t walk_in_place; /* 1: clips that walk in place move their agents */
  uint32_t copy_pack;     /* 1: a pack is read instead of mapped */
  uint32_t keep_keys;     /* 1: the file's own keys of all clips are kept */
  uint32_t close_loops;   /* 1: clips get the key that repeats their first, where it alone is missing */
  uint32_t rig_count;
  double metres_a_unit;        /* 0: guessed */
  uint64_t memory_limit;       /* bytes that reading a glTF file may hold; 0: as its size tells */
  const throng_bone_role* rig; /* [rig_count] bones that play parts of the body, where their names do not tell */
} throng_load_options;
THRONG_DEFAULT(throng_load_options)

/* A file in memory. */
typedef struct throng_bytes {
  const char* name; /* as the model names it in its uris; of the model itself, for messages */
  const void* bytes;
  size_t count;
} throng_bytes;

/* Loads a model or a pack. `metres_a_unit` 0: guessed. */
THRONG_C throng_file* throng_load(const char* path, double metres_a_unit);
/* Does the same with options. Null options: the defaults. */
THRONG_C throng_file* throng_load_with(const char* path, const throng_load_options* options);
/* Does the same for a .glb or a pack in memory, whose bytes are copied. `name` is for messages. */
THRONG_C throng_file* throng_load_bytes(const char* name, const void* bytes, size_t size, double metres_a_unit);
/* Does the same for files in memory: the first is the model or pack, the others are what it names. Null options: the
 * defaults. */
THRONG_C throng_file* throng_load_bytes_with(const throng_bytes* files, uint32_t count,
                                             const throng_load_options* options);
THRONG_C void throng_file_free(throng_file* file);
THRONG_C uint32_t throng_file_character_count(const throng_file* file);
/* Returns a character, which may outlive the file and is freed by itself. */
THRONG_C throng_character* throng_file_character(const throng_file* file, uint32_t index);
/* Returns a sentence about what was repaired, placed or walks in place; null beyond the last. It lives with the file.
 */
THRONG_C const char* throng_file_note(const throng_file* file, uint32_t index);
/* Saves `count` characters as one pack, which throng_load opens in a moment. The file is whole or as it was. */
THRONG_C int throng_save(const char* path, const throng_character* const* characters, uint32_t count);

/* NOLINTEND */
#endif
