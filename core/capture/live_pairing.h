// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace dewpoint::capture {

/// Groups frames of live cameras by capture time, for cameras with any frame rates and delays.
///
/// A group starts with the oldest waiting frame. It also includes the oldest waiting frame of every
/// other camera if this frame was captured at most three quarters of the shortest frame interval
/// after the first one. A slow camera is therefore missing from most groups, and does not delay a
/// fast one. If the caller is slow and groups accumulate, the oldest groups are dropped.
///
/// A group is complete when one of these holds for each camera:
/// - The group contains a frame of the camera.
/// - The camera has sent a later frame.
/// - The camera is not expected to send a frame in time.
/// - The camera is overdue.
///
/// All times are capture times: seconds by the clock of the live session, minus the camera's delay.
/// Not thread-safe.
class LivePairing {
public:
  /// `delays`: for each camera, the time from the capture of an image to its arrival.
  explicit LivePairing(const std::vector<TimeStamp>& delays);

  /// Sets whether a camera is expected to deliver frames, its frame interval (0 if unknown), and
  /// its latency. The latency is the time from the reported capture of an image to its arrival, not
  /// including the camera's delay. It is 0 if the time of arrival is used as the capture time.
  void setExpectedTiming(std::size_t camera, bool delivers, TimeStamp interval,
                         TimeStamp latency = {});
  /// Adds a frame of a camera. Drops the frame if it is older than the last group taken.
  void add(std::size_t camera, FramePtr frame);

  /// Removes and returns the next group, one frame per camera (null where missing). A group is
  /// ready when its frames have arrived, or when the time to wait for missing frames is over.
  /// Returns nothing if no group is ready at time `now` of the session's clock.
  std::optional<std::vector<FramePtr>> takeGroup(TimeStamp now);
  /// Returns the latest time, by the session's clock, at which the next group will be complete.
  /// Returns nothing if no frame is waiting.
  std::optional<TimeStamp> dueTime() const;
  /// Returns the capture time of the oldest waiting frame; nothing if no frame is waiting.
  std::optional<TimeStamp> oldestFrameTime() const;
  /// Returns the number of frames that were not in any group, or whose group was dropped.
  std::int64_t droppedCount() const { return dropped_; }

private:
  struct Camera {
    TimeStamp delay{};
    bool delivers = false;
    TimeStamp frameInterval{};
    TimeStamp latency{};
    std::optional<TimeStamp> last = std::nullopt; ///< capture time of the newest frame so far
    std::deque<FramePtr> waitingFrames = {};
  };
  struct Group {
    TimeStamp begin{};
    std::vector<FramePtr> frames;
  };

  TimeStamp window() const;
  TimeStamp deadlineOf(const Camera& camera, TimeStamp begin) const;
  bool canStillAdd(const Camera& camera, TimeStamp begin, TimeStamp now) const;
  /// Removes and returns the group that starts with the oldest frame; nothing if it is not
  /// complete.
  std::optional<Group> takeCompleteGroup(TimeStamp now);

  std::vector<Camera> cameras_;
  std::deque<Group> completeGroups_;
  std::optional<TimeStamp> taken_; ///< capture time of the first frame in the last group taken
  std::int64_t dropped_ = 0;
};

} // namespace dewpoint::capture
