// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/thread_team.h"
#include "core/capture/frame.h"
#include "core/tracking/target.h"
#include "core/tracking/track_estimate.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dewpoint::tracking {

/// Tracking method, with the tracks of one run. Call beginFrame() once per frame set, then
/// iterate() any number of times. The class is not thread-safe. The same seed gives bit-identical
/// results for any size of the ThreadTeam.
///
/// Every method implements this interface. The file tracker_capabilities.h declares further
/// interfaces that only some methods implement. To obtain such an interface, call for example
/// capability<LikelihoodMapping>(tracker).
class Tracker {
public:
  virtual ~Tracker() = default;
  /// Removes all tracks and starts from scratch, with random numbers from `seed`. Background images
  /// are kept.
  virtual void restart(std::uint64_t seed) = 0;
  /// Returns the number of iterations per frame.
  virtual int iterationsPerFrame() const = 0;
  /// Sets the frame to process. If `frames` is null, releases the images of the last frame.
  virtual void beginFrame(FrameSetPtr frames) = 0;
  /// Runs one filter iteration for all tracks.
  virtual void iterate(ThreadTeam& team) = 0;
  /// Returns the number of tracks. There is one track per target that the project defines. If the
  /// method finds its targets automatically, there is one track per target found so far. A track
  /// keeps its index.
  virtual std::size_t trackCount() const = 0;
  /// Returns the current estimate of track number `track`, which must be less than trackCount().
  virtual TrackEstimate estimate(std::size_t track) const = 0;

protected:
  Tracker() = default;
  Tracker(const Tracker&) = default;
  Tracker& operator=(const Tracker&) = default;
};

/// Returns the estimates of all tracks.
std::vector<TrackEstimate> estimatesOf(const Tracker& tracker);

/// Returns the tracker as an interface of tracker_capabilities.h, or null if the method of the
/// tracker does not implement this interface.
template <class Capability> Capability* capability(Tracker& tracker) {
  return dynamic_cast<Capability*>(&tracker);
}
template <class Capability> const Capability* capability(const Tracker& tracker) {
  return dynamic_cast<const Capability*>(&tracker);
}

} // namespace dewpoint::tracking
