// throng_wardrobe_sheet FOLDER: what people wear, in pictures for people.
// throng_wardrobe_sheet FILE.png BODY,PART,... [KEY=VALUE ...]: one outfit from four sides. The keys are clip, at
// (seconds), lod, build, frame, posture (-1 to 1), and head, which shows the head alone.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <numbers>
#include <set>
#include <sstream>

#include "app/people/wardrobe/dressed_crowd.h"
#include "app/people/wardrobe/dresser.h"
#include "assets/sheet/contact_sheet.h"
#include "assets/sheet/studio.h"

namespace throng::sheet {
namespace {

namespace fs = std::filesystem;
using app::WardrobePart;

constexpr float quarter = std::numbers::pi_v<float> / 2.0F;

/// Puts an outfit together out of the names of its parts, with the skin that they leave bare.
render::Outfit outfit_of(const app::Clothing& clothing, const std::string& body, const std::set<std::string>& names) {
  std::set<std::string> covered;
  std::vector<const WardrobePart*> worn;
  for (const WardrobePart& part : clothing.wardrobe.parts()) {
    if (!part.fits(body) || !names.contains(part.name)) continue;
    worn.push_back(&part);
    for (const std::string& slot : part.covers) {
      if (slot != part.slot) covered.insert(slot);
    }
  }
  for (const WardrobePart& part : clothing.wardrobe.parts()) {
    const bool is_skin = part.fits(body) && part.name == part.slot && !names.contains(part.name);
    const bool is_listed = std::ranges::find(clothing.rules.skin, part.slot) != clothing.rules.skin.end();
    if (is_skin && is_listed) worn.push_back(&part);
  }
  render::Outfit outfit;
  for (const WardrobePart* part : worn) {
    if (!covered.contains(part->slot)) outfit.pieces.at(outfit.count++) = drawn_piece(*part, worn);
  }
  std::ranges::sort(std::span(outfit.pieces).first(outfit.count));
  return outfit;
}

float size_of(const app::Clothing& clothing, const std::string& body) {
  const auto found = std::ranges::find(clothing.rules.bodies, body, &app::BodyRule::name);
  return found == clothing.rules.bodies.end() ? 1.0F : found->size;
}

/// Takes a thing out of hands whose arms do not hold it.
void put_away(render::Outfit& outfit, std::uint16_t piece) {
  const auto end = std::remove(outfit.pieces.begin(), outfit.pieces.begin() + outfit.count, piece);
  outfit.count = static_cast<std::uint16_t>(end - outfit.pieces.begin());
}

/// Somebody as a crowd dresses them.
Figure person_of(const Studio& studio, const app::Dresser& dresser, std::uint32_t number) {
  Random random(number, 0);
  Figure figure{.clip = number % 3 == 0 ? "step in place" : "idle", .seconds = 0.25 * (number % 4)};
  figure.look = app::look_of(app::random_tints(random), app::random_variant(random), 0);
  const auto bodies = static_cast<std::uint8_t>(studio.clothing().rules.bodies.size());
  const app::Person person{.agent = number,
                           .body = static_cast<std::uint8_t>(number % 7 == 6 ? bodies - 1 : number % 2),
                           .group = number,
                           .team = number % 2};
  const app::Dressed dressed = dresser.dress(person, 0, *figure.look);
  figure.outfit = dressed.outfit;
  if (dressed.in_hand != nullptr) put_away(figure.outfit, dressed.in_hand->piece);
  app::give_face(*figure.look, number, 1, studio.clothing().rules.bodies[person.body].size < 0.8F);
  if (dressed.style->old) app::stoop(*figure.look, number, 1);
  figure.scale = studio.clothing().rules.bodies[person.body].size;
  figure.heading = static_cast<float>(number % 5) * 0.35F - 0.7F;
  return figure;
}

/// Rows of people as many pixels tall.
void add_people(Studio& studio, ContactSheet& sheet, int pixels, int rows, std::size_t mesh_lod) {
  const app::Dresser dresser(studio.clothing().rules, studio.clothing().wardrobe,
                             {.scene = "plaza", .weather = "mild", .seed = 1});
  constexpr int width = 1800;
  const int columns = width / (pixels / 2);
  std::uint32_t number = 0;
  for (int row = 0; row < rows; ++row) {
    std::vector<render::Image> pictures;
    for (int column = 0; column < columns; ++column) {
      Figure person = person_of(studio, dresser, number++);
      person.mesh_lod = mesh_lod;
      pictures.push_back(
          studio.take({.width = pixels / 2, .height = pixels, .metres = 2.1F, .centre = {0, 0.95F, 0}}, {person}));
    }
    sheet.add(beside(pictures));
  }
}

render::AgentLook plain_look_of(std::uint32_t number) {
  Random random(number + 3, 0);
  render::AgentLook look = app::look_of(app::random_tints(random), {}, 0);
  using enum render::Region;
  for (const auto& [region, color] : {std::pair{top, 0xB07A4AU},
                                      {bottom, 0x5A4634U},
                                      {shoes, 0x30343CU},
                                      {outer, 0x4A6A3AU},
                                      {headgear, 0x3A3AA0U},
                                      {thing, 0x405A80U}}) {
    look.tints.at(index_of(region)) = render::tint_of(color, render::Pattern::trim);
    look.seconds.at(index_of(region)) = render::second_of(0xD8DDE0U);
  }
  return look;
}

std::set<std::string> clothes_below(const WardrobePart& part, const std::string& body) {
  std::set<std::string> names{part.name};
  const auto fills = [&](const char* slot) {
    return part.slot == slot || std::ranges::find(part.covers, slot) != part.covers.end() ||
           std::ranges::find(part.keeps_out, slot) != part.keeps_out.end();
  };
  if (!fills("top")) names.insert(part.slot == "outer" ? "shirt" : "t_shirt");
  if (!fills("bottom")) names.insert(part.slot == "shoes" ? "shorts" : "jeans");
  if (!fills("shoes")) names.insert("trainers");
  if (!fills("hair") && part.slot != "headgear") names.insert(body == "woman" ? "bob" : "short_cut");
  return names;
}

/// Each part on each body, front and back.
void add_parts(Studio& studio, ContactSheet& sheet, const std::string& body) {
  constexpr int columns = 12;
  std::vector<render::Image> figures;
  std::uint32_t number = 0;
  const float scale = size_of(studio.clothing(), body);
  const auto flush = [&] {
    if (!figures.empty()) sheet.add(beside(figures));
    figures.clear();
  };
  std::string line;
  for (const WardrobePart& part : studio.clothing().wardrobe.parts()) {
    if (part.body != body || part.slot == "silhouette" || part.name == part.slot) continue;
    for (const float heading : {0.5F, 0.5F + 2 * quarter}) {
      Figure figure{.clip = "idle", .heading = heading, .scale = scale};
      figure.look = plain_look_of(number);
      figure.outfit = outfit_of(studio.clothing(), body, clothes_below(part, body));
      figures.push_back(studio.take(
          {.width = 110, .height = 230, .metres = 2.1F * scale, .centre = {0, 0.95F * scale, 0}}, {figure}));
    }
    line += " " + part.name;
    if (++number % columns != 0) continue;
    std::printf("%s:%s\n", body.c_str(), line.c_str());
    line.clear();
    flush();
  }
  std::printf("%s:%s\n", body.c_str(), line.c_str());
  flush();
}

int write_sheets(Studio& studio, const fs::path& folder) {
  ContactSheet people, parts;
  add_people(studio, people, 300, 4, 0);
  add_people(studio, people, 60, 4, 2);
  add_people(studio, people, 40, 4, 3);
  for (const char* body : {"man", "woman", "child"}) add_parts(studio, parts, body);
  const bool written = people.write(folder / "wardrobe_people.png") && parts.write(folder / "wardrobe_parts.png");
  return written ? 0 : 1;
}

/// The values of KEY=VALUE.
class Values {
 public:
  Values(int count, char** texts) {
    for (int i = 0; i < count; ++i) {
      const std::string text = texts[i];
      const std::size_t equals = std::min(text.find('='), text.size() - 1);
      values_[text.substr(0, equals)] = text.substr(equals + 1);
    }
  }
  bool has(const std::string& key) const { return values_.contains(key); }
  std::string text(const std::string& key, const std::string& otherwise) const {
    return has(key) ? values_.at(key) : otherwise;
  }
  float number(const std::string& key) const { return static_cast<float>(std::atof(text(key, "0").c_str())); }

