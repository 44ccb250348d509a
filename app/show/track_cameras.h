#pragma once

#include <vector>

#include "app/people/crowd/followers.h"
#include "app/show/camera/scenes.h"
#include "app/show/crowd_framing.h"

namespace throng::app {

/// Returns a box around all that ever moves in a recorded crowd.
FramedBox box_of(const Followers& followers, float height);

/// Returns the cameras of a recorded crowd, which see in `part` of the picture all that ever moves in it: front, above,
/// close, far, tower and top. `close` stands among the people. `top` looks down with the file's y up, from so far away
/// that it has hardly any perspective, as a plan. `height` is a person's.
std::vector<NamedCamera> track_cameras(const Followers& followers, float height, float aspect,
                                       const PicturePart& part = {});

}  // namespace throng::app
