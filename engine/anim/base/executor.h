#pragma once

#include "throng/host.h"

namespace throng::anim {
using throng::Executor, throng::InOrder, throng::Job;
}
