#ifndef THRONG_C_PROCESSES_H
#define THRONG_C_PROCESSES_H

/* Processes, which change an agent's final pose in the order in which they are added. A function that adds a process
 * returns it. Null settings: the defaults. Places are in metres in model space, unless a comment says otherwise. */

/* NOLINTBEGIN: this is C, also where a C++ compiler reads it */
#include "throng/c/base.h"

/* Turns spine, neck and head towards a place. */
typedef struct throng_look_at {
  uint32_t size;
  float yaw; /* radians to either side */
  float pitch_up;
  float pitch_down;
  float smooth_seconds; /* 0 turns at once */
} throng_look_at;
THRONG_DEFAULT(throng_look_at)

enum { THRONG_LEFT_ARM, THRONG_RIGHT_ARM, THRONG_LEFT_LEG, THRONG_RIGHT_LEG };

/* Lets a hand or a foot reach for a place. */
typedef struct throng_reach {
  uint32_t size;
  uint32_t limb;  /* THRONG_LEFT_ARM to THRONG_RIGHT_LEG */
  float softness; /* share of the limb's length over which it becomes straight */
  float pole[3];  /* where the elbow or knee points; 0: where the pose has it */
} throng_reach;
THRONG_DEFAULT(throng_reach)

/* Lets any chain of bones reach for a place. */
typedef struct throng_chain_reach {
  uint32_t size;
  uint32_t iterations;
  const char* first; /* the name of the bone that stays */
  const char* last;  /* the name of the bone that reaches */
  float tolerance;   /* metres */
  uint32_t unused;   /* 0 */
} throng_chain_reach;
THRONG_DEFAULT(throng_chain_reach)

/* Lets feet stand on the ground. */
typedef struct throng_foot_placement {
  uint32_t size;
  float max_drop;      /* metres that the pelvis may be lowered */
  float farthest_lock; /* metres at which a planted foot is let go; 0: none is held */
} throng_foot_placement;
THRONG_DEFAULT(throng_foot_placement)

/* Adds noise to all joints. */
typedef struct throng_noise {
  uint32_t size;
  float frequency; /* Hz */
  float amplitude; /* radians */
  uint32_t seed;
  uint32_t mask; /* THRONG_NONE: all bones */
} throng_noise;
THRONG_DEFAULT(throng_noise)

/* The movement of a chain of bones on springs; processes.h has the units. */
typedef struct throng_spring_chain {
  const char* first;
  const char* last;
  float stiffness;
  float damping;
  float drag;
  float gravity[3];
  float radius;
  float tip;
} throng_spring_chain;
THRONG_DEFAULT(throng_spring_chain)

/* A capsule of the body that chains stay outside of. */
typedef struct throng_spring_collider {
  const char* bone;
  float from[3]; /* metres from the bone's joint */
  float to[3];
  float radius;
} throng_spring_collider;
THRONG_DEFAULT(throng_spring_collider)

/* Lets hair, skirts and tails follow the body. */
typedef struct throng_springs {
  uint32_t size;
  uint32_t chain_count;
  const throng_spring_chain* chains;
  const throng_spring_collider* colliders;
  uint32_t collider_count;
  uint32_t unused; /* 0 */
} throng_springs;
THRONG_DEFAULT(throng_springs)

/* Lets an agent fall when it is pushed. */
typedef struct throng_ragdoll {
  uint32_t size;
  float fade; /* seconds from the animation to the rag-doll */
} throng_ragdoll;
THRONG_DEFAULT(throng_ragdoll)

/* Tells where a thing on a bone is. */
typedef struct throng_socket {
  uint32_t size;
  uint32_t bone;
  throng_place offset; /* from the bone's joint, in its own frame */
} throng_socket;
THRONG_DEFAULT(throng_socket)

/* One call of a step of the host's own. It runs on a PU, beside others: it changes `memory` and the pose, and neither
 * allocates nor locks. The library makes it, so it may get more members in 1.x. */
typedef struct throng_step_job {
  void* memory;     /* throng_step::memory_bytes of this agent, 0 at first; it may move between updates */
  void* user;       /* throng_step::user */
  double delta;     /* seconds since the agent's last update */
  const void* pose; /* for throng_step_rotation and the functions beside it */
} throng_step_job;

