// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/live_pairing.h"

#include <algorithm>
#include <utility>

namespace dewpoint::capture {

using namespace std::chrono_literals;

namespace {

// Chosen, not tuned: for webcams of 10 to 60 images per second, whose arrival varies by some
// milliseconds.
/// Of the shortest interval: above one half, so that cameras of the same rate are always paired,
/// and the pairing does not go back and forth when they are half an interval apart.
constexpr double kWindow = 0.75;
/// How long after it was due a camera's frame is still waited for.
constexpr TimeStamp kLateTimeout = 40ms;
/// Without a frame for so many intervals a camera has stopped: nobody waits for it.
constexpr int kStopped = 3;
/// By how much a frame may come earlier than one interval after the last: a share of it, at most.
constexpr double kJitterShare = 0.3;
constexpr TimeStamp kMostJitter = 8ms;
constexpr TimeStamp kUsualInterval = 33ms; ///< until the cameras' own are known
/// How far whoever takes the groups may fall behind, as after a burst from the network, before the
/// older ones are dropped.
constexpr TimeStamp kMaxBacklog = 100ms;

TimeStamp times(double factor, TimeStamp interval) {
  return std::chrono::duration_cast<TimeStamp>(factor * interval);
}

} // namespace

LivePairing::LivePairing(const std::vector<TimeStamp>& delays) {
  for (const TimeStamp delay : delays) {
    cameras_.push_back({.delay = delay});
  }
}

void LivePairing::setExpectedTiming(std::size_t camera, bool delivers, TimeStamp interval,
                                    TimeStamp latency) {
  cameras_[camera].delivers = delivers;
  cameras_[camera].latency = latency;
  cameras_[camera].frameInterval = interval;
}

void LivePairing::add(std::size_t camera, FramePtr frame) {
  Camera& its = cameras_[camera];
  const TimeStamp time = frame->captureTime;
  const bool isLate = taken_ && time < *taken_;
  const bool isBefore = its.last && time <= *its.last; // its clock was set back
  if (isLate || isBefore) {
    ++dropped_;
    its.last = time;
    return;
  }
  its.last = time;
  its.waitingFrames.push_back(std::move(frame));
}

TimeStamp LivePairing::window() const {
  TimeStamp shortest = TimeStamp::max();
  for (const Camera& camera : cameras_) {
    if (camera.delivers && camera.frameInterval > TimeStamp{}) {
      shortest = std::min(shortest, camera.frameInterval);
    }
  }
  return times(kWindow, shortest == TimeStamp::max() ? kUsualInterval : shortest);
}

TimeStamp LivePairing::deadlineOf(const Camera& camera, TimeStamp begin) const {
  return begin + camera.delay + camera.latency + kLateTimeout;
}

bool LivePairing::canStillAdd(const Camera& camera, TimeStamp begin, TimeStamp now) const {
  if (!camera.delivers || !camera.waitingFrames.empty() || now >= deadlineOf(camera, begin)) {
    return false;
  }
  if (!camera.last || camera.frameInterval == TimeStamp{}) {
    return true;
  }
  const bool stopped =
      now - camera.delay - camera.latency - *camera.last > kStopped * camera.frameInterval;
  const TimeStamp earliest =
      camera.frameInterval - std::min(kMostJitter, times(kJitterShare, camera.frameInterval));
  const bool comesLater = *camera.last + earliest > begin + window();
  return !stopped && !comesLater;
}

std::optional<TimeStamp> LivePairing::oldestFrameTime() const {
  std::optional<TimeStamp> begin;
  for (const Camera& camera : cameras_) {
    if (!camera.waitingFrames.empty()) {
      const TimeStamp first = camera.waitingFrames.front()->captureTime;
      begin = begin ? std::min(*begin, first) : first;
    }
  }
  return begin;
}

std::optional<LivePairing::Group> LivePairing::takeCompleteGroup(TimeStamp now) {
  const auto begin = oldestFrameTime();
  if (!begin || std::ranges::any_of(cameras_, [&](const Camera& camera) {
        return canStillAdd(camera, *begin, now);
      })) {
    return std::nullopt;
  }
  Group group{*begin, {}};
  const TimeStamp end = *begin + window();
  for (Camera& camera : cameras_) {
    const bool adds =
        !camera.waitingFrames.empty() && camera.waitingFrames.front()->captureTime <= end;
    group.frames.push_back(adds ? camera.waitingFrames.front() : FramePtr());
    if (adds) {
      camera.waitingFrames.pop_front();
    }
  }
  return group;
}

std::optional<std::vector<FramePtr>> LivePairing::takeGroup(TimeStamp now) {
  while (auto group = takeCompleteGroup(now)) {
    completeGroups_.push_back(std::move(*group));
  }
  if (!completeGroups_.empty() &&
      completeGroups_.back().begin - completeGroups_.front().begin > kMaxBacklog) {
    for (; completeGroups_.size() > 1; completeGroups_.pop_front()) {
      const auto& frames = completeGroups_.front().frames;
      dropped_ += std::ranges::count_if(frames, [](const auto& frame) { return frame != nullptr; });
    }
  }
  if (completeGroups_.empty()) {
    return std::nullopt;
  }
  Group group = std::move(completeGroups_.front());
  completeGroups_.pop_front();
  taken_ = group.begin;
  return std::move(group.frames);
}

std::optional<TimeStamp> LivePairing::dueTime() const {
  if (!completeGroups_.empty()) {
    return completeGroups_.front().begin;
  }
  const auto begin = oldestFrameTime();
  if (!begin) {
    return std::nullopt;
  }
  TimeStamp latest = *begin;
  for (const Camera& camera : cameras_) {
    if (camera.delivers && camera.waitingFrames.empty()) {
      latest = std::max(latest, deadlineOf(camera, *begin));
    }
  }
  return latest;
}

} // namespace dewpoint::capture
