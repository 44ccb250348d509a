#ifndef THRONG_C_H
#define THRONG_C_H

/* The library for C, and for languages that call C. It does what the C++ headers say; they explain the words.
 *
 * A function that makes something returns null, THRONG_NONE or an invalid id if it fails. A function that changes
 * something returns 1, or 0 if it fails. throng_last_error() says why, also after a misuse. Strings are UTF-8.
 * Times are seconds. Vectors are three floats, rotations four: x, y, z, w. No function keeps a pointer after the call,
 * unless its comment says so. */

/* NOLINTBEGIN: this is C, also where a C++ compiler reads it */
#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32)
#if defined(THRONG_BUILDS_C)
#define THRONG_C __declspec(dllexport)
#else
#define THRONG_C __declspec(dllimport)
#endif
#else
#define THRONG_C __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define THRONG_NONE UINT32_MAX

typedef struct throng_file throng_file;           /* what was loaded from a model or a pack */
typedef struct throng_character throng_character; /* a skeleton and its clips, shared and read-only */
typedef struct throng_machine throng_machine;     /* a state machine for a character, shared and read-only */
typedef struct throng_crowd throng_crowd;         /* agents; one thread at a time calls it */
typedef struct throng_snapshot throng_snapshot;   /* the state of a crowd at a moment */

/* An agent or a character of a crowd. Its number is THRONG_NONE if it is invalid. */
typedef struct throng_id {
  uint32_t number;
  uint32_t generation;
} throng_id;

/* "Play this clip." */
typedef struct throng_play {
  uint32_t clip;
  float fade;    /* seconds; 0 replaces at once what plays */
  float speed;   /* multiple of the clip's own speed */
  float start;   /* seconds from the start of the clip */
  uint32_t loop; /* 0: once */
} throng_play;

/* "Play this clip once, over what plays." */
typedef struct throng_one_shot {
  uint32_t clip;
  float fade_in;   /* seconds */
  float fade_out;  /* seconds; the fade ends with the clip */
  float speed;     /* multiple of the clip's own speed, not 0 */
  uint32_t queued; /* 1: it waits for the clips before it */
} throng_one_shot;

/* One agent to be posed. */
typedef struct throng_pose_request {
  throng_id agent;
  uint32_t level; /* bone level, 0: all bones */
  float* palette; /* 12 floats an entry, throng_crowd_palette_bytes, aligned to 16; null: it is not drawn */
} throng_pose_request;

/* Requests to many agents at a time. */
typedef struct throng_speed_request {
  throng_id agent;
  float speed; /* multiple of the clip's own speed */
} throng_speed_request;
typedef struct throng_parameter_request {
  throng_id agent;
  uint32_t channel; /* a blend space */
  float x;
  float y; /* of a plane */
} throng_parameter_request;
typedef struct throng_gaze_request {
  throng_id agent;
  uint32_t process; /* throng_agent_add_look_at */
  float target[3];  /* metres, in model space */
  float fade;       /* seconds */
} throng_gaze_request;

/* The way of an agent, in its own space at the start. */
typedef struct throng_root_motion {
  float displacement[3]; /* metres */
  float turn;            /* radians; to the left is positive */
} throng_root_motion;

/* A data key that an agent has met. */
typedef struct throng_key {
  uint32_t name; /* see throng_character_key_name */
  uint32_t clip;
  double time;
  float weight;
} throng_key;

/* The library. */
THRONG_C int throng_version(void);
THRONG_C const char* throng_version_text(void);
/* Returns why the last failed call of this thread failed. Valid until the next call fails. */
THRONG_C const char* throng_last_error(void);
/* Sets the function that hears of calls that break their contract; null: one line each on standard error. */
typedef void (*throng_misuse_hook)(const char* call, const char* reason);
THRONG_C void throng_set_misuse_hook(throng_misuse_hook hook);