 private:
  std::map<std::string, std::string> values_;
};

int write_outfit(Studio& studio, const char* file, const std::string& worn, const Values& values) {
  std::stringstream text(worn);
  std::string body, name;
  std::getline(text, body, ',');
  std::set<std::string> names;
  while (std::getline(text, name, ',')) names.insert(name);
  const float scale = size_of(studio.clothing(), body);
  Figure figure{.clip = values.text("clip", "idle"),
                .seconds = static_cast<double>(values.number("at")),
                .scale = scale,
                .mesh_lod = static_cast<std::size_t>(values.number("lod"))};
  figure.look = plain_look_of(0);
  figure.look->shape =
      app::Variant{
          .build = values.number("build"), .frame = values.number("frame"), .posture = values.number("posture")}
          .shape();
  figure.outfit = outfit_of(studio.clothing(), body, names);
  // A close look is square.
  const bool is_close = values.has("metres");
  const float metres = is_close ? values.number("metres") : 2.1F;
  const glm::vec3 centre{values.number("x"), values.has("y") ? values.number("y") : 0.98F, 0.0F};
  std::vector<render::Image> pictures;
  for (const float heading : {0.0F, 0.5F * quarter, quarter, 2.0F * quarter}) {
    figure.heading = heading;
    pictures.push_back(studio.take(
        {.width = 450, .height = is_close ? 450 : 800, .metres = metres * scale, .centre = scale * centre}, {figure}));
  }
  ContactSheet sheet;
  sheet.add(beside(pictures));
  return sheet.write(file) ? 0 : 1;
}

}  // namespace
}  // namespace throng::sheet

int main(int argument_count, char** arguments) {
  if (argument_count < 2) {
    std::fputs("throng_wardrobe_sheet: usage: throng_wardrobe_sheet FOLDER | FILE.png BODY,PART,... [KEY=VALUE ...]\n",
               stderr);
    return 2;
  }
  const auto studio = throng::sheet::Studio::open(true);
  if (!studio) return 1;
  if (argument_count == 2) return throng::sheet::write_sheets(*studio, arguments[1]);
  return throng::sheet::write_outfit(*studio, arguments[1], arguments[2], {argument_count - 3, arguments + 3});
}
