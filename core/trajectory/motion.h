// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/trajectory.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dewpoint::trajectory {

/// Frames in a row at which a target was not held, or of which there is no sample.
struct TrajectoryGap {
  std::string target;
  std::int64_t firstFrame = 0;
  std::int64_t lastFrame = 0;
  double from = 0.0; ///< seconds, of the last held sample before it (its own first, if none)
  double to = 0.0;   ///< seconds, of the first held sample after it (its own last, if none yet)

  std::int64_t frames() const { return lastFrame - firstFrame + 1; }
  double seconds() const { return to - from; }
  bool operator==(const TrajectoryGap&) const = default;
};

/// Velocity at one sample of a track (one target, frames ascending), meters per second: the slope
/// of the straight line fitted by least squares to the held samples up to `reach` before and after
/// it, none beyond a gap. At the center of 2 reach + 1 evenly spaced ones this is the derivative of
/// Savitzky & Golay, Anal. Chem. 36 (1964), table of first derivatives, quadratic. Nothing when the
/// sample is not held or has no held neighbor.
std::optional<Eigen::Vector3d> velocityAt(std::span<const TrajectorySample> track,
                                          std::size_t index, std::size_t reach = 2);

/// Standard deviation of a sample's position along an axis (0 to 2), meters.
double sigmaOf(const TrajectorySample& sample, int axis);

/// Frames that live cameras may skip without anybody having stopped tracking.
inline constexpr std::int64_t kMostSkipped = 8;
/// Whether so much lies between two frames of a track that no line goes from one to the other: they
/// were never tracked.
inline bool isInterrupted(std::int64_t frame, std::int64_t next) {
  return next - frame > kMostSkipped;
}

/// The samples of a run as they come in, with the speed at each and the gaps of each target.
/// Bounded: beyond kMostRows the older half goes.
class MotionLog {
public:
  static constexpr std::size_t kMostRows = 100000;
  struct Row {
    TrajectorySample sample;
    double speed = std::numeric_limits<double>::quiet_NaN(); ///< meters per second, if known
  };
  /// What a change did to rows().
  struct Change {
    std::size_t dropped = 0;      ///< rows gone at the front
    std::size_t firstChanged = 0; ///< rows from here on (after dropping) are others or new
  };

  void clear();
  /// Samples from number `first` (counted since the start) on are these now; from 0: all there are.
  Change replaceFrom(std::size_t first, const std::vector<TrajectorySample>& samples);
  const std::vector<Row>& rows() const { return rows_; }
  /// In the order of their beginning, per target.
  std::vector<TrajectoryGap> gaps() const;

private:
  struct Track {
    std::vector<std::size_t> rows; ///< numbers since the start
    std::vector<TrajectoryGap> gaps;
    bool open = false; ///< the last gap goes on
  };
  void append(const TrajectorySample& sample);
  void truncate(std::size_t size);
  void extendGaps(Track& track, const TrajectorySample* before, const TrajectorySample& sample);
  void updateSpeeds(const Track& track, std::size_t& firstChanged);
  std::size_t drop();

  std::vector<Row> rows_;
  std::size_t dropped_ = 0; ///< rows that are gone
  std::map<std::string, Track> tracks_;
};

} // namespace dewpoint::trajectory