/* Files and characters. A character may outlive the file, and is freed by itself. `metres_a_unit` 0: guessed. */
THRONG_C throng_file* throng_load(const char* path, double metres_a_unit);
/* Does the same for a .glb or a pack in memory, whose bytes are copied. `name` is for messages. */
THRONG_C throng_file* throng_load_bytes(const char* name, const void* bytes, size_t size, double metres_a_unit);
THRONG_C void throng_file_free(throng_file* file);
THRONG_C uint32_t throng_file_character_count(const throng_file* file);
THRONG_C throng_character* throng_file_character(const throng_file* file, uint32_t index);
THRONG_C void throng_character_free(throng_character* character);
THRONG_C uint32_t throng_character_clip_count(const throng_character* character);
THRONG_C const char* throng_character_clip_name(const throng_character* character, uint32_t clip);
THRONG_C double throng_character_clip_seconds(const throng_character* character, uint32_t clip);
THRONG_C uint32_t throng_character_find_clip(const throng_character* character, const char* name);
/* Returns the clip that plays a role, as far as the names of the clips tell; character.h lists the roles. */
THRONG_C uint32_t throng_character_find_role(const throng_character* character, const char* role);
THRONG_C uint32_t throng_character_bone_count(const throng_character* character);
THRONG_C const char* throng_character_bone_name(const throng_character* character, uint32_t bone);
THRONG_C uint32_t throng_character_palette_entries(const throng_character* character);
THRONG_C const char* throng_character_key_name(const throng_character* character, uint32_t name);

/* State machines, read from JSON; state_machine.h has an example. */
THRONG_C throng_machine* throng_machine_load(const char* path, const throng_character* character);
THRONG_C throng_machine* throng_machine_parse(const char* json, const throng_character* character);
THRONG_C void throng_machine_free(throng_machine* machine);
THRONG_C uint32_t throng_machine_find_input(const throng_machine* machine, const char* name);
THRONG_C const char* throng_machine_state_name(const throng_machine* machine, uint32_t state);

/* Crowds. The first character is number 0. `hashes` 0: throng_crowd_pose_hash stays what it is. */
THRONG_C throng_crowd* throng_crowd_create(const throng_character* character, uint32_t pus, uint32_t hashes);
THRONG_C void throng_crowd_free(throng_crowd* crowd);
THRONG_C throng_id throng_crowd_add_character(throng_crowd* crowd, const throng_character* character);
THRONG_C int throng_crowd_remove_character(throng_crowd* crowd, throng_id character);
THRONG_C uint32_t throng_crowd_palette_bytes(const throng_crowd* crowd, throng_id character);
/* Writes `count` ids. */
THRONG_C int throng_crowd_add_agents(throng_crowd* crowd, throng_id character, uint32_t count, throng_id* agents);
THRONG_C int throng_crowd_remove_agent(throng_crowd* crowd, throng_id agent);
THRONG_C uint32_t throng_crowd_agent_count(const throng_crowd* crowd);
THRONG_C int throng_crowd_advance(throng_crowd* crowd, double seconds);
THRONG_C double throng_crowd_clock(const throng_crowd* crowd);
/* Poses agents. It leaves out invalid requests: it returns 1, and poses the other agents. */
THRONG_C int throng_crowd_update(throng_crowd* crowd, const throng_pose_request* requests, uint32_t count);
/* Poses all agents with all bones. The palette of an agent is written at palettes + its number * stride;
 * both are multiples of 16 bytes, and `stride` is at least what each character's throng_crowd_palette_bytes says. */
THRONG_C int throng_crowd_update_all(throng_crowd* crowd, float* palettes, size_t bytes, uint32_t stride);
THRONG_C uint64_t throng_crowd_pose_hash(const throng_crowd* crowd);

/* Agents. */
THRONG_C int throng_agent_play(throng_crowd* crowd, throng_id agent, const throng_play* play);
THRONG_C int throng_agent_set_speed(throng_crowd* crowd, throng_id agent, float speed);
/* Adds a blend space of `count` clips along a parameter that ascends. Returns the channel. */
THRONG_C uint32_t throng_agent_add_blend_space(throng_crowd* crowd, throng_id agent, const uint32_t* clips,
                                               const float* parameters, uint32_t count, uint32_t is_ground_speed);
