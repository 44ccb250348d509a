#ifndef THRONG_C_CROWDS_H
#define THRONG_C_CROWDS_H

/* Crowds, their characters and agents, frames and snapshots. */

/* NOLINTBEGIN: this is C, also where a C++ compiler reads it */
#include "throng/c/base.h"
#include "throng/c/host.h"

/* throng_crowd_options::palettes: how an entry of a palette is written; see formats.h. */
enum { THRONG_PALETTES_OF_MATRICES, THRONG_PALETTES_PACKED };

typedef struct throng_crowd_options {
  uint32_t size;
  uint32_t pus;               /* threads that pose, the caller's included */
  uint32_t palettes;          /* THRONG_PALETTES_... */
  uint32_t hash;              /* 1: throng_crowd_pose_hash counts */
  uint32_t trace;             /* 1: notes what each PU does, for throng_crowd_trace */
  uint64_t local_store_bytes; /* 0: as large as fits */
  throng_executor executor;   /* null: threads of its own; it is called until the crowd is freed or configured anew */
  void* executor_user;
} throng_crowd_options;
THRONG_DEFAULT(throng_crowd_options)

/* One agent to be posed. Zeros in all but `agent` pose it with all bones, and write nothing. */
typedef struct throng_pose_request {
  throng_id agent;
  uint32_t level;       /* bone level, 0: all bones */
  uint32_t fade_level;  /* a coarser level, to or from which the pose fades */
  uint32_t fade_halves; /* 0 to 2 */
  double look_ahead;    /* seconds: the pose is for this much later */
  float* palette;       /* throng_crowd_palette_bytes, aligned to 16; null: it is not drawn */
  float* joints;        /* throng_crowd_joint_bytes, aligned to 16; null: none are written */
} throng_pose_request;

/* throng_joint_output::format: how a joint is written; see formats.h. */
enum { THRONG_JOINTS_AS_TRANSFORMS, THRONG_JOINTS_AS_MATRICES, THRONG_JOINTS_AS_MATRICES_4X4 };

/* The joints that an update writes of each agent of a character. */
typedef struct throng_joint_output {
  uint32_t size;
  uint32_t format;     /* THRONG_JOINTS_AS_... */
  uint32_t skin;       /* the matrices of this skin of the file; THRONG_NONE: `bones` */
  uint32_t bone_count; /* 0: all bones */
  const uint32_t* bones;
} throng_joint_output;
THRONG_DEFAULT(throng_joint_output)

/* The weight of a bone and of all bones below it. */
typedef struct throng_bone_weight {
  uint32_t bone;
  float weight; /* 0 to 1 */
} throng_bone_weight;

/* Makes a crowd of a character, which is number 0. Null options: the defaults. */
THRONG_C throng_crowd* throng_crowd_create(const throng_character* character, const throng_crowd_options* options);
THRONG_C void throng_crowd_free(throng_crowd* crowd);
/* Changes options between frames. Poses stay the same. */
THRONG_C int throng_crowd_configure(throng_crowd* crowd, const throng_crowd_options* options);

/* Characters. */
THRONG_C throng_id throng_crowd_add_character(throng_crowd* crowd, const throng_character* character);
THRONG_C int throng_crowd_remove_character(throng_crowd* crowd, throng_id character);
/* Takes a character with other clips, which was made of throng_crowd_character(). Agents go on where they are. */
THRONG_C int throng_crowd_replace_character(throng_crowd* crowd, throng_id character,
                                            const throng_character* with_other_clips);
/* Returns a character of the crowd, which is freed by itself. */
THRONG_C throng_character* throng_crowd_character(const throng_crowd* crowd, throng_id character);
THRONG_C uint32_t throng_crowd_palette_bytes(const throng_crowd* crowd, throng_id character);
THRONG_C int throng_crowd_write_joints(throng_crowd* crowd, throng_id character, const throng_joint_output* output);
THRONG_C uint32_t throng_crowd_joint_bytes(const throng_crowd* crowd, throng_id character);
/* Adds weights of bones, and returns the mask. Bones in no subtree weigh `elsewhere`. */
THRONG_C uint32_t throng_crowd_add_mask(throng_crowd* crowd, throng_id character, const throng_bone_weight* bones,
                                        uint32_t count, float elsewhere);

