#pragma once

#include <string>

#include "app/show/request/request.h"
#include "engine/base/json/json.h"
#include "engine/base/result.h"

namespace throng::app {

/// Returns a request by its name, as recordings and messages have it: {"share": {"character": 0, "share": 2.5}}. It has
/// the values that differ from `before`.
Json to_json(const CrowdRequest& request, const Tuning& before = {});
/// Reads it. Values that it does not name are taken from `before`. The error is the end of a sentence.
Result<CrowdRequest> read_request(const Json& json, const Tuning& before = {});

}  // namespace throng::app