THRONG_C int throng_agent_set_parameter(throng_crowd* crowd, throng_id agent, uint32_t channel, float parameter);
/* Adds a slot for one-shots over all channels that the agent has. Returns the channel. */
THRONG_C uint32_t throng_agent_add_slot(throng_crowd* crowd, throng_id agent);
THRONG_C int throng_agent_play_once(throng_crowd* crowd, throng_id agent, uint32_t slot, const throng_one_shot* shot);
/* Returns 1 while a slot plays, else 0. */
THRONG_C int throng_agent_is_playing(const throng_crowd* crowd, throng_id agent, uint32_t slot);
/* Adds a state machine over all channels that the agent has. Returns the channel. */
THRONG_C uint32_t throng_agent_add_machine(throng_crowd* crowd, throng_id agent, const throng_machine* machine);
THRONG_C int throng_agent_set_input(throng_crowd* crowd, throng_id agent, uint32_t channel, uint32_t input,
                                    float value);
/* Returns the number of the state that a machine is in, see throng_machine_state_name; THRONG_NONE where none plays. */
THRONG_C uint32_t throng_agent_state(throng_crowd* crowd, throng_id agent, uint32_t channel);
THRONG_C uint32_t throng_agent_add_look_at(throng_crowd* crowd, throng_id agent);
THRONG_C int throng_agent_look_at(throng_crowd* crowd, throng_id agent, uint32_t process, const float target[3],
                                  float fade);
/* Adds a limb that reaches: 0 left arm, 1 right arm, 2 left leg, 3 right leg. */
THRONG_C uint32_t throng_agent_add_reach(throng_crowd* crowd, throng_id agent, uint32_t limb);
THRONG_C int throng_agent_reach(throng_crowd* crowd, throng_id agent, uint32_t process, const float target[3],
                                float weight, float fade);
THRONG_C uint32_t throng_agent_add_socket(throng_crowd* crowd, throng_id agent, uint32_t bone);
THRONG_C int throng_agent_socket(const throng_crowd* crowd, throng_id agent, uint32_t process, float position[3],
                                 float rotation[4]);
/* Writes the way over the ground, in the agent's own space at `from`, and the radians that it turned. */
THRONG_C int throng_agent_displacement(const throng_crowd* crowd, throng_id agent, double from, double to,
                                       float displacement[3], float* turn);
/* Writes up to `most` keys met in [from, to), and returns how many there were. */
THRONG_C uint32_t throng_agent_keys(const throng_crowd* crowd, throng_id agent, double from, double to,
                                    throng_key* keys, uint32_t most);

/* Many agents at a time, on all PUs. A request that cannot be met is left out: then a call returns 1. */
THRONG_C int throng_crowd_set_speeds(throng_crowd* crowd, const throng_speed_request* requests, uint32_t count);
THRONG_C int throng_crowd_set_parameters(throng_crowd* crowd, const throng_parameter_request* requests, uint32_t count);
THRONG_C int throng_crowd_look_at(throng_crowd* crowd, const throng_gaze_request* requests, uint32_t count);
/* Writes what throng_agent_displacement says of each agent. */
THRONG_C int throng_crowd_displacements(const throng_crowd* crowd, double from, double to, const throng_id* agents,
                                        uint32_t count, throng_root_motion* motions);

/* Snapshots. */
THRONG_C throng_snapshot* throng_crowd_snapshot(const throng_crowd* crowd);
THRONG_C int throng_crowd_restore(throng_crowd* crowd, const throng_snapshot* snapshot);
THRONG_C void throng_snapshot_free(throng_snapshot* snapshot);

#ifdef __cplusplus
}
#endif

/* NOLINTEND */
#endif
