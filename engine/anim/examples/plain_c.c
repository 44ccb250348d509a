/* A host in C: agents walk and look ahead, level of detail chooses whom to pose, and joints say where the hands are. */
#include <stdio.h>
#include <stdlib.h>

#include "throng/c.h"

enum { agent_count = 1000, frames = 120 };

/* One joint as an update writes it. Each begins at a multiple of 16 bytes. */
struct joint {
  float rotation[4];
  float position[3];
  float scale;
};
static _Alignas(16) struct joint hands[agent_count];

static void check(int is_well) {
  if (is_well) return;
  fprintf(stderr, "%s\n", throng_last_error());
  exit(1);
}

/* Lets each agent walk from a moment of its own. A struct begins with its defaults, so that only the rest is set. */
static void walk(throng_crowd* crowd, const throng_character* character, const throng_id* agents) {
  throng_play play = throng_play_default();
  play.clip = throng_character_find_role(character, "walk");
  for (int i = 0; i < agent_count; ++i) {
    play.start = (float)throng_character_clip_seconds(character, play.clip) * (float)i / agent_count;
    check(throng_agent_play(crowd, agents[i], &play) == 0);
  }
}

/* Asks an update for one joint of each agent. */
static void write_hands(throng_crowd* crowd, const throng_character* character, throng_id first) {
  const uint32_t hand = throng_character_find_bone(character, "hand.R");
  throng_joint_output output = throng_joint_output_default();
  output.bones = &hand;
  output.bone_count = 1;
  check(throng_crowd_write_joints(crowd, first, &output) == 0);
}

int main(int count, char** arguments) {
  if (count != 2) return fprintf(stderr, "usage: plain_c MODEL\n"), 2;
  throng_file* file = throng_load(arguments[1], 0.0);
  check(file != NULL);
  throng_character* character = throng_file_character(file, 0);
  throng_crowd_options options = throng_crowd_options_default();
  options.pus = 2;
  throng_crowd* crowd = throng_crowd_create(character, &options);
  check(crowd != NULL);
  throng_id first = {0, THRONG_NONE}, agents[agent_count];
  check(throng_crowd_add_agents(crowd, first, agent_count, agents) == 0);
  walk(crowd, character, agents);
  write_hands(crowd, character, first);
  static float positions[agent_count][3]; /* a row that leads away from the camera */
  for (int i = 0; i < agent_count; ++i) positions[i][2] = -0.5F * (float)i;
  throng_lod* lod = throng_lod_create();
  throng_lod_frame frame = throng_lod_frame_default();
  frame.positions = positions[0];
  frame.count = agent_count;
  frame.frame_step = 1.0 / 60.0;
  unsigned posed = 0;
  for (int number = 0; number < frames; ++number) {
    throng_pose_request* requests;
    uint32_t request_count;
    check(throng_crowd_advance(crowd, frame.frame_step) == 0);
    check(throng_lod_select(lod, crowd, &frame, &requests, &request_count) == 0);
    for (uint32_t i = 0; i < request_count; ++i) requests[i].joints = hands[requests[i].agent.number].rotation;
    check(throng_crowd_update(crowd, requests, request_count) == 0);
    check(throng_lod_settle(lod, crowd) == 0);
    posed += request_count;
  }
  printf("the hand of agent 0 is %.2f m high; %u of %d poses were computed\n", (double)hands[0].position[1], posed,
         agent_count * frames);
  throng_lod_free(lod);
  throng_crowd_free(crowd);
  throng_character_free(character);
  throng_file_free(file);
}
