#include "app/output/label_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "app/settings/option_values.h"

namespace throng::app {
namespace {

constexpr int metre_decimals = 4, pixel_decimals = 2;

/// Writes JSON piece by piece: a frame of a large crowd has millions of numbers.
class LineWriter {
 public:
  LineWriter& raw(std::string_view text) { return text_ += text, *this; }
  LineWriter& number(double value, int decimals) {
    std::array<char, 64> digits;
    if (!std::isfinite(value)) return raw("0");
    char* end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals).ptr;
    while (decimals > 0 && end[-1] == '0') --end;
    if (end[-1] == '.') --end;
    const std::string_view written(digits.data(), static_cast<std::size_t>(end - digits.data()));
    return raw(written == "-0" ? "0" : written);
  }
  LineWriter& whole(long long value) { return raw(std::to_string(value)); }
  LineWriter& text(std::string_view words) { return raw(Json(words).dump()); }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

/// Writes "[a,b,c]" where `write_one` writes each.
void write_list(LineWriter& line, const auto& elements, const auto& write_one) {
  line.raw("[");
  bool first = true;
  for (const auto& element : elements) {
    if (!first) line.raw(",");
    first = false;
    write_one(element);
  }
  line.raw("]");
}

void write_box(LineWriter& line, const render::PixelBox& box) {
  write_list(line, std::array{box.left, box.top, box.width(), box.height()}, [&](int each) { line.whole(each); });
}

void write_points(LineWriter& line, const auto& points) {
  write_list(line, points, [&](const LabelPoint& point) {
    line.raw("[");
    for (int axis = 0; axis < 3; ++axis) line.number(static_cast<double>(point.place[axis]), metre_decimals).raw(",");
    for (int axis = 0; axis < 2; ++axis) line.number(static_cast<double>(point.pixel[axis]), pixel_decimals).raw(",");
    line.whole(static_cast<int>(point.seen)).raw("]");
  });
}

void write_person(LineWriter& line, const LabelledPerson& person, glm::ivec2 size) {
  const render::PixelBox& whole = person.whole_box;
  const bool cut_off = whole.left == 0 || whole.top == 0 || whole.right == size.x || whole.bottom == size.y;
  line.raw("{\"id\":").text(person.id);
  line.raw(",\"label\":").whole(static_cast<long long>(person.agent) + 1);
  line.raw(",\"character\":").whole(static_cast<long long>(person.character));
  line.raw(",\"role\":").text(person.role).raw(",\"clip\":").text(person.clip);
  line.raw(",\"box\":");
  write_box(line, person.box);
  line.raw(",\"whole_box\":");
  write_box(line, whole);
  line.raw(",\"visible\":").number(person.share_visible, metre_decimals);
  line.raw(",\"cut_off\":").raw(cut_off ? "true" : "false");
  line.raw(",\"position\":");
  const glm::vec3& place = person.position;
  write_list(line, std::array{place.x, place.y, place.z},
             [&](float each) { line.number(static_cast<double>(each), metre_decimals); });
  line.raw(",\"heading\":").number(static_cast<double>(person.heading), metre_decimals);
  line.raw(",\"joints\":");
  write_points(line, person.joints);
  line.raw(",\"coco\":");
  write_points(line, person.coco);
  line.raw("}");
}

void write_matrix(LineWriter& line, int side, const auto& at) {
  line.raw("[");
  for (int row = 0; row < side; ++row) {
    line.raw(row == 0 ? "[" : ",[");
    for (int column = 0; column < side; ++column) {
      if (column > 0) line.raw(",");
      line.raw(shortest_text(at(row, column)));
    }
    line.raw("]");
  }
  line.raw("]");
}

void write_camera(LineWriter& line, const LabelCamera& camera) {
  const glm::mat3 k(glm::vec3(camera.focal.x, 0, 0), glm::vec3(0, camera.focal.y, 0), glm::vec3(camera.middle, 1));
  line.raw("{\"K\":");
  write_matrix(line, 3, [&](int row, int column) { return k[column][row]; });
  line.raw(",\"world_to_camera\":");
  write_matrix(line, 4, [&](int row, int column) { return camera.to_camera[column][row]; });
  line.raw("}");
}

/// Lists a member of each bone.
template <typename Member>
Json list_of_bones(const anim::Skeleton& skeleton, Member anim::Bone::*member) {
  Json list = Json::array();
  for (const anim::Bone& bone : skeleton.bones) list.push_back(bone.*member);
  return list;
}

Json character_json(const CharacterSource& source, const CocoPoints& points) {
  const anim::Skeleton& skeleton = source.character->skeleton;
  Json coco = Json::array();
  for (const CocoPoint& point : points) {
    coco.push_back(point.bone < 0 ? Json(nullptr) : Json(skeleton.bones[static_cast<std::size_t>(point.bone)].name));
  }
  return {{"name", source.name},
          {"is_thing", source.roles.is_prop},
          {"joints", list_of_bones(skeleton, &anim::Bone::name)},
          {"parents", list_of_bones(skeleton, &anim::Bone::parent)},
          {"coco_bones", std::move(coco)}};
}

}  // namespace

std::string line_of(const LabelFrame& frame) {
  LineWriter line;
  constexpr int second_decimals = 6;
  std::array<char, 32> number;
  std::snprintf(number.data(), number.size(), "%06d.png", frame.number);
  line.raw("{\"frame\":").whole(frame.number);
  line.raw(",\"time\":").number(frame.seconds, second_decimals);
  if (frame.file_seconds) line.raw(",\"file_time\":").number(*frame.file_seconds, second_decimals);
  line.raw(",\"size\":[").whole(frame.size.x).raw(",").whole(frame.size.y).raw("]");
  line.raw(",\"mask\":\"mask_").raw(number.data()).raw("\",\"depth\":\"depth_").raw(number.data());
  line.raw("\",\"depth_step\":").raw(shortest_text(frame.metres_a_step));
  line.raw(",\"camera\":");
  write_camera(line, frame.camera);
  line.raw(",\"people\":");
  write_list(line, frame.people, [&](const LabelledPerson& person) { write_person(line, person, frame.size); });
  line.raw("}");
  return line.take();
}

Json label_conventions(std::span<const CharacterSource> characters, std::span<const CocoPoints> coco) {
  Json all = Json::array();
  for (std::size_t i = 0; i < characters.size(); ++i) all.push_back(character_json(characters[i], coco[i]));
  return {{"world", "metres, right-handed, y up; heading is in radians about y, 0 faces +z and pi/2 faces +x"},
          {"camera", "x right, y down, z ahead; pixel = K * (world_to_camera * place), divided by its z; row by row"},
          {"pixels", "from the top left corner of the picture; the pixel in column x and row y is from x to x + 1"},
          {"mask", "grey PNG of 16 bits: label of the person, 0 is no person"},
          {"depth", "grey PNG of 16 bits: times depth_step metres along z; 0 is nothing, 65535 that far or farther"},
          {"boxes", "left, top, width, height"},
          {"points", "x, y, z in metres, column, row, and 0 not in the picture, 1 hidden, 2 visible"},
          {"coco", coco_names},
          {"coco_guessed", coco_face_points},
          {"characters", std::move(all)}};
}

}  // namespace throng::app
