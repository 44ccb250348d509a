#pragma once

#include <span>
#include <string>

#include "app/output/label_frame.h"
#include "engine/base/json/json.h"

namespace throng::app {

/// Returns the line of a frame in labels.jsonl, without its end. app/output/README.md has its keys.
std::string line_of(const LabelFrame& frame);

/// Says what all lines have in common: conventions, and the characters with the names of their joints.
Json label_conventions(std::span<const CharacterSource> characters, std::span<const CocoPoints> coco);

}  // namespace throng::app
