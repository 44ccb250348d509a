// The roles and the parts of the body in MODEL.throng.json, and what a small character makes of them.

#include "app/character/bone_lod.h"
#include "app/character/role_table.h"
#include "engine/anim/asset/synthetic_model.h"
#include "tests/fuzz/scratch_file.h"
#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace throng;
  static const fuzz::ScratchFile file("model.glb.throng.json");
  static const anim::Model model = anim::synthetic_model(23, 3);
  static const std::vector<std::string> clip_names{"clip_0", "clip_1", "clip_2"};
  file.put(data, size);
  const app::RoleFile roles(file.path().substr(0, file.path().size() - std::string_view(".throng.json").size()));
  app::RoleClips clips = app::no_clips();
  if (const auto read = roles.read()) static_cast<void>(app::choose_clips(*read, clip_names, clips));
  anim::Skeleton skeleton = model.skeleton;
  if (const auto read = roles.read_rig()) static_cast<void>(app::choose_bones(*read, skeleton));
  return 0;
}
