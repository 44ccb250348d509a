#pragma once

#include <string>
#include <vector>

#include "assets/places/mesh_builder.h"

namespace throng::places {

/// A thing that stands in a place: a shape at several levels of detail, 0 the finest.
struct Prop {
  std::string name;
  std::vector<double> errors;  ///< by level: metres that its surface is off the finest
  void (*build)(MeshBuilder& builder, int lod);
  double reach = 1.5;  ///< metres; what is further away does not darken
};

/// All props, in the order of the file.
std::vector<Prop> all_props();

// By subject, each in the file of its name.
std::vector<Prop> facade_props();
std::vector<Prop> town_house_props();
std::vector<Prop> arcade_props();
std::vector<Prop> tower_props();
std::vector<Prop> tree_props();
std::vector<Prop> furniture_props();
std::vector<Prop> fountain_props();
std::vector<Prop> kiosk_props();
std::vector<Prop> cloth_props();
std::vector<Prop> stadium_props();
std::vector<Prop> film_props();
std::vector<Prop> horizon_props();

}  // namespace throng::places
