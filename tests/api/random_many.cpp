#include "tests/api/random_calls.h"

namespace throng::api_test {

// Some lists are long enough for several jobs, and name an agent many times.
void RandomCalls::call_many() {
  const std::uint32_t size = one_in(4) ? 600 + below(600) : below(40);
  const auto list = [&](const auto& make) {
    std::vector<decltype(make())> made;
    for (std::uint32_t i = 0; i < size; ++i) made.push_back(make());
    return made;
  };
  const auto ids = [&] { return list([&] { return agent_id(); }); };
  const ManyAgents many = crowd_->many();
  switch (below(9)) {
    case 0:
      many.set_speeds(list([&] { return SpeedRequest{agent_id(), number()}; }));
      return;
    case 1:
      many.set_parameters(list([&] { return ParameterRequest{agent_id(), channel(), number(), number()}; }));
      return;
    case 2:
      many.look_at(list([&] { return GazeRequest{agent_id(), process(), vector(), time()}; }));
      return;
    case 3:
      many.reach(list([&] { return ReachRequest{agent_id(), process(), vector()}; }));
      return;
    case 4:
      many.set_placements(list([&] { return PlacementRequest{agent_id(), process(), place()}; }));
      return;
    case 5:
      many.set_grounds(list([&] { return GroundRequest{agent_id(), process(), index(), vector(), vector()}; }));
      return;
    case 6: {
      std::vector<RootMotion> ways(one_in(4) ? size / 2 : size);
      many.displacements(time(), time(), ids(), ways);
      return;
    }
    case 7:
      static_cast<void>(many.keys(time(), time(), ids(), static_cast<KeyChoice>(below(3))));
      return;
    default: {
      std::vector<Place> places(one_in(4) ? size / 2 : size);
      many.sockets(list([&] { return ProcessOf{agent_id(), process()}; }), places);
    }
  }
}

}  // namespace throng::api_test
