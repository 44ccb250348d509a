#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <tiny_gltf.h>

#include "engine/anim/asset/clip.h"
#include "engine/anim/asset/model.h"
#include "engine/anim/import/buffer_views.h"
#include "engine/anim/import/humanoid.h"
#include "engine/anim/import/memory/memory_account.h"
#include "engine/anim/import/model_files.h"
#include "engine/base/result.h"

namespace throng::import {

/// The place of an image's encoded bytes: a view, or a uri.
struct ImageSource {
  int buffer_view = -1;
  std::string uri;
  std::string name;
};

/// A coarser mesh that replaces a node's mesh (see json_document.h).
struct MeshLodNode {
  int node = -1;
  double error = 0.0;  ///< metres
};

/// Holds a node's extras about the part that it draws (see json_document.h).
struct PartNode {
  std::string slot, body;
  std::vector<std::string> covers, keeps_out, tags;
  double error = 0.0;  ///< metres
};

/// A checked glTF document. `gltf` is tinygltf's form of the JSON; buffers and images are our own, because tinygltf
/// would open any path. Indices between objects are in range, buffer views lie inside their buffers, and accessors lie
/// inside their views.
struct Document {
  MemoryAccount* memory = nullptr;  ///< of the import; additions to the document are charged to it
  ModelFiles files;
  tinygltf::Model gltf;
  std::vector<std::byte> file;  ///< the bytes that `views` show, unless their storage has them; else none
  BufferViews buffer_views;
  std::vector<ImageSource> images;
  std::map<std::string, Result<anim::Image>> decoded_images;  ///< by the place of their bytes
  std::vector<std::vector<anim::NamedDataKey>> data_keys;     ///< by animation, as the file has them
  std::vector<std::vector<anim::NamedCurve>> curves;          ///< by animation, as the file has them
  std::vector<std::vector<MeshLodNode>> mesh_lods;            ///< by node, as the file has them
  std::map<int, PartNode> parts;                              ///< by node, of nodes that are parts
  std::vector<std::vector<std::string>> target_names;         ///< by mesh, of its morph targets; may be fewer or none
  std::vector<bool> is_hidden;                                ///< by node: KHR_node_visibility hides it and all below
  Humanoid humanoid;
  std::map<std::string, int> channels;  ///< ImportOptions::channels
  std::vector<std::string> repairs;
  std::size_t charged_repairs = 0;
  mutable std::size_t decoded_values = 0;  ///< numbers of all accessors so far, which the reader bounds

  /// Charges `memory` with the repairs that came since. Call it where one part of a file is read many times.
  void charge_repairs();
};

/// Reads and checks a model. `memory` and the files in memory outlive the document. Throws Refusal.
Document load_document(const ModelSource& source, MemoryAccount& memory);

/// Returns `node 3 "Hips"`, for messages; the name only as far as a line shows it.
std::string label(const std::string& type, std::size_t index, const std::string& name);

}  // namespace throng::import
