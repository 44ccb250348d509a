#include "app/show/request/requests.h"

#include <utility>

namespace throng::app {

// Here, since compilers doubt a move of such a variant where it is inlined.
void Requests::ask(Request request) { all_.push_back(std::move(request)); }

}  // namespace throng::app
