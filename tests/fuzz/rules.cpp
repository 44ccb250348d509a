// Rules of who wears what: what is read is written again, reads as the same, is doubted in words, and dresses a person.

#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/people/wardrobe/cast_rules.h"
#include "app/people/wardrobe/cast_rules_text.h"
#include "app/people/wardrobe/dresser.h"
#include "app/people/wardrobe/rule_doubts.h"
#include "tests/fuzz/target.h"

namespace throng::fuzz {
namespace {

/// Has every part that the rules name, for everybody.
app::Wardrobe wardrobe_for(const app::CastRules& rules) {
  std::vector<anim::ModelPart> parts;
  for (const app::Style& style : rules.styles) {
    for (const app::SlotRule& slot : style.wears) {
      for (const app::WeighedName& named : slot.parts) {
        anim::ModelPart& part = parts.emplace_back();
        part.name = named.name, part.slot = slot.slot;
      }
    }
  }
  return app::Wardrobe(parts);
}

void dress_somebody(const app::CastRules& rules) {
  const app::Wardrobe wardrobe = wardrobe_for(rules);
  for (const std::string& doubt : app::doubts_of(rules, wardrobe)) {
    if (doubt.empty() || doubt.find('\n') != std::string::npos) std::abort();
  }
  for (const char* const scene : {"plaza", "stadium"}) {
    const app::Dresser dresser(rules, wardrobe, {.scene = scene, .weather = "rain", .seed = 1});
    for (std::uint32_t agent = 0; agent < 4; ++agent) {
      render::AgentLook look;
      const auto body = static_cast<std::uint8_t>(agent % rules.bodies.size());
      static_cast<void>(dresser.dress({.agent = agent, .body = body, .marches = agent > 2}, 0, look));
    }
  }
}

}  // namespace
}  // namespace throng::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace throng;
  const auto rules = app::rules_of_text({reinterpret_cast<const char*>(data), size});
  if (!rules || rules->styles.empty()) return 0;
  const auto again = app::rules_of_text(app::rules_text(*rules));
  if (!again || !(*again == *rules)) std::abort();
  fuzz::dress_somebody(*rules);
  return 0;
}
