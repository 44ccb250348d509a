#include "engine/anim/api/c/parts.h"

namespace throng::c {

static_assert(THRONG_FORM_CUBIC_SPLINE == static_cast<int>(KeyForm::cubic_spline));

template <>
throng_bone_to_build default_of() {
  const BoneToBuild own;
  throng_bone_to_build bone{};
  bone.parent = static_cast<uint32_t>(own.parent);  // -1 becomes THRONG_NONE
  bone.rest = std::bit_cast<throng_transform>(own.rest);
  return bone;
}

namespace {

BoneToBuild bone_of(const throng_bone_to_build& bone) {
  BoneToBuild own;
  own.name = view_of(bone.name);
  own.parent = static_cast<int>(bone.parent);  // THRONG_NONE becomes -1
  own.rest = std::bit_cast<LocalTransform>(bone.rest);
  if (bone.inverse_bind != nullptr) own.inverse_bind = to_mat4(bone.inverse_bind);
  own.role = view_of(bone.role);
  return own;
}

/// Hands keys to a function of CharacterBuilder.
template <typename Value>
int set_keys(const char* name, throng_builder* builder, uint32_t clip, uint32_t bone, const throng_bone_keys* keys,
             void (CharacterBuilder::*set)(int, int, const BoneKeys<Value>&)) {
  const Call call(name);
  if (call.is_missing(builder, keys)) return failed;
  if (!call.is_constant("throng_bone_keys::form", keys->form, KeyForm::cubic_spline)) return failed;
  if (keys->count > 0 && call.is_missing(keys->seconds, keys->values)) return failed;
  const auto form = static_cast<KeyForm>(keys->form);
  const std::size_t values_a_key = form == KeyForm::cubic_spline ? 3 : 1;
  (builder->own.*set)(static_cast<int>(clip), static_cast<int>(bone),
                      {.seconds = elements<float>(keys->seconds, keys->count),
                       .values = elements<Value>(keys->values, values_a_key * keys->count),
                       .form = form});
  return call.outcome();
}

}  // namespace
}  // namespace throng::c

using namespace throng::c;  // NOLINT: functions of C have no namespace

int throng_bone_to_build_fill(throng_bone_to_build* into, size_t size) {
  return fill("throng_bone_to_build_fill", into, size);
}

throng_builder* throng_builder_create(const char* name) {
  if (is_missing("throng_builder_create", name)) return nullptr;
  return make<throng_builder>(CharacterBuilder(name));
}

void throng_builder_free(throng_builder* builder) { delete builder; }

uint32_t throng_builder_add_bone(throng_builder* builder, const throng_bone_to_build* bone) {
  const Call call("throng_builder_add_bone");
  if (call.is_missing(builder, bone)) return THRONG_NONE;
  const auto read = call.read("throng_bone_to_build", bone);
  return read ? static_cast<uint32_t>(builder->own.add_bone(bone_of(*read))) : THRONG_NONE;
}

uint32_t throng_builder_add_clip(throng_builder* builder, const char* name, double seconds) {
  if (is_missing("throng_builder_add_clip", builder, name)) return THRONG_NONE;
  return static_cast<uint32_t>(builder->own.add_clip(name, seconds));
}

int throng_builder_set_translations(throng_builder* builder, uint32_t clip, uint32_t bone,
                                    const throng_bone_keys* keys) {
  return set_keys("throng_builder_set_translations", builder, clip, bone, keys, &CharacterBuilder::set_translations);
}

int throng_builder_set_rotations(throng_builder* builder, uint32_t clip, uint32_t bone, const throng_bone_keys* keys) {
  return set_keys("throng_builder_set_rotations", builder, clip, bone, keys, &CharacterBuilder::set_rotations);
}

int throng_builder_set_scales(throng_builder* builder, uint32_t clip, uint32_t bone, const throng_bone_keys* keys) {
  return set_keys("throng_builder_set_scales", builder, clip, bone, keys, &CharacterBuilder::set_scales);
}

int throng_builder_add_data_key(throng_builder* builder, uint32_t clip, const char* name, double seconds) {
  if (is_missing("throng_builder_add_data_key", builder, name)) return failed;
  builder->own.add_data_key(static_cast<int>(clip), name, seconds);
  return done;
}

int throng_builder_add_curve(throng_builder* builder, uint32_t clip, const char* name, const float* seconds,
                             const float* values, uint32_t count) {
  const Call call("throng_builder_add_curve");
  if (call.is_missing(builder, name) || (count > 0 && call.is_missing(seconds, values))) return failed;
  builder->own.add_curve(static_cast<int>(clip), name, elements<float>(seconds, count), elements<float>(values, count));
  return call.outcome();
}

throng_file* throng_builder_build(const throng_builder* builder, const throng_load_options* options) {
  const Call call("throng_builder_build");
  if (call.is_missing(builder)) return nullptr;
  std::vector<BoneRole> rig;
  const auto own = load_options_of(call, options, rig);
  return own ? make_of<throng_file>(builder->own.build(*own)) : nullptr;
}
