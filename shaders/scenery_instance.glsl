// Repeats the layout of SceneryRecord of engine/render/scenery/scenery_pass.cpp: scalars only, so that std430 adds no
// gaps.
struct SceneryRecord {
  float place[12];  // four columns
  uint tint;
  uint number;
};

layout(std430, binding = 7) readonly buffer Scenery { SceneryRecord scenery[]; };

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 vertex_color;
layout(location = 3) in vec4 nature;    // glow, tinted, sway, kind
layout(location = 4) in uint instance;  // the index into `scenery`

vec3 column(SceneryRecord record, int first) {
  return vec3(record.place[first], record.place[first + 1], record.place[first + 2]);
}

const float farthest_sway = 0.25;  // metres

// Lets wind move leaves and flags: gusts that pass over the place, and a flutter within the mesh.
vec3 swayed(vec3 world, uint number) {
  if (nature.z == 0.0) return world;
  float seconds = float(now % 1000000000u) * 1e-6;
  float gust = 0.6 + 0.4 * sin(seconds * 0.7 + 0.05 * (world.x + world.z));
  float phase = seconds * 3.1 + float(number % 97u) * 0.7 + dot(position, vec3(1.9, 0.8, 1.4));
  return world + vec3(sin(phase), 0.35 * sin(phase * 1.7 + 1.0), cos(phase * 0.83)) * (farthest_sway * nature.z * gust);
}

vec3 placed(SceneryRecord record) {
  vec3 world = column(record, 0) * position.x + column(record, 3) * position.y + column(record, 6) * position.z +
               column(record, 9);
  return swayed(world, record.number);
}
