#pragma once

#include <string>

#include "app/request/request.h"
#include "engine/anim/base/result.h"
#include "engine/anim/import/json/json.h"

namespace throng::app {

/// Returns a request by its name, as recordings and messages have it: {"share": {"character": 0, "share": 2.5}}. It has
/// the values that differ from `before`.
Json to_json(const CrowdRequest& request, const Tuning& before = {});
/// Reads it. Values that it does not name are taken from `before`. The error is the end of a sentence.
anim::Result<CrowdRequest> read_request(const Json& json, const Tuning& before = {});

}  // namespace throng::app
