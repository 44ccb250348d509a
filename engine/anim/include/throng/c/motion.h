#ifndef THRONG_C_MOTION_H
#define THRONG_C_MOTION_H

/* How agents move, and what they meet on the way. Times are of the clock, within a day of it. */

/* NOLINTBEGIN: this is C, also where a C++ compiler reads it */
#include "throng/c/base.h"

/* The way of an agent, in its own space at the start. */
typedef struct throng_root_motion {
  float displacement[3]; /* metres */
  float turn;            /* radians; to the left is positive */
} throng_root_motion;

/* Says which of the met data keys are told: of clips that are felt, of the heaviest alone, or all. */
enum { THRONG_KEYS_FELT, THRONG_KEYS_HEAVIEST, THRONG_KEYS_ALL };

/* A data key that an agent has met. */
typedef struct throng_key {
  uint32_t name; /* see throng_character_key_name */
  uint32_t clip;
  double time;
  float weight;
} throng_key;

/* A clip that does not loop has reached its end. */
typedef struct throng_clip_end {
  uint32_t clip;
  float weight;
  double time;
} throng_clip_end;

/* Writes the way over the ground from `from` to `to`. */
THRONG_C int throng_agent_displacement(const throng_crowd* crowd, throng_id agent, double from, double to,
                                       throng_root_motion* motion);
/* Returns the value of a curve now; `name` is an index for throng_character_curve_name. */
THRONG_C float throng_agent_curve(const throng_crowd* crowd, throng_id agent, uint32_t name);
/* Returns 1 and writes the weight of each morph now: see throng_character_morph_name. There is room for `count`. It
 * returns 0 and writes zeros if no clip that plays has morphs. */
THRONG_C int throng_agent_morph_weights(const throng_crowd* crowd, throng_id agent, float* weights, uint32_t count);
/* Returns 1 and writes where a cut scene has the agent now; returns 0 if none plays. */
THRONG_C int throng_agent_absolute_root(const throng_crowd* crowd, throng_id agent, throng_place* place);
/* Lists the keys met in [from, to); `choice` is THRONG_KEYS_... */
THRONG_C uint32_t throng_agent_keys(const throng_crowd* crowd, throng_id agent, double from, double to, uint32_t choice,
                                    throng_key* keys, uint32_t most);
/* Lists the ends in (from, to]. */
THRONG_C uint32_t throng_agent_ends(const throng_crowd* crowd, throng_id agent, double from, double to,
                                    throng_clip_end* ends, uint32_t most);

/* NOLINTEND */
#endif
