#include "engine/base/json/json_object.h"

#include <cstdio>
#include <utility>

#include "engine/base/text/plain_text.h"

namespace throng {

JsonObject::JsonObject(std::string name, const Json& object, std::initializer_list<std::string_view> keys,
                       std::optional<std::string>& complaint)
    : name_(std::move(name)), object_(&object), complaint_(&complaint) {
  if (!object.is_object() && !*complaint_) *complaint_ = (name_.empty() ? "it" : name_) + " must be an object";
  const Json::Member* const other = object.member_beside(keys);
  if (other == nullptr || *complaint_) return;
  std::string known;
  for (const std::string_view key : keys) known.append(known.empty() ? "" : ", ").append(key);
  *complaint_ = (name_.empty() ? "it" : name_) + " has an unknown key " + in_quotes(other->key) + "; it knows " + known;
}

void JsonObject::version(int wanted) const {
  const Json& found = (*this)["version"];
  if (!found.is_number() || found.get<double>() != wanted) wrong("version", std::to_string(wanted));
}

void JsonObject::need(std::initializer_list<std::string_view> keys) const {
  for (const std::string_view key : keys) {
    if (!has(key)) complain('"' + std::string(key) + "\" is missing");
  }
}

void JsonObject::number(std::string_view key, double& value, double least, double most) const {
  if (!has(key)) return;
  const Json& member = (*this)[key];
  const double found = member.is_number() ? member.get<double>() : std::nan("");
  if (found >= least && found <= most) {
    value = found;
    return;
  }
  char range[96];
  std::snprintf(range, sizeof(range), "a number, %g to %g", least, most);
  wrong(key, range);
}

void JsonObject::wholes(std::string_view key, std::vector<int>& values, int least, int most) const {
  if (!has(key)) return;
  if ((*this)[key].are_whole(least, most)) return read(key, values, "");
  wrong(key, "an array of whole numbers, " + std::to_string(least) + " to " + std::to_string(most));
}

std::span<const Json> JsonObject::elements(std::string_view key) const {
  if (has(key) && !(*this)[key].is_array()) wrong(key, "an array");
  return (*this)[key].elements();
}

std::span<const Json::Member> JsonObject::members(std::string_view key) const {
  if (has(key) && !(*this)[key].is_object()) wrong(key, "an object");
  return (*this)[key].members();
}

void JsonObject::wrong(std::string_view key, std::string_view expected) const {
  complain('"' + std::string(key) + "\" must be " + std::string(expected));
}

void JsonObject::complain(std::string_view what) const {
  if (!*complaint_) *complaint_ = (name_.empty() ? "" : name_ + ": ") + std::string(what);
}

}  // namespace throng
