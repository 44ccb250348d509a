#include "app/show/request/request_json.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/character/rig_table.h"
#include "app/settings/preset.h"
#include "engine/anim/asset/skeleton.h"

namespace throng::app {
namespace {

/// Makes JSON of the values that describe() hands over.
class FieldsToJson {
 public:
  explicit FieldsToJson(const Tuning& before) : before_(&before) {}

  template <typename T>
  void operator()(const char* key, const T& value, auto... /*range*/) {
    json[key] = Json(value);
  }
  void operator()(const char* key, const glm::vec3& value) { json[key] = Json::array({value.x, value.y, value.z}); }
  void operator()(const char* key, const std::vector<RigChoice>& value) { json[key] = rig_json(value); }
  void operator()(const char* key, const anim::PlacementChoice& value) { json[key] = to_json(value); }
  void operator()(const char* key, const std::vector<ChosenCharacter>& value) { json[key] = to_json(value); }
  void operator()(const char* key, const Tuning& value) {
    const Json now = to_json(Preset{.tuning = value, .camera = {}});
    const Json old = to_json(Preset{.tuning = *before_, .camera = {}});
    Json& changed = json[key] = Json::object();
    for (const auto& [name, each] : now.members()) {
      if (old[name] != each) changed[name] = each;
    }
  }
  void rules(const char* key, const std::string& value) { json[key] = rules_json(value); }

  Json json = Json::object();

 private:
  const Tuning* before_;
};

/// Takes from JSON the values that describe() asks for. The first wrong value is kept.
class FieldsFromJson {
 public:
  FieldsFromJson(const Json& json, const Tuning& before) : json_(&json), before_(&before) {}

  void operator()(const char* key, std::uint32_t& value) { read(key, value, "a number"); }
  void operator()(const char* key, bool& value) { read(key, value, "true or false"); }
  void operator()(const char* key, std::string& value) { read(key, value, "a text"); }
  void operator()(const char* key, std::vector<std::string>& value) { read(key, value, "texts"); }
  void operator()(const char* key, double& value) { read(key, value, "a number"); }
  template <typename Number>
  void operator()(const char* key, Number& value, double least, double most) {
    double read_value = 0;
    read(key, read_value, "a number");
    if (!(read_value >= least && read_value <= most)) return refuse(key, range_text<double>(least, most));
    value = static_cast<Number>(read_value);
  }
  void operator()(const char* key, std::optional<std::uint32_t>& value) {
    if ((*json_)[key].is_null()) return value.reset();
    read(key, value.emplace(), "an agent or null");
  }
  void operator()(const char* key, glm::vec3& value) {
    std::vector<float> read_values;
    read(key, read_values, "three numbers");
    const auto is_near = [](float metres) { return std::abs(metres) <= farthest_camera; };
    if (read_values.size() != 3 || !std::ranges::all_of(read_values, is_near)) return refuse(key, "three numbers");
    value = {read_values[0], read_values[1], read_values[2]};
  }
  void operator()(const char* key, std::vector<int>& value) {
    if (!(*json_)[key].are_whole(0, anim::max_bones)) return refuse(key, "indices of bones");
    value = (*json_)[key].get<std::vector<int>>();
  }
  void operator()(const char* key, RoleClips& value) {
    constexpr int most_clips = 65535;
    const Json& clips = (*json_)[key];
    if (!clips.are_whole(no_clip, most_clips) || clips.elements().size() != value.size()) {
      return refuse(key, std::to_string(value.size()) + " clips");
    }
    std::ranges::copy(clips.get<std::vector<int>>(), value.begin());
  }
  void operator()(const char* key, std::vector<RigChoice>& value) {
    if (!wrong) wrong = read_rig_choices((*json_)[key], value);
  }
  void operator()(const char* key, anim::PlacementChoice& value) { read_placement(key, (*json_)[key], wrong, value); }
  void operator()(const char* key, std::vector<ChosenCharacter>& value) {
    value = read_characters((*json_)[key], wrong);
  }
  void operator()(const char* key, Tuning& value) {
    Preset preset{.tuning = *before_, .camera = {}};
    if (!wrong) wrong = from_json((*json_)[key], preset);
    value = preset.tuning;
  }
  void rules(const char* key, std::string& value) { value = rules_in((*json_)[key]); }

  Complaint wrong;

 private:
  void refuse(const char* key, const std::string& expected) {
    if (!wrong) wrong = "\"" + std::string(key) + "\" must be " + expected;
  }
  template <typename T>
  void read(const char* key, T& value, const char* expected) {
    if (!(*json_)[key].is<T>()) return refuse(key, expected);
    value = (*json_)[key].get<T>();
  }

  const Json* json_;
  const Tuning* before_;
};

/// Reads the request of the set that has this name; nothing where none has.
template <typename... All>
Result<CrowdRequest> read_named(const Json::Member& named, const Tuning& before, std::variant<All...>* /*set*/) {
  Result<CrowdRequest> found = Error{"there is no request \"" + named.key + "\""};
  const auto read_if_it_is = [&](auto request) {
    using Asked = decltype(request);
    if (named.key != Asked::name) return;
    FieldsFromJson fields(named.value, before);
    Asked::describe(request, fields);
    found = fields.wrong ? Result<CrowdRequest>(Error{named.key + ": " + *fields.wrong})
                         : Result<CrowdRequest>(std::move(request));
  };
  (read_if_it_is(All{}), ...);
  return found;
}

}  // namespace

Json to_json(const CrowdRequest& request, const Tuning& before) {
  FieldsToJson fields(before);
  const auto describe = [&](const auto& asked) -> const char* {
    std::decay_t<decltype(asked)>::describe(asked, fields);
    return asked.name;
  };
  Json json = Json::object();
  const char* const name = std::visit(describe, request);
  json[name] = std::move(fields.json);
  return json;
}

Result<CrowdRequest> read_request(const Json& json, const Tuning& before) {
  if (json.members().size() != 1) return Error{"a request must be an object with its name"};
  return read_named(json.members().front(), before, static_cast<CrowdRequest*>(nullptr));
}

}  // namespace throng::app
