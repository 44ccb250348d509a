#pragma once

#include <optional>

#include "app/show/request/request.h"

namespace throng::app {

class Show;

/// Carries out a request about the viewer of one character. A request about a viewer that is not there does nothing.
/// Errors: the character cannot be shown alone, or the crowd refuses the choice that was looked at.
Status take(const ViewerRequest& request, Show& show);

/// Returns the roles with the clip that is looked at for one of them; nothing where none is.
std::optional<SetRoles> previewed_roles(const Show& show);

}  // namespace throng::app
