#ifndef THRONG_C_CHANNELS_H
#define THRONG_C_CHANNELS_H

/* What agents play: clips, blend spaces, one-shots and state machines; and how they move and what they meet by it. A
 * function that adds a channel lays it over all channels that the agent has, and returns it. Null layers: the whole
 * channel. */

/* NOLINTBEGIN: this is C, also where a C++ compiler reads it */
#include "throng/c/base.h"

/* "Play this clip." */
typedef struct throng_play {
  uint32_t size;
  uint32_t clip;
  float fade;                        /* seconds; 0 replaces at once what plays */
  float speed;                       /* multiple of the clip's own speed; negative: backwards */
  float start;                       /* seconds from the start of the clip */
  uint32_t loop;                     /* 0: once */
  uint32_t mask;                     /* lays the clip over what plays, on these bones; THRONG_NONE: all bones */
  const throng_place* absolute_root; /* where the agent stands in a cut scene; null: it plays none */
} throng_play;
THRONG_DEFAULT(throng_play)

/* "Play this clip once, over what plays." */
typedef struct throng_one_shot {
  uint32_t size;
  uint32_t clip;
  float fade_in;   /* seconds */
  float fade_out;  /* seconds; the fade ends with the clip */
  float speed;     /* multiple of the clip's own speed, not 0 */
  uint32_t queued; /* 1: it waits for the clips before it */
} throng_one_shot;
THRONG_DEFAULT(throng_one_shot)

/* How a channel lies over the channels before it. */
typedef struct throng_layer {
  uint32_t size;
  float weight;  /* 0 to 1 */
  uint32_t mask; /* THRONG_NONE: all bones */
} throng_layer;
THRONG_DEFAULT(throng_layer)

/* throng_blend_point::pace: whether a clip keeps step with the others. */
enum { THRONG_PACE_AUTOMATIC, THRONG_PACE_GAIT, THRONG_PACE_OWN };

/* A clip, and the value of the parameter at which it is played alone. */
typedef struct throng_blend_point {
  uint32_t clip;
  float parameter;
  uint32_t pace; /* THRONG_PACE_... */
} throng_blend_point;

/* Clips along one parameter. */
typedef struct throng_blend_space {
  uint32_t size;
  uint32_t point_count;
  const throng_blend_point* points; /* their parameters ascend */
  float parameter;
  uint32_t is_ground_speed; /* 1: the parameter is metres a second */
} throng_blend_space;
THRONG_DEFAULT(throng_blend_space)

/* throng_blend_space_2d::meaning: what the parameters of a plane are. */
enum { THRONG_PLANE_PLAIN, THRONG_PLANE_VELOCITY, THRONG_PLANE_SPEED_AND_TURN };

typedef struct throng_blend_point_2d {
  uint32_t clip;
  float x;
  float y;
  uint32_t pace; /* THRONG_PACE_... */
} throng_blend_point_2d;

/* Clips in a plane of two parameters. */
typedef struct throng_blend_space_2d {
  uint32_t size;
  uint32_t point_count;
  const throng_blend_point_2d* points; /* none twice */
  float x;
  float y;
  uint32_t meaning; /* THRONG_PLANE_... */
  uint32_t unused;  /* 0 */
} throng_blend_space_2d;
THRONG_DEFAULT(throng_blend_space_2d)

/* Plays a clip on the agent's first channel, or on one that throng_agent_add_clips returned. */
THRONG_C int throng_agent_play(throng_crowd* crowd, throng_id agent, const throng_play* play);
THRONG_C int throng_agent_play_on(throng_crowd* crowd, throng_id agent, uint32_t channel, const throng_play* play);
THRONG_C int throng_agent_set_speed(throng_crowd* crowd, throng_id agent, float speed);
THRONG_C uint32_t throng_agent_add_clips(throng_crowd* crowd, throng_id agent, const throng_layer* layer);
/* Moves the weight of a channel there evenly in `fade` seconds. */
THRONG_C int throng_agent_set_weight(throng_crowd* crowd, throng_id agent, uint32_t channel, float weight, float fade);
THRONG_C int throng_agent_remove_channel(throng_crowd* crowd, throng_id agent, uint32_t channel);

/* Blend spaces. */
THRONG_C uint32_t throng_agent_add_blend_space(throng_crowd* crowd, throng_id agent, const throng_blend_space* space,
                                               const throng_layer* layer);
THRONG_C uint32_t throng_agent_add_blend_space_2d(throng_crowd* crowd, throng_id agent,
                                                  const throng_blend_space_2d* space, const throng_layer* layer);
THRONG_C int throng_agent_set_parameter(throng_crowd* crowd, throng_id agent, uint32_t channel, float parameter);
THRONG_C int throng_agent_set_parameters(throng_crowd* crowd, throng_id agent, uint32_t channel, float x, float y);

/* Slots for one-shots. */
THRONG_C uint32_t throng_agent_add_slot(throng_crowd* crowd, throng_id agent, const throng_layer* layer);
THRONG_C int throng_agent_play_once(throng_crowd* crowd, throng_id agent, uint32_t slot, const throng_one_shot* shot);
/* Returns 1 while a slot plays, else 0. */
THRONG_C int throng_agent_is_playing(const throng_crowd* crowd, throng_id agent, uint32_t slot);

/* State machines, read from JSON; state_machine.h has an example. */
THRONG_C throng_machine* throng_machine_load(const char* path, const throng_character* character);
THRONG_C throng_machine* throng_machine_parse(const char* json, const throng_character* character);
THRONG_C void throng_machine_free(throng_machine* machine);
THRONG_C uint32_t throng_machine_find_input(const throng_machine* machine, const char* name);
THRONG_C uint32_t throng_machine_find_state(const throng_machine* machine, const char* name);
THRONG_C const char* throng_machine_state_name(const throng_machine* machine, uint32_t state);
THRONG_C uint32_t throng_agent_add_machine(throng_crowd* crowd, throng_id agent, const throng_machine* machine,
                                           const throng_layer* layer);
/* Sets an input. Flags and triggers are on at any number but 0. */
THRONG_C int throng_agent_set_input(throng_crowd* crowd, throng_id agent, uint32_t channel, uint32_t input,
                                    float value);
/* Returns the number of the state that a machine is in, see throng_machine_state_name; THRONG_NONE where none plays. */
THRONG_C uint32_t throng_agent_state(throng_crowd* crowd, throng_id agent, uint32_t channel);
/* Returns when the machine entered that state, by the clock. */
THRONG_C double throng_agent_state_entered_at(throng_crowd* crowd, throng_id agent, uint32_t channel);

/* Motion. Times are of the clock, within a day of it. */

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
