#ifndef THRONG_C_CHARACTERS_H
#define THRONG_C_CHARACTERS_H

/* Tells what a character has, and exchanges its clips. Strings and arrays that it returns live with the character.
 * A clip is named by the number of its place, from 0. */

/* NOLINTBEGIN: this is C, also where a C++ compiler reads it */
#include "throng/c/base.h"

/* An image of a part of the surface. Its pointers are null where there is none. */
typedef struct throng_texture {
  const uint8_t* texels; /* RGBA, top row first */
  int32_t width;
  int32_t height;
  const float* coords; /* two a vertex */
} throng_texture;

/* The change that a morph of weight 1 makes to a vertex, before the palette poses it. */
typedef struct throng_morph_delta {
  uint32_t vertex;
  uint32_t morph;    /* see throng_character_morph_name */
  float position[3]; /* metres, in the space of the palette */
  float normal[3];
} throng_morph_delta;

/* throng_mesh::alpha: how a part of the surface is seen through; see AlphaMode of character.h. */
enum { THRONG_ALPHA_OPAQUE, THRONG_ALPHA_MASK, THRONG_ALPHA_BLEND };

/* A part of the surface. Arrays have an element a vertex, unless their comment says so. Factors multiply what textures
 * show (glTF 2.0, 3.9). */
typedef struct throng_mesh {
  uint32_t size;
  uint32_t vertex_count;
  uint32_t index_count; /* three a triangle */
  uint32_t morph_delta_count;
  int32_t texture_width; /* 0: no texture */
  int32_t texture_height;
  float base_color[4]; /* linear */
  float emission[3];   /* linear, 1: as bright as white of the screen */
  float metallic;
  float roughness;
  float normal_scale;
  float occlusion_strength;
  float alpha_cutoff;
  uint32_t alpha;        /* THRONG_ALPHA_... */
  uint32_t double_sided; /* 1: both sides are drawn */
  uint32_t unlit;        /* 1: it shows its base colour, whatever the light */
  uint32_t unused;       /* 0 */
  const char* name;
  const float* positions;                    /* three, in the space of the palette */
  const float* normals;                      /* three */
  const float* texture_coords;               /* two, of the base colour; or null */
  const uint16_t* palette_entries;           /* four, strongest first */
  const float* weights;                      /* four, which sum to 1 */
  const uint32_t* indices;                   /* `index_count`; counter-clockwise front */
  const uint8_t* base_color_texels;          /* RGBA, sRGB, top row first; or null */
  const float* tangents;                     /* four, a unit vector and the side of the bitangent; or null */
  const float* colors;                       /* four, linear, times the base colour; or null */
  const throng_morph_delta* morph_deltas;    /* `morph_delta_count`, by vertex, then by morph */
  throng_texture metallic_roughness_texture; /* linear: roughness in green, metallic in blue */
  throng_texture normal_texture;             /* linear, in the space of `tangents` */
  throng_texture occlusion_texture;          /* linear, in red */
  throng_texture emission_texture;           /* sRGB */
} throng_mesh;
THRONG_DEFAULT(throng_mesh)

THRONG_C void throng_character_free(throng_character* character);

/* Clips. */
THRONG_C uint32_t throng_character_clip_count(const throng_character* character);
THRONG_C int throng_character_has_clip(const throng_character* character, uint32_t clip);
THRONG_C const char* throng_character_clip_name(const throng_character* character, uint32_t clip);
THRONG_C double throng_character_clip_seconds(const throng_character* character, uint32_t clip);
THRONG_C int throng_character_clip_loops(const throng_character* character, uint32_t clip);
/* Returns the metres a second at which feet do not slide; 0: the clip is no gait. */
THRONG_C double throng_character_clip_ground_speed(const throng_character* character, uint32_t clip);
THRONG_C uint32_t throng_character_find_clip(const throng_character* character, const char* name);
/* Returns the clip that plays a role, as far as the names of the clips tell; character.h lists the roles. */
THRONG_C uint32_t throng_character_find_role(const throng_character* character, const char* role);
/* Return a new character with the clips of `more` too, or without a clip; throng_crowd_replace_character takes it. */
THRONG_C throng_character* throng_character_with_clips(const throng_character* character, const throng_character* more);
THRONG_C throng_character* throng_character_without(const throng_character* character, uint32_t clip);
/* Return the name of a data key, a curve or a morph of its clips; null beyond the last. */
THRONG_C const char* throng_character_key_name(const throng_character* character, uint32_t name);
THRONG_C const char* throng_character_curve_name(const throng_character* character, uint32_t name);
THRONG_C const char* throng_character_morph_name(const throng_character* character, uint32_t name);

/* Bones. */
THRONG_C uint32_t throng_character_bone_count(const throng_character* character);
THRONG_C const char* throng_character_bone_name(const throng_character* character, uint32_t bone);
/* Returns the bone's parent, whose index is lower; THRONG_NONE for a root. */
THRONG_C uint32_t throng_character_bone_parent(const throng_character* character, uint32_t bone);
THRONG_C uint32_t throng_character_find_bone(const throng_character* character, const char* name);
THRONG_C double throng_character_height(const throng_character* character);
/* Writes a sphere that holds the surface in every pose of its clips, in model space. */
THRONG_C int throng_character_bounds(const throng_character* character, throng_bounding_sphere* sphere);
/* Writes a box that holds the surface in the poses of one clip, without its root motion. It takes milliseconds. */
THRONG_C int throng_character_clip_bounds(const throng_character* character, uint32_t clip, throng_bounding_box* box);
/* Returns why it cannot look, stand on uneven ground, reach or fall, a sentence each; null beyond the last. */
THRONG_C const char* throng_character_missing_rig(const throng_character* character, uint32_t index);

/* Palettes and meshes. */
THRONG_C uint32_t throng_character_level_count(const throng_character* character);
THRONG_C uint32_t throng_character_palette_entries(const throng_character* character, uint32_t level);
/* Writes the entry of a level's palette for each entry of a palette of all bones. */
THRONG_C uint32_t throng_character_entries_at_level(const throng_character* character, uint32_t level,
                                                    uint16_t* entries, uint32_t most);
/* Writes four floats an entry for packed_palette.glsl. There are none if its palettes cannot be packed. */
THRONG_C uint32_t throng_character_packing_frames(const throng_character* character, float* frames, uint32_t most);
/* Counts the meshes: none unless throng_load_options::keep_meshes was set. */
THRONG_C uint32_t throng_character_mesh_count(const throng_character* character);
/* Writes into a mesh that throng_mesh_default() returned. */
THRONG_C int throng_character_mesh(const throng_character* character, uint32_t index, throng_mesh* mesh);

/* NOLINTEND */
#endif
