// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace dewpoint::capture {

/// Puts the frames of live cameras together by the time they show, whatever rates and delays the
/// cameras have.
///
/// A group begins with the oldest frame that waits, and takes from every other camera the frame
/// that was taken within three quarters of the shortest frame interval after it. It is settled as
/// soon as no camera can add to it any more: each has a frame in it, or has one that is later, or
/// is not expected to send one in time, or is overdue. A slow camera is missing from most groups
/// and costs a fast one nothing. When groups pile up, because whoever takes them is slow, the older
/// ones are dropped.
///
/// All times are capture times: seconds of the live session's clock, less the camera's delay. Not
/// thread safe.
class LivePairing {
public:
  /// `delays`: of each camera, from what an image shows to its arrival.
  explicit LivePairing(const std::vector<TimeStamp>& delays);

  /// Whether frames are to be expected from a camera, and how far apart (0: not known yet).
  void setExpected(std::size_t camera, bool delivers, TimeStamp interval);
  /// A frame with the time of what it shows. One that is older than a group already taken is
  /// dropped.
  void add(std::size_t camera, FramePtr frame);

  /// The frames of the next group, one for each camera (null where one is missing); nothing while
  /// none is settled at the time `now` of the session's clock.
  std::optional<std::vector<FramePtr>> take(TimeStamp now);
  /// When, by the session's clock, the group that waits is settled at the latest; nothing while
  /// there is no frame.
  std::optional<TimeStamp> due() const;
  /// Frames that no group took, or whose group nobody took.
  std::int64_t dropped() const { return dropped_; }

private:
  struct Camera {
    TimeStamp delay{};
    bool delivers = false;
    TimeStamp interval{};
    std::optional<TimeStamp> last = std::nullopt; ///< of the newest frame so far
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
  /// The group that begins with the oldest frame, taken out; nothing when it is not settled.
  std::optional<Group> settledGroup(TimeStamp now);

  std::vector<Camera> cameras_;
  std::deque<Group> settled_;
  std::optional<TimeStamp> taken_; ///< begin of the last group that was taken
  std::int64_t dropped_ = 0;
};

} // namespace dewpoint::capture
