#ifndef THRONG_C_MANY_H
#define THRONG_C_MANY_H

/* Requests to many agents at a time, on all PUs. A request that cannot be met is left out: then a call returns 1. */

/* NOLINTBEGIN: this is C, also where a C++ compiler reads it */
#include "throng/c/base.h"
#include "throng/c/channels.h"

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
typedef struct throng_reach_request {
  throng_id agent;
  uint32_t process; /* throng_agent_add_reach */
  float target[3];  /* metres, in model space */
} throng_reach_request;
typedef struct throng_placement_request {
  throng_id agent;
  uint32_t process; /* feet or springs */
  throng_place model_in_world;
} throng_placement_request;
typedef struct throng_ground_request {
  throng_id agent;
  uint32_t process; /* feet */
  uint32_t leg;     /* THRONG_NONE: all */
  float point[3];
  float normal[3];
} throng_ground_request;

/* A data key, and the agent that met it. */
typedef struct throng_agent_key {
  throng_id agent;
  throng_key key;
} throng_agent_key;
/* A process of an agent, such as a socket. */
typedef struct throng_process_of {
  throng_id agent;
  uint32_t process;
} throng_process_of;

THRONG_C int throng_crowd_set_speeds(throng_crowd* crowd, const throng_speed_request* requests, uint32_t count);
THRONG_C int throng_crowd_set_parameters(throng_crowd* crowd, const throng_parameter_request* requests, uint32_t count);
THRONG_C int throng_crowd_look_at(throng_crowd* crowd, const throng_gaze_request* requests, uint32_t count);
/* Sets places alone; throng_agent_set_process_weight sets weights. */
THRONG_C int throng_crowd_reach(throng_crowd* crowd, const throng_reach_request* requests, uint32_t count);
THRONG_C int throng_crowd_set_placements(throng_crowd* crowd, const throng_placement_request* requests, uint32_t count);
THRONG_C int throng_crowd_set_grounds(throng_crowd* crowd, const throng_ground_request* requests, uint32_t count);
/* Writes what throng_agent_displacement says of each agent. */
THRONG_C int throng_crowd_displacements(const throng_crowd* crowd, double from, double to, const throng_id* agents,
                                        uint32_t count, throng_root_motion* motions);
/* Lists what throng_agent_keys lists, agent after agent. */
THRONG_C uint32_t throng_crowd_keys(const throng_crowd* crowd, double from, double to, const throng_id* agents,
                                    uint32_t count, uint32_t choice, throng_agent_key* keys, uint32_t most);
/* Writes what throng_agent_socket says of each. */
THRONG_C int throng_crowd_sockets(const throng_crowd* crowd, const throng_process_of* sockets, uint32_t count,
                                  throng_place* places);

/* NOLINTEND */
#endif
