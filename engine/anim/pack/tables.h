#pragma once

#include <tuple>

#include "engine/anim/asset/model.h"
#include "engine/anim/asset/skeleton_order.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/pack/archive.h"
#include "engine/anim/survey/placement_guess.h"

namespace throng::pack {

/// These functions name the members of everything that a pack holds, for the three archives (archive.h). A new member
/// of a struct is added here too; the layout that packs carry changes by itself. A struct with a block or with lent
/// bytes has a describe() of its own.

// These functions describe a skeleton.
inline auto members(anim::Transform& transform) {
  return std::tie(transform.translation, transform.rotation, transform.scale);
}
inline auto members(anim::Bone& bone) {
  return std::tie(bone.name, bone.node, bone.parent, bone.rest, bone.prefix, bone.prefix_holds_matrix, bone.role);
}
inline auto members(anim::ReferenceFrame& frame) { return std::tie(frame.rotation, frame.origin, frame.scale); }
inline auto members(anim::PaletteEntry& entry) { return std::tie(entry.bone, entry.post); }
inline auto members(anim::Skeleton& skeleton) {
  return std::tie(skeleton.name, skeleton.rigid, skeleton.bones, skeleton.references, skeleton.palette,
                  skeleton.level_bone_counts);
}

// These functions describe the clips of a file.
template <typename Value>
auto members(anim::Track<Value>& track) {
  return std::tie(track.interpolation, track.times, track.values);
}
inline auto members(anim::BoneTracks& tracks) {
  return std::tie(tracks.bone, tracks.translation, tracks.rotation, tracks.scale);
}
inline auto members(anim::NamedDataKey& key) { return std::tie(key.time, key.name); }
inline auto members(anim::MorphTrack& track) {
  return std::tie(track.interpolation, track.morphs, track.times, track.weights);
}
inline auto members(anim::NamedCurve& curve) { return std::tie(curve.name, curve.times, curve.values); }
inline auto members(anim::Clip& clip) {
  return std::tie(clip.name, clip.animation, clip.start, clip.duration, clip.tracks, clip.data_keys, clip.morph_tracks,
                  clip.curves);
}

// These functions describe skins, surfaces, their images and materials.
inline auto members(anim::Skin& skin) {
  return std::tie(skin.skin, skin.name, skin.bones, skin.palette_entries, skin.inverse_binds, skin.bind_to_model,
                  skin.mesh_nodes);
}

template <typename Archive, Same<anim::Image> T>
void describe(Archive& archive, T& image) {
  archive(image.width, image.height);
  archive.lend(image.rgba, image.lender);
}

inline auto members(anim::Texture& texture) {
  return std::tie(texture.image, texture.coords, texture.wrap_u, texture.wrap_v, texture.magnified, texture.minified);
}
inline auto members(anim::Material& material) {
  return std::tie(material.name, material.base_color, material.base_color_texture, material.emission,
                  material.emission_texture, material.unlit, material.double_sided, material.blended,
                  material.alpha_cutoff, material.metallic, material.roughness, material.metallic_roughness_texture,
                  material.normal_scale, material.normal_texture, material.occlusion_strength,
                  material.occlusion_texture);
}
inline auto members(anim::Morph& morph) { return std::tie(morph.name, morph.node, morph.target, morph.rest_weight); }
inline auto members(anim::MorphDelta& delta) {
  return std::tie(delta.vertex, delta.morph, delta.position, delta.normal);
}

inline auto members(anim::VertexChannel& channel) { return std::tie(channel.name, channel.components, channel.values); }

template <typename Archive, Same<anim::SkinnedMesh> T>
void describe(Archive& archive, T& mesh) {
  archive(mesh.name, mesh.material, mesh.positions, mesh.normals, mesh.tangents, mesh.texture_coords, mesh.colors,
          mesh.regions, mesh.channels, mesh.palette_entries, mesh.weights, mesh.indices, mesh.morph_deltas);
}

inline auto members(anim::BakedMeshLod& lod) { return std::tie(lod.error, lod.meshes); }
inline auto members(anim::ModelPart& part) {
  return std::tie(part.name, part.slot, part.body, part.covers, part.keeps_out, part.tags, part.meshes, part.lods,
                  part.error);
}
/// Names all of a model but its clips, which have a section of their own.
inline auto members(anim::Model& model) {
  return std::tie(model.skeleton, model.skins, model.meshes, model.mesh_lods, model.materials, model.images,
                  model.morphs, model.faces_backwards, model.parts);
}
/// Names all of a file but its models.
inline auto members(anim::ImportedFile& file) { return std::tie(file.file, file.animations, file.repairs, file.notes); }

// These functions describe a baked character.
inline auto members(anim::HierarchyStep& step) {
  return std::tie(step.load, step.store, step.first_entry, step.entry_count);
}
inline auto members(anim::HierarchyProgram& program) {
  return std::tie(program.rigid, program.bone_count, program.slot_count, program.steps, program.to_model_origin,
                  program.offsets, program.joint_step, program.prefixes, program.has_prefix, program.posts,
                  program.skin_joint);
}
inline auto members(anim::RootKey& key) { return std::tie(key.time, key.x, key.y, key.z, key.yaw); }
inline auto members(anim::RootCurve& curve) { return std::tie(curve.duration, curve.keys); }
inline auto members(anim::DataKey& key) { return std::tie(key.time, key.name); }
inline auto members(anim::MorphCurve& curve) {
  return std::tie(curve.interpolation, curve.morphs, curve.times, curve.weights);
}
inline auto members(anim::UserCurve& curve) { return std::tie(curve.name, curve.times, curve.values); }

template <typename Archive, Same<anim::BakedClip> T>
void describe(Archive& archive, T& clip) {
  archive(clip.name, clip.duration, clip.loops, clip.closing_step, clip.loop_displacement, clip.root_motion,
          clip.data_keys);
  archive.template lend_block<anim::KeyframeStream>(clip.keyframe_block);
  archive.template lend_block<anim::SampledStream>(clip.sampled_block);
  archive(clip.keyframe_error, clip.sampled_rate, clip.sampled_error, clip.error_bound, clip.sampled_rounding,
          clip.curves, clip.morphs, clip.ground_velocity, clip.note);
}

inline auto members(anim::BoneLodRow& row) { return std::tie(row.bone, row.error_metres, row.level); }
inline auto members(anim::BoneLod& lod) { return std::tie(lod.rows, lod.level_error_metres); }
inline auto members(anim::SkipError& error) { return std::tie(error.blended, error.held); }
inline auto members(anim::CharacterBounds& bounds) { return std::tie(bounds.height, bounds.body_radius, bounds.reach); }
inline auto members(anim::PointInfluence& influence) { return std::tie(influence.weighted, influence.entry); }
inline auto members(anim::SurfacePoints& points) { return std::tie(points.influences, points.firsts); }
inline auto members(anim::Box& box) { return std::tie(box.low, box.high); }
inline auto members(anim::Character& character) {
  return std::tie(character.skeleton, character.hierarchy, character.clips, character.data_key_names,
                  character.curve_names, character.height, character.bone_lod, character.skip_errors, character.bounds,
                  character.surface_points, character.entry_boxes, character.level_entries, character.morph_bones,
                  character.morph_reach);
}

inline auto members(anim::RagdollLimit& limit) {
  return std::tie(limit.parent_axes, limit.axes, limit.hinge, limit.swing, limit.sideways, limit.twist);
}
inline auto members(anim::RagdollBody& body) {
  return std::tie(body.bone, body.parent, body.pose_parent, body.first_link, body.link_count, body.center, body.joint,
                  body.joint_in_parent, body.axis, body.half_length, body.radius, body.inverse_mass,
                  body.inverse_inertia, body.inverse_axial_inertia, body.limit);
}
inline auto members(anim::RagdollLink& link) { return std::tie(link.bone, link.offset); }
inline auto members(anim::RagdollRig& rig) { return std::tie(rig.bodies, rig.links, rig.metre); }

// These functions describe the steps between import and baking.
inline auto members(anim::Placement& placement) {
  return std::tie(placement.scale, placement.rotation, placement.offset);
}
inline auto members(anim::PlacementChoice& choice) { return std::tie(choice.scale, choice.up, choice.ground); }
inline auto members(anim::ModelExtent& extent) {
  return std::tie(extent.size, extent.middle, extent.lowest, extent.top);
}
inline auto members(anim::GuessedPlacement& placement) {
  return std::tie(placement.placement, placement.height, placement.is_plain, placement.choice, placement.extent,
                  placement.reasons);
}
inline auto members(anim::BoneOrder& order) { return std::tie(order.bones, order.level_counts); }

/// Describes a struct by its members(). PackWriter and PackLayout only read them.
template <typename Archive, typename T>
requires requires(std::remove_const_t<T>& value) { members(value); }
void describe(Archive& archive, T& value) { std::apply(archive, members(const_cast<std::remove_const_t<T>&>(value))); }

}  // namespace throng::pack
