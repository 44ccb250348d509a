// The order of bones in MODEL.lod.json, and a small model that is brought into it.

#include "app/character/bone_lod.h"
#include "engine/anim/asset/skeleton_order.h"
#include "engine/anim/asset/synthetic_model.h"
#include "tests/fuzz/scratch_file.h"
#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace throng;
  static const fuzz::ScratchFile file("model.glb.lod.json");
  static const anim::Model model = anim::synthetic_model(5, 1);
  file.put(data, size);
  const app::BoneLodFile orders(file.path().substr(0, file.path().size() - std::string_view(".lod.json").size()));
  const auto order = orders.read(model.skeleton);
  if (!order || !*order) return 0;
  anim::Model reordered = model;
  anim::reorder_bones(reordered, **order);
  return 0;
}
