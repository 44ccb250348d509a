#pragma once

#include "engine/anim/asset/model.h"
#include "engine/anim/asset/skeleton_order.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/pack/archive.h"
#include "engine/anim/survey/placement_guess.h"

namespace throng::pack {

/// These functions name the members of everything that a pack holds, for the three archives (archive.h). A new member
/// of a struct is added here too; the layout that packs carry changes by itself.

// These functions describe a skeleton.

template <typename Archive, Same<anim::Transform> T>
void describe(Archive& archive, T& transform) {
  archive(transform.translation, transform.rotation, transform.scale);
}

template <typename Archive, Same<anim::Bone> T>
void describe(Archive& archive, T& bone) {
  archive(bone.name, bone.node, bone.parent, bone.rest, bone.prefix, bone.prefix_holds_matrix, bone.role);
}

template <typename Archive, Same<anim::ReferenceFrame> T>
void describe(Archive& archive, T& frame) {
  archive(frame.rotation, frame.origin, frame.scale);
}

template <typename Archive, Same<anim::PaletteEntry> T>
void describe(Archive& archive, T& entry) {
  archive(entry.bone, entry.post);
}

template <typename Archive, Same<anim::Skeleton> T>
void describe(Archive& archive, T& skeleton) {
  archive(skeleton.name, skeleton.rigid, skeleton.bones, skeleton.references, skeleton.palette,
          skeleton.level_bone_counts);
}

// These functions describe the clips of a file.

template <typename Archive, typename T>
requires Same<T, anim::Track<glm::vec3>> || Same<T, anim::Track<glm::quat>>
void describe(Archive& archive, T& track) { archive(track.interpolation, track.times, track.values); }

template <typename Archive, Same<anim::BoneTracks> T>
void describe(Archive& archive, T& tracks) {
  archive(tracks.bone, tracks.translation, tracks.rotation, tracks.scale);
}

template <typename Archive, Same<anim::NamedDataKey> T>
void describe(Archive& archive, T& key) {
  archive(key.time, key.name);
}

template <typename Archive, Same<anim::MorphTrack> T>
void describe(Archive& archive, T& track) {
  archive(track.interpolation, track.morphs, track.times, track.weights);
}

template <typename Archive, Same<anim::NamedCurve> T>
void describe(Archive& archive, T& curve) {
  archive(curve.name, curve.times, curve.values);
}

template <typename Archive, Same<anim::Clip> T>
void describe(Archive& archive, T& clip) {
  archive(clip.name, clip.animation, clip.start, clip.duration, clip.tracks, clip.data_keys, clip.morph_tracks,
          clip.curves);
}

// These functions describe skins, surfaces, their images and materials.

template <typename Archive, Same<anim::Skin> T>
void describe(Archive& archive, T& skin) {
  archive(skin.skin, skin.name, skin.bones, skin.palette_entries, skin.inverse_binds, skin.bind_to_model,
          skin.mesh_nodes);
}

template <typename Archive, Same<anim::Image> T>
void describe(Archive& archive, T& image) {
  archive(image.width, image.height);
  archive.lend(image.rgba, image.lender);
}

template <typename Archive, Same<anim::Texture> T>
void describe(Archive& archive, T& texture) {
  archive(texture.image, texture.coords, texture.wrap_u, texture.wrap_v, texture.magnified, texture.minified);
}

template <typename Archive, Same<anim::Material> T>
void describe(Archive& archive, T& material) {
  archive(material.name, material.base_color, material.base_color_texture, material.emission, material.emission_texture,
          material.unlit, material.double_sided, material.blended, material.alpha_cutoff, material.metallic,
          material.roughness, material.metallic_roughness_texture, material.normal_scale, material.normal_texture,
          material.occlusion_strength, material.occlusion_texture);
}

template <typename Archive, Same<anim::Morph> T>
void describe(Archive& archive, T& morph) {
  archive(morph.name, morph.node, morph.target, morph.rest_weight);
}

template <typename Archive, Same<anim::MorphDelta> T>
void describe(Archive& archive, T& delta) {
  archive(delta.vertex, delta.morph, delta.position, delta.normal);
}

template <typename Archive, Same<anim::VertexChannel> T>
void describe(Archive& archive, T& channel) {
  archive(channel.name, channel.components, channel.values);
}

template <typename Archive, Same<anim::SkinnedMesh> T>
void describe(Archive& archive, T& mesh) {
  archive(mesh.name, mesh.material, mesh.positions, mesh.normals, mesh.tangents, mesh.texture_coords, mesh.colors,
          mesh.regions, mesh.channels, mesh.palette_entries, mesh.weights, mesh.indices, mesh.morph_deltas);
}

template <typename Archive, Same<anim::BakedMeshLod> T>
void describe(Archive& archive, T& lod) {
  archive(lod.error, lod.meshes);
}

template <typename Archive, Same<anim::ModelPart> T>
void describe(Archive& archive, T& part) {
  archive(part.name, part.slot, part.body, part.covers, part.keeps_out, part.tags, part.meshes, part.lods, part.error);
}

/// Names all of a model but its clips, which have a section of their own.
template <typename Archive, Same<anim::Model> T>
void describe(Archive& archive, T& model) {
  archive(model.skeleton, model.skins, model.meshes, model.mesh_lods, model.materials, model.images, model.morphs,
          model.faces_backwards, model.parts);
}

/// Names all of a file but its models.
template <typename Archive, Same<anim::ImportedFile> T>
void describe(Archive& archive, T& file) {
  archive(file.file, file.animations, file.repairs, file.notes);
}

// These functions describe a baked character.

template <typename Archive, Same<anim::HierarchyStep> T>
void describe(Archive& archive, T& step) {
  archive(step.load, step.store, step.first_entry, step.entry_count);
}

template <typename Archive, Same<anim::HierarchyProgram> T>
void describe(Archive& archive, T& program) {
  archive(program.rigid, program.bone_count, program.slot_count, program.steps, program.to_model_origin,
          program.offsets, program.joint_step, program.prefixes, program.has_prefix, program.posts, program.skin_joint);
}

template <typename Archive, Same<anim::RootKey> T>
void describe(Archive& archive, T& key) {
  archive(key.time, key.x, key.y, key.z, key.yaw);
}

template <typename Archive, Same<anim::RootCurve> T>
void describe(Archive& archive, T& curve) {
  archive(curve.duration, curve.keys);
}

template <typename Archive, Same<anim::DataKey> T>
void describe(Archive& archive, T& key) {
  archive(key.time, key.name);
}

template <typename Archive, Same<anim::MorphCurve> T>
void describe(Archive& archive, T& curve) {
  archive(curve.interpolation, curve.morphs, curve.times, curve.weights);
}

template <typename Archive, Same<anim::UserCurve> T>
void describe(Archive& archive, T& curve) {
  archive(curve.name, curve.times, curve.values);
}

template <typename Archive, Same<anim::BakedClip> T>
void describe(Archive& archive, T& clip) {
  archive(clip.name, clip.duration, clip.loops, clip.loop_displacement, clip.root_motion, clip.data_keys);
  archive.template lend_block<anim::KeyframeStream>(clip.keyframe_block);
  archive.template lend_block<anim::SampledStream>(clip.sampled_block);
  archive(clip.keyframe_error, clip.sampled_rate, clip.sampled_error, clip.error_bound, clip.sampled_rounding,
          clip.curves, clip.morphs, clip.stance_speed, clip.note);
}

template <typename Archive, Same<anim::BoneLodRow> T>
void describe(Archive& archive, T& row) {
  archive(row.bone, row.error_metres, row.level);
}

template <typename Archive, Same<anim::BoneLod> T>
void describe(Archive& archive, T& lod) {
  archive(lod.rows, lod.level_error_metres);
}

template <typename Archive, Same<anim::SkipError> T>
void describe(Archive& archive, T& error) {
  archive(error.blended, error.held);
}

template <typename Archive, Same<anim::CharacterBounds> T>
void describe(Archive& archive, T& bounds) {
  archive(bounds.height, bounds.body_radius, bounds.reach);
}

template <typename Archive, Same<anim::PointInfluence> T>
void describe(Archive& archive, T& influence) {
  archive(influence.weighted, influence.entry);
}

template <typename Archive, Same<anim::SurfacePoints> T>
void describe(Archive& archive, T& points) {
  archive(points.influences, points.firsts);
}

template <typename Archive, Same<anim::Character> T>
void describe(Archive& archive, T& character) {
  archive(character.skeleton, character.hierarchy, character.clips, character.data_key_names, character.curve_names,
          character.height, character.bone_lod, character.skip_errors, character.bounds, character.surface_points,
          character.level_entries, character.morph_bones, character.morph_reach);
}

// These functions describe the steps between import and baking.

template <typename Archive, Same<anim::Placement> T>
void describe(Archive& archive, T& placement) {
  archive(placement.scale, placement.rotation, placement.offset);
}

template <typename Archive, Same<anim::PlacementChoice> T>
void describe(Archive& archive, T& choice) {
  archive(choice.scale, choice.up, choice.ground);
}

template <typename Archive, Same<anim::ModelExtent> T>
void describe(Archive& archive, T& extent) {
  archive(extent.size, extent.middle, extent.lowest, extent.top);
}

template <typename Archive, Same<anim::GuessedPlacement> T>
void describe(Archive& archive, T& placement) {
  archive(placement.placement, placement.height, placement.is_plain, placement.choice, placement.extent,
          placement.reasons);
}

template <typename Archive, Same<anim::BoneOrder> T>
void describe(Archive& archive, T& order) {
  archive(order.bones, order.level_counts);
}

}  // namespace throng::pack
