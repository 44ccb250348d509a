// Repeats the layout of throng/render/agent_look.h: 88 bytes, scalars only, so that std430 adds no gaps. Include
// instance_record.glsl before it.
struct AgentLook {
  uint tints[9];
  uint seconds[9];
  uint shape;
  uint hair;
  uint shade;
  uint face;
};

layout(std430, binding = 10) readonly buffer Looks { AgentLook looks[]; };

const uint look_regions = 9u, untinted_region = 5u;

// Colours that are the file's own get a little lighter or darker, warmer or cooler; at most by this share.
const float shade_reach = 0.35;
