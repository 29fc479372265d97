// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace dewpoint::capture {

/// Groups the frames of live cameras by capture time, whatever rates and delays the cameras have.
///
/// A group begins with the oldest waiting frame. From every other camera it takes the frame that
/// was captured within three quarters of the shortest frame interval after the first one. The group
/// is complete as soon as no camera can add to it: each camera has a frame in it, or has a later
/// frame, or is not expected to send one in time, or is overdue. A slow camera is missing from most
/// groups and does not hold up a fast one. If the caller is slow and groups pile up, the older ones
/// are dropped.
///
/// All times are capture times: seconds by the clock of the live session, minus the delay of the
/// camera. Not thread safe.
class LivePairing {
public:
  /// `delays`: for each camera, the time from the scene that an image shows to the arrival of the
  /// image.
  explicit LivePairing(const std::vector<TimeStamp>& delays);

  /// Sets whether frames are expected from a camera, and their interval (0: not known yet).
  void setExpected(std::size_t camera, bool delivers, TimeStamp interval);
  /// Adds a frame with its capture time. A frame that is older than a group already taken is
  /// dropped.
  void add(std::size_t camera, FramePtr frame);

  /// Frames of the next group, one per camera (null where one is missing); nothing if no group is
  /// complete at the time `now` of the session's clock.
  std::optional<std::vector<FramePtr>> take(TimeStamp now);
  /// Latest time, by the session's clock, at which the waiting group is complete; nothing if no
  /// frame waits.
  std::optional<TimeStamp> due() const;
  /// Number of frames that were in no group, or whose group was dropped.
  std::int64_t dropped() const { return dropped_; }

private:
  struct Camera {
    TimeStamp delay{};
    bool delivers = false;
    TimeStamp interval{};
    std::optional<TimeStamp> last = std::nullopt; ///< capture time of the newest frame so far
    std::deque<FramePtr> waiting = {};
  };
  struct Group {
    TimeStamp begin{};
    std::vector<FramePtr> frames;
  };

  TimeStamp window() const;
  TimeStamp deadlineOf(const Camera& camera, TimeStamp begin) const;
  bool canStillAdd(const Camera& camera, TimeStamp begin, TimeStamp now) const;
  std::optional<TimeStamp> oldest() const;
  /// Removes the group that begins with the oldest frame; nothing if it is not complete.
  std::optional<Group> settledGroup(TimeStamp now);

  std::vector<Camera> cameras_;
  std::deque<Group> settled_;
  std::optional<TimeStamp> taken_; ///< begin of the last group that was taken
  std::int64_t dropped_ = 0;
};

} // namespace dewpoint::capture
