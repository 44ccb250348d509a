#pragma once

#include "engine/base/result.h"

namespace throng::app {

/// Checks that an OpenGL driver can have the memory and the address space that it takes before it draws anything.
/// Software renderers crash without them, far from any code of ours. The error says what is missing.
anim::Status check_room_to_draw();

/// Tells Mesa's software renderer to draw on the thread that calls it where the system starts no more threads, because
/// it would wait forever for the threads that it did not get. Does nothing where LP_NUM_THREADS is set already. Call it
/// before a context is opened, on the only thread that reads or writes the environment.
void spare_driver_threads();

}  // namespace throng::app
