// Makes the bodies of instances differ, in the space of the bind pose, and their colours. Include instance_record.glsl
// before it.
#include "agent_look.glsl"

// The character's size over that of a person, for whom the reaches below are meant.
layout(location = 5) uniform float body_size;

// A vertex with a share of 1 in a variation moves this many metres of a person.
const float stout_reach = 0.048;
const float broad_reach = 0.026;
const vec3 stooped_reach = vec3(0.0, -0.016, 0.058);
const float full_hair_reach = 0.034;
const float cropped_hair_reach = 0.010;
const vec3 long_hair_reach = vec3(0.0, -0.125, 0.008);

vec3 varied(const InstanceRecord instance, vec3 position, vec3 normal, vec3 shape, vec2 hair) {
  vec3 body = unpackSnorm4x8(looks[instance.agent].shape).xyz;
  vec2 style = unpackSnorm4x8(looks[instance.agent].hair).xy;
  float outward = stout_reach * body.x * shape.x + broad_reach * body.y * shape.y;
  outward += style.x * hair.x * (style.x < 0.0 ? cropped_hair_reach : full_hair_reach);
  return position + normal * (body_size * outward) + body_size * stooped_reach * (body.z * shape.z) +
         body_size * long_hair_reach * (style.y * hair.y);
}

#ifdef DRESSED
const float jaw_reach = 0.011, nose_reach = 0.013, eyes_reach = 0.005;
const vec3 brow_reach = vec3(0.0, -0.003, 0.007);

// Returns how far a vertex moves for the face of an instance. The share of the eyes has the sign of their side.
vec3 face_of(const InstanceRecord instance, vec3 normal, vec4 face) {
  vec4 own = unpackSnorm4x8(looks[instance.agent].face) * face;
  return body_size * (jaw_reach * own.x * normal + brow_reach * own.z + vec3(eyes_reach * own.w, 0.0, nose_reach * own.y));
}
#endif

vec3 shaded(const InstanceRecord instance, vec3 color) {
  return color * (1.0 + shade_reach * unpackSnorm4x8(looks[instance.agent].shade).rgb);
}
