#pragma once

#include "engine/base/result.h"  // An installed tree has that file in place of this one.
