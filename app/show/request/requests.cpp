#include "app/show/request/requests.h"

#include <utility>

namespace throng::app {

void Requests::ask(CrowdRequest request) { all_.emplace_back(std::move(request)); }
void Requests::ask(WindowRequest request) { all_.emplace_back(std::move(request)); }
void Requests::ask(FrameRequest request) { all_.emplace_back(std::move(request)); }
void Requests::ask(FileRequest request) { all_.emplace_back(std::move(request)); }
void Requests::ask(CameraRequest request) { all_.emplace_back(std::move(request)); }
void Requests::ask(ViewerRequest request) { all_.emplace_back(std::move(request)); }
void Requests::ask(ReplayRequest request) { all_.emplace_back(std::move(request)); }

void Requests::add(const Requests& more) { all_.insert(all_.end(), more.begin(), more.end()); }

}  // namespace throng::app
