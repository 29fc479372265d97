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

/// A method and the tracks of one run. `beginFrame` once per frame set, then
/// `iterate` any number of times. Not thread safe; the same seed gives the same bits for any size
/// of the ThreadTeam.
///
/// This is the interface of every method. What only some methods can do is declared in
/// tracker_capabilities.h and asked for by type: capability<LikelihoodMapping>(tracker).
class Tracker {
public:
  virtual ~Tracker() = default;
  /// Removes all tracks and starts from scratch; empty rooms stay.
  virtual void restart(std::uint64_t seed) = 0;
  virtual int iterationsPerFrame() const = 0;
  /// Null releases the images of the last frame.
  virtual void beginFrame(FrameSetPtr frames) = 0;
  virtual void iterate(ThreadTeam& team) = 0;
  /// Targets that are followed, or those that were found so far. A track keeps its index.
  virtual std::size_t trackCount() const = 0;
  /// The current estimate of a track below trackCount().
  virtual TrackEstimate estimate(std::size_t track) const = 0;

protected:
  Tracker() = default;
  Tracker(const Tracker&) = default;
  Tracker& operator=(const Tracker&) = default;
};

/// What a tracker believes of all its tracks.
std::vector<TrackEstimate> estimatesOf(const Tracker& tracker);

/// The tracker as something that not every method is; null when its method is not. `Capability` is
/// one of the interfaces of tracker_capabilities.h.
template <class Capability> Capability* capability(Tracker& tracker) {
  return dynamic_cast<Capability*>(&tracker);
}
template <class Capability> const Capability* capability(const Tracker& tracker) {
  return dynamic_cast<const Capability*>(&tracker);
}

} // namespace dewpoint::tracking
