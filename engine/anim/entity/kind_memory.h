#pragma once

#include "engine/anim/base/pool.h"

namespace throng::anim {

/// The main memory that the blocks of one kind take: blocks of single agents, and blocks that agents share.
struct KindMemory {
  const char* kind = "";
  PoolMemory own;
  PoolMemory shared;
};

}  // namespace throng::anim
