// Makes one colour of the sums of crowd_blended.frag; alpha is the share of what is behind that stays. Leaves pixels to
// which nothing was added as they are.
vec4 blended_average(vec4 sum, float behind) {
  if (behind == 1.0) discard;
  return vec4(sum.rgb / max(sum.a, 1e-5), behind);
}
