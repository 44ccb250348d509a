#include <algorithm>
#include <climits>
#include <span>

#include "engine/anim/api/c/parts.h"

namespace throng::c {
namespace {

constexpr std::uint32_t most_of_a_byte = 255;  // more is as wrong

PoseRequest request_of(const throng_pose_request& request) {
  PoseRequest own;
  own.agent = agent_id(request.agent);
  own.level = static_cast<std::uint8_t>(std::min(request.level, most_of_a_byte));
  own.look_ahead = ticks_of(request.look_ahead);
  own.palette = reinterpret_cast<std::byte*>(request.palette);
  own.joints = reinterpret_cast<std::byte*>(request.joints);
  own.fade_level = static_cast<std::uint8_t>(std::min(request.fade_level, most_of_a_byte));
  own.fade_halves = static_cast<std::uint8_t>(std::min(request.fade_halves, most_of_a_byte));
  return own;
}

/// Copies requests to memory of the crowd, which grows to the largest update so far.
void take_requests(throng_crowd& crowd, std::span<const throng_pose_request> requests) {
  crowd.requests.clear();
  for (const throng_pose_request& request : requests) crowd.requests.push_back(request_of(request));
}

}  // namespace
}  // namespace throng::c

using namespace throng::c;  // NOLINT: functions of C have no namespace

int throng_crowd_advance(throng_crowd* crowd, double seconds) {
  const Call call("throng_crowd_advance");
  if (call.is_missing(crowd)) return failed;
  crowd->own.advance(ticks_of(seconds));
  return call.outcome();
}

double throng_crowd_clock(const throng_crowd* crowd) {
  return is_missing("throng_crowd_clock", crowd) ? 0.0 : to_seconds(crowd->own.clock());
}

int throng_crowd_update(throng_crowd* crowd, const throng_pose_request* requests, uint32_t count) {
  const Call call("throng_crowd_update");
  if (call.is_missing(crowd) || call.lacks(requests, count)) return failed;
  take_requests(*crowd, {requests, count});
  crowd->own.update(crowd->requests);
  return call.outcome();
}

int throng_crowd_update_all(throng_crowd* crowd, float* palettes, size_t bytes, uint32_t stride) {
  const Call call("throng_crowd_update_all");
  if (call.is_missing(crowd, palettes)) return failed;
  auto* const memory = reinterpret_cast<std::byte*>(palettes);
  crowd->requests.clear();
  for (const AgentId agent : crowd->own.agents()) {
    const Agent own = crowd->own.agent(agent);
    const std::size_t needed = crowd->own.palette_bytes(own.character());
    if (stride < needed || bytes / stride <= agent.number) {
      return fail("throng_crowd_update_all: there is no room for the palette of agent " + std::to_string(agent.number));
    }
    crowd->requests.push_back({.agent = agent, .palette = memory + std::size_t{agent.number} * stride});
  }
  crowd->own.update(crowd->requests);
  return call.outcome();
}

int throng_crowd_pose_exactly(throng_crowd* crowd, const throng_pose_request* requests, uint32_t count) {
  const Call call("throng_crowd_pose_exactly");
  if (call.is_missing(crowd) || call.lacks(requests, count)) return failed;
  take_requests(*crowd, {requests, count});
  crowd->own.pose_exactly(crowd->requests);
  return call.outcome();
}

int throng_crowd_local_pose(throng_crowd* crowd, throng_id agent, throng_transform* bones, uint32_t count) {
  const Call call("throng_crowd_local_pose");
  if (call.is_missing(crowd, bones)) return failed;
  const bool is_known = crowd->own.local_pose(agent_id(agent), as<LocalTransform>(bones, count));
  if (!call.went_well()) return failed;
  return is_known ? done : fail("throng_crowd_local_pose: the present pose of the agent is not known");
}

int throng_crowd_bounds(throng_crowd* crowd, throng_id agent, throng_bounding_box* box) {
  const Call call("throng_crowd_bounds");
  if (call.is_missing(crowd, box)) return failed;
  *box = std::bit_cast<throng_bounding_box>(crowd->own.bounds(agent_id(agent)));
  return call.outcome();
}

throng_snapshot* throng_crowd_snapshot(const throng_crowd* crowd) {
  const Call call("throng_crowd_snapshot");
  if (call.is_missing(crowd)) return nullptr;
  auto* const made = make<throng_snapshot>();
  if (made == nullptr) return nullptr;
  crowd->own.snapshot(made->own);
  if (call.went_well()) return made;
  delete made;
  return nullptr;
}

int throng_crowd_snapshot_into(const throng_crowd* crowd, throng_snapshot* snapshot) {
  const Call call("throng_crowd_snapshot_into");
  if (call.is_missing(crowd, snapshot)) return failed;
  crowd->own.snapshot(snapshot->own);
  return call.outcome();
}

int throng_crowd_restore(throng_crowd* crowd, const throng_snapshot* snapshot) {
  if (is_missing("throng_crowd_restore", crowd, snapshot)) return failed;
  return outcome(crowd->own.restore(snapshot->own));
}

size_t throng_snapshot_bytes(const throng_snapshot* snapshot) {
  return is_missing("throng_snapshot_bytes", snapshot) ? 0 : snapshot->own.bytes();
}

void throng_snapshot_free(throng_snapshot* snapshot) { delete snapshot; }

uint64_t throng_crowd_pose_hash(const throng_crowd* crowd) {
  return is_missing("throng_crowd_pose_hash", crowd) ? 0 : crowd->own.debug().pose_hash();
}

uint32_t throng_crowd_posed_agents(const throng_crowd* crowd) {
  return is_missing("throng_crowd_posed_agents", crowd) ? 0 : crowd->own.debug().posed_agents();
}

double throng_crowd_predicted_nanoseconds(const throng_crowd* crowd) {
  return is_missing("throng_crowd_predicted_nanoseconds", crowd) ? 0.0 : crowd->own.debug().predicted_nanoseconds();
}

double throng_crowd_update_milliseconds(const throng_crowd* crowd) {
  return is_missing("throng_crowd_update_milliseconds", crowd) ? 0.0 : crowd->own.debug().update_milliseconds();
}

double throng_crowd_bytes_per_agent(const throng_crowd* crowd) {
  return is_missing("throng_crowd_bytes_per_agent", crowd) ? 0.0 : crowd->own.debug().bytes_per_agent();
}

const char* throng_crowd_kernels(const throng_crowd* crowd) {
  return is_missing("throng_crowd_kernels", crowd) ? nullptr : crowd->own.debug().kernels();
}

uint32_t throng_crowd_trace(const throng_crowd* crowd, uint32_t pu, throng_pu_span* spans, uint32_t most) {
  if (is_missing("throng_crowd_trace", crowd) || (most > 0 && is_missing("throng_crowd_trace", spans))) return 0;
  const std::vector<PuSpan> all = crowd->own.debug().trace(pu <= INT_MAX ? static_cast<int>(pu) : -1);
  const std::span written(all.data(), std::min<std::size_t>(all.size(), most));
  std::ranges::transform(written, spans, [](const PuSpan& one) {
    return throng_pu_span{.name = one.name,
                          .begin = one.begin,
                          .end = one.end,
                          .agents = one.agents,
                          .bytes_in = one.bytes_in,
                          .bytes_out = one.bytes_out};
  });
  return static_cast<uint32_t>(all.size());
}
