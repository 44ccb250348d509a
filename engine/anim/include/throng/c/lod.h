#ifndef THRONG_C_LOD_H
#define THRONG_C_LOD_H

/* Level of detail: which agents are posed now, how far ahead, and with how many bones. */

/* NOLINTBEGIN: this is C, also where a C++ compiler reads it */
#include "throng/c/base.h"
#include "throng/c/crowds.h"

typedef struct throng_camera {
  uint32_t size;
  float position[3];     /* metres, world */
  float forward[3];      /* unit */
  float frustum[6][4];   /* unit normals and offsets of planes; all 0: every agent is in view */
  float pixels_per_unit; /* pixels that a metre covers at a distance of a metre */
} throng_camera;
THRONG_DEFAULT(throng_camera)

/* Writes a camera into one that throng_camera_default() returned. `clip_from_world` is column-major. */
THRONG_C int throng_camera_set(throng_camera* camera, const float position[3], const float forward[3],
                               const float clip_from_world[16], uint32_t pixels_tall);
/* Moves its planes outwards, so that agents are in view whose shadows may fall into the picture. */
THRONG_C int throng_camera_include_casters(throng_camera* camera, const float to_light[3], float height);

/* throng_lod_rules::rule; see LodRule of lod_rules.h. */
enum { THRONG_LOD_OFF, THRONG_LOD_BY_DISTANCE, THRONG_LOD_BY_BUDGET };

/* The settings of the rules; lod_rules.h explains them. */
typedef struct throng_lod_rules {
  uint32_t size;
  uint32_t rule;             /* THRONG_LOD_... */
  float error_pixels;        /* 0: no limit */
  float full_rate_distance;  /* metres */
  float interval_growth;     /* metres */
  uint32_t largest_interval; /* frames, 1 to 16 */
  uint32_t bone_lod;         /* 1: fewer bones far off */
  uint32_t smooth;           /* 1: the renderer blends palettes */
  float level_distances[3];  /* metres */
  float centre_importance;
  float centre_degrees;
  uint32_t unused;            /* 0 */
  double budget_milliseconds; /* 0: no limit */
} throng_lod_rules;
THRONG_DEFAULT(throng_lod_rules)

/* One frame. Arrays have an element for each agent, by its number. */
typedef struct throng_lod_frame {
  uint32_t size;
  uint32_t count;                /* of elements: throng_crowd_number_limit, or more */
  const float* positions;        /* three each: metres, world, between the feet */
  const float* scales;           /* null: all 1 */
  const throng_camera* camera;   /* null: the default */
  const throng_lod_rules* rules; /* null: the defaults */
  double frame_step;             /* seconds since the frame before */
} throng_lod_frame;
THRONG_DEFAULT(throng_lod_frame)

THRONG_C throng_lod* throng_lod_create(void);
THRONG_C void throng_lod_free(throng_lod* lod);
/* Lists the agents to be posed. The host sets in the list where palettes go, and hands it to throng_crowd_update. It
 * is valid until the next call. */
THRONG_C int throng_lod_select(throng_lod* lod, throng_crowd* crowd, const throng_lod_frame* frame,
                               throng_pose_request** requests, uint32_t* count);
/* Learns the cost of the update, and from the list which agents are drawn. */
THRONG_C int throng_lod_settle(throng_lod* lod, const throng_crowd* crowd);
/* Makes an agent due in the next frame. */
THRONG_C int throng_lod_make_due(throng_lod* lod, throng_id agent);
/* Returns whether the agent was in view in the last selection. */
THRONG_C int throng_lod_is_visible(const throng_lod* lod, throng_id agent);

/* NOLINTEND */
#endif
