#pragma once

#include "app/show/show.h"
#include "tests/soak/round.h"

namespace throng::soak {

/// Looks for a number that is none in the place of everybody, and in every palette that is shown, where they lie in
/// memory that can be read: on the heap.
Fault number_that_is_none(app::Show& show);

}  // namespace throng::soak