/* Agents. */
/* Writes `count` ids. */
THRONG_C int throng_crowd_add_agents(throng_crowd* crowd, throng_id character, uint32_t count, throng_id* agents);
THRONG_C int throng_crowd_remove_agent(throng_crowd* crowd, throng_id agent);
THRONG_C uint32_t throng_crowd_agent_count(const throng_crowd* crowd);
/* Lists the agents in the order in which they were added. */
THRONG_C uint32_t throng_crowd_agents(const throng_crowd* crowd, throng_id* agents, uint32_t most);
/* Returns a number above all agents' numbers. */
THRONG_C uint32_t throng_crowd_number_limit(const throng_crowd* crowd);
THRONG_C int throng_agent_exists(const throng_crowd* crowd, throng_id agent);
THRONG_C throng_id throng_agent_character(const throng_crowd* crowd, throng_id agent);

/* Frames. */
THRONG_C int throng_crowd_advance(throng_crowd* crowd, double seconds);
THRONG_C double throng_crowd_clock(const throng_crowd* crowd);
/* Poses agents. It leaves out invalid requests: it returns 1, and poses the other agents. */
THRONG_C int throng_crowd_update(throng_crowd* crowd, const throng_pose_request* requests, uint32_t count);
/* Poses all agents with all bones. The palette of an agent is written at palettes + its number * stride;
 * both are multiples of 16 bytes, and `stride` is at least what each character's throng_crowd_palette_bytes says. */
THRONG_C int throng_crowd_update_all(throng_crowd* crowd, float* palettes, size_t bytes, uint32_t stride);
/* Writes palettes of matrices for the time of the clock, with all bones. Changes nothing. */
THRONG_C int throng_crowd_pose_exactly(throng_crowd* crowd, const throng_pose_request* requests, uint32_t count);
/* Writes the transform of each bone at the clock. There is room for `count`. */
THRONG_C int throng_crowd_local_pose(throng_crowd* crowd, throng_id agent, throng_transform* bones, uint32_t count);
/* Writes a box that holds the surface of an agent in its pose at the clock, in model space: move it by the agent's
 * place. It takes a few microseconds. */
THRONG_C int throng_crowd_bounds(throng_crowd* crowd, throng_id agent, throng_bounding_box* box);

/* Snapshots. */
THRONG_C throng_snapshot* throng_crowd_snapshot(const throng_crowd* crowd);
/* Takes a snapshot again, in the memory of one that there is. */
THRONG_C int throng_crowd_snapshot_into(const throng_crowd* crowd, throng_snapshot* snapshot);
THRONG_C int throng_crowd_restore(throng_crowd* crowd, const throng_snapshot* snapshot);
THRONG_C size_t throng_snapshot_bytes(const throng_snapshot* snapshot);
THRONG_C void throng_snapshot_free(throng_snapshot* snapshot);

/* Figures; see debug.h. */
THRONG_C uint64_t throng_crowd_pose_hash(const throng_crowd* crowd);
THRONG_C uint32_t throng_crowd_posed_agents(const throng_crowd* crowd);
THRONG_C double throng_crowd_predicted_nanoseconds(const throng_crowd* crowd);
THRONG_C double throng_crowd_update_milliseconds(const throng_crowd* crowd);
THRONG_C double throng_crowd_bytes_per_agent(const throng_crowd* crowd);
THRONG_C const char* throng_crowd_kernels(const throng_crowd* crowd);

/* A stretch of a PU's time within an update. */
typedef struct throng_pu_span {
  const char* name; /* "fetch", "compute", "write back", "wait" or "schedule"; it lives as long as the program */
  int64_t begin;    /* nanoseconds of a steady clock */
  int64_t end;
  uint32_t agents; /* the number of agents that it was for */
  uint32_t bytes_in;
  uint32_t bytes_out;
} throng_pu_span;
/* Lists what a PU did in the last update, and returns the number of spans; of these it writes `most` at most. */
THRONG_C uint32_t throng_crowd_trace(const throng_crowd* crowd, uint32_t pu, throng_pu_span* spans, uint32_t most);

/* NOLINTEND */
#endif
