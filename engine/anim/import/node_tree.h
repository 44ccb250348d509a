#pragma once

#include <vector>

#include <glm/mat4x4.hpp>

#include "engine/anim/base/transform.h"
#include "engine/anim/import/document.h"

namespace throng::import {

/// The rest transform of a node. A matrix that is a plain TRS is stored as one.
struct NodeTransform {
  anim::Transform trs;
  glm::dmat4 matrix{1.0};   ///< in double: of the TRS as the file writes it, or the node's matrix
  bool has_matrix = false;  ///< so the node may not be animated
  bool is_trs = true;       ///< false for a matrix with shear, whose `trs` is the identity
};

/// The nodes of a document as a forest. Arrays have one element a node.
struct NodeTree {
  std::vector<int> parents;        ///< -1 for a root
  std::vector<int> parents_first;  ///< every node, after its parent
  std::vector<bool> in_scene;      ///< in the default scene, or in the first where the file names none
  std::vector<bool> is_drawn;      ///< in the scene, and neither it nor a node above is hidden
  std::vector<NodeTransform> transforms;
  std::vector<glm::dmat4> globals;  ///< rest pose, scene space

  int size() const { return static_cast<int>(parents.size()); }
};

/// Builds the forest. Reports hidden meshes. Refuses two parents, cycles, a matrix beside TRS, and zero rotations.
NodeTree build_node_tree(Document& document);

}  // namespace throng::import
