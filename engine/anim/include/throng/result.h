#pragma once

#include "engine/result.h"  // An installed tree has that file in place of this one.
