// Repeats the layout of throng/render/instance_record.h: 60 bytes, scalars only, so that std430 adds no gaps.
struct InstanceRecord {
  float position_x, position_y, position_z;
  float scale;
  float heading_cosine, heading_sine;
  uint palette_from, palette_to;
  uint blend_start, blend_duration;
  uint agent;
  uint debug_color;
  uint bone_level;
  uint weights;
  float contact_scale;
};

layout(std430, binding = 0) readonly buffer Instances { InstanceRecord instances[]; };

vec3 position_of(const InstanceRecord instance) {
  return vec3(instance.position_x, instance.position_y, instance.position_z);
}

// Turns `v` about +Y by the agent's heading; cosine 1 keeps +Z.
vec3 turned(const InstanceRecord instance, vec3 v) {
  return vec3(instance.heading_cosine * v.x + instance.heading_sine * v.z, v.y,
              instance.heading_cosine * v.z - instance.heading_sine * v.x);
}

vec3 to_world(const InstanceRecord instance, vec3 position) {
  return position_of(instance) + instance.scale * turned(instance, position);
}
