#pragma once

#include "engine/result.h"  // Both libraries share it; files of this one include it from here.