/* A step of the host's own. */
typedef struct throng_step {
  uint32_t size;
  uint32_t memory_bytes; /* of each agent, at most 4,096 */
  const char* name;
  void (*run)(const throng_step_job* job); /* it is called until the crowd is freed */
  void* user;
} throng_step;
THRONG_DEFAULT(throng_step)

THRONG_C uint32_t throng_agent_add_look_at(throng_crowd* crowd, throng_id agent, const throng_look_at* settings);
THRONG_C uint32_t throng_agent_add_reach(throng_crowd* crowd, throng_id agent, const throng_reach* settings);
THRONG_C uint32_t throng_agent_add_chain_reach(throng_crowd* crowd, throng_id agent,
                                               const throng_chain_reach* settings);
THRONG_C uint32_t throng_agent_add_foot_placement(throng_crowd* crowd, throng_id agent,
                                                  const throng_foot_placement* settings);
THRONG_C uint32_t throng_agent_add_noise(throng_crowd* crowd, throng_id agent, const throng_noise* settings);
THRONG_C uint32_t throng_agent_add_springs(throng_crowd* crowd, throng_id agent, const throng_springs* settings);
THRONG_C uint32_t throng_agent_add_ragdoll(throng_crowd* crowd, throng_id agent, const throng_ragdoll* settings);
THRONG_C uint32_t throng_agent_add_socket(throng_crowd* crowd, throng_id agent, const throng_socket* settings);
THRONG_C int throng_agent_remove_process(throng_crowd* crowd, throng_id agent, uint32_t process);
/* Fades the weight of a gaze, a reaching limb or chain, feet or springs, 0 to 1. */
THRONG_C int throng_agent_set_process_weight(throng_crowd* crowd, throng_id agent, uint32_t process, float weight,
                                             float fade);

THRONG_C int throng_agent_look_at(throng_crowd* crowd, throng_id agent, uint32_t process, const float target[3],
                                  float fade);
THRONG_C int throng_agent_look_away(throng_crowd* crowd, throng_id agent, uint32_t process, float fade);
/* Sets the place that a limb or chain reaches for, and its weight. */
THRONG_C int throng_agent_reach(throng_crowd* crowd, throng_id agent, uint32_t process, const float target[3],
                                float weight, float fade);
/* Tells feet or springs where the character stands in the world, at each frame. */
THRONG_C int throng_agent_set_placement(throng_crowd* crowd, throng_id agent, uint32_t process,
                                        const throng_place* model_in_world);
/* Tells feet the ground below a leg, in world space. `leg` THRONG_NONE: all legs. */
THRONG_C int throng_agent_set_ground(throng_crowd* crowd, throng_id agent, uint32_t process, uint32_t leg,
                                     const float point[3], const float normal[3]);
/* Writes the ankle of a leg at the last update, before it was placed, in world space. */
THRONG_C int throng_agent_ankle(const throng_crowd* crowd, throng_id agent, uint32_t process, uint32_t leg,
                                float ankle[3]);
/* Pushes the body nearest to `place` with an impulse, in kg m/s. */
THRONG_C int throng_agent_push(throng_crowd* crowd, throng_id agent, uint32_t process, const float impulse[3],
                               const float place[3]);
THRONG_C int throng_agent_recover(throng_crowd* crowd, throng_id agent, uint32_t process, float fade);
THRONG_C int throng_agent_is_down(const throng_crowd* crowd, throng_id agent, uint32_t process);
THRONG_C int throng_agent_socket(const throng_crowd* crowd, throng_id agent, uint32_t process, throng_place* place);

/* Steps of the host's own. A crowd has one for a character before agents get it. */
THRONG_C uint32_t throng_crowd_add_step(throng_crowd* crowd, throng_id character, const throng_step* step);
THRONG_C uint32_t throng_agent_add_step(throng_crowd* crowd, throng_id agent, uint32_t step);
/* Counts the bones of this update: a coarser level has fewer. The functions below ignore others. */
THRONG_C uint32_t throng_step_bone_count(const throng_step_job* job);
THRONG_C void throng_step_rotation(const throng_step_job* job, uint32_t bone, float rotation[4]);
THRONG_C void throng_step_set_rotation(const throng_step_job* job, uint32_t bone, const float rotation[4]);
THRONG_C void throng_step_position(const throng_step_job* job, uint32_t bone, float position[3]);
THRONG_C void throng_step_set_position(const throng_step_job* job, uint32_t bone, const float position[3]);

/* NOLINTEND */
#endif
