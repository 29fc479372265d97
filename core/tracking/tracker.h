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

/// A method and the tracks of one run. Call `beginFrame` once per frame set, then `iterate` any
/// number of times. Not thread-safe; the same seed gives bit-identical results for any size of the
/// ThreadTeam.
///
/// This is the interface of every method. Capabilities that only some methods have are declared in
/// tracker_capabilities.h and obtained by type: capability<LikelihoodMapping>(tracker).
class Tracker {
public:
  virtual ~Tracker() = default;
  /// Removes all tracks and starts from scratch; background images stay.
  virtual void restart(std::uint64_t seed) = 0;
  /// Returns the number of iterations per frame.
  virtual int iterationsPerFrame() const = 0;
  /// Sets the frame to process; null releases the images of the last frame.
  virtual void beginFrame(FrameSetPtr frames) = 0;
  /// Runs one filter iteration for all tracks.
  virtual void iterate(ThreadTeam& team) = 0;
  /// Returns the number of tracks: one per defined target, or, if the method finds its targets, one
  /// per target found so far. A track keeps its index.
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

/// Returns the tracker as an interface of tracker_capabilities.h; null if its method does not
/// implement this capability.
template <class Capability> Capability* capability(Tracker& tracker) {
  return dynamic_cast<Capability*>(&tracker);
}
template <class Capability> const Capability* capability(const Tracker& tracker) {
  return dynamic_cast<const Capability*>(&tracker);
}

} // namespace dewpoint::tracking
