#pragma once

#include "engine/result.h"  // a header of the base for all who include it from here
