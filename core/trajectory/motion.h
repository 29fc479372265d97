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

/// Consecutive frames in which a target was not tracked, which means that it has no usable sample
/// there. A sample is usable if it is valid and has a finite position.
struct TrajectoryGap {
  std::string target;
  std::int64_t firstFrame = 0;
  std::int64_t lastFrame = 0;
  /// Time of the last usable sample before the gap, in seconds. If there is none, time of the first
  /// sample in the gap.
  double startTime = 0.0;
  /// Time of the first usable sample after the gap, in seconds. If there is none yet, time of the
  /// last sample in the gap.
  double endTime = 0.0;

  std::int64_t frameCount() const { return lastFrame - firstFrame + 1; }
  double durationSeconds() const { return endTime - startTime; }
  bool operator==(const TrajectoryGap&) const = default;
};

/// Returns the velocity at one sample of a track (one target, ascending frames), in meters per
/// second. A sample is usable if it is valid and has a finite position. The velocity is the slope
/// of the least-squares line through this sample and up to `reach` usable samples on each side of
/// it. Samples beyond a gap are not used. At the center of 2 reach + 1 evenly spaced samples, it
/// equals the derivative of Savitzky & Golay, Anal. Chem. 36 (1964), table of first derivatives,
/// quadratic. Returns nothing if the sample is not usable or has no usable neighbor.
std::optional<Eigen::Vector3d> velocityAt(std::span<const TrajectorySample> track,
                                          std::size_t index, std::size_t reach = 2);

/// Returns the standard deviation of a sample's position along a world axis (0: x, 1: y, 2: z), in
/// meters.
double positionSigma(const TrajectorySample& sample, int axis);

/// Largest difference between the frame numbers of two successive samples at which a track is still
/// drawn as one line. It is above 1 because live cameras may skip frames.
inline constexpr std::int64_t kMaxSkippedFrames = 8;
/// Returns whether two successive frames of a track, `frame` and `next`, are so far apart that no
/// line is drawn between them. In this case, the frames between them were never tracked.
inline bool isTrackInterrupted(std::int64_t frame, std::int64_t next) {
  return next - frame > kMaxSkippedFrames;
}

/// Samples of a run as they arrive, with the speed at each sample and the gaps of each target. When
/// there are more than kMaxRows rows, the older half is dropped.
class MotionLog {
public:
  static constexpr std::size_t kMaxRows = 100000;
  struct Row {
    TrajectorySample sample;
    double speed = std::numeric_limits<double>::quiet_NaN(); ///< meters per second; NaN if unknown
  };
  /// Change to rows() made by a call to replaceFrom().
  struct Change {
    std::size_t droppedRowCount = 0; ///< number of rows removed at the front
    /// Index of the first new or changed row, counted after the removal.
    std::size_t firstChangedRow = 0;
  };

  /// Removes all rows, gaps and targets.
  void clear();
  /// Replaces all samples from index `first` on by `samples`. Indices count from the start of the
  /// run and include dropped rows. If `first` is 0, the samples of the whole run are replaced.
  Change replaceFrom(std::size_t first, const std::vector<TrajectorySample>& samples);
  const std::vector<Row>& rows() const { return rows_; }
  /// Returns the gaps of all targets, ordered by first frame.
  std::vector<TrajectoryGap> gaps() const;

private:
  struct Track {
    std::vector<std::size_t> rowIndices; ///< row indices counted since the start
    std::vector<TrajectoryGap> gaps;
    bool isGapOpen = false; ///< the last gap has not ended
  };
  void append(const TrajectorySample& sample);
  void truncate(std::size_t size);
  void extendGaps(Track& track, const TrajectorySample* before, const TrajectorySample& sample);
  void updateSpeeds(const Track& track, std::size_t& firstChangedRow);
  /// Removes the older half of the rows. Returns the number of rows removed.
  std::size_t dropOldRows();

  std::vector<Row> rows_;
  std::size_t dropped_ = 0; ///< number of rows removed
  std::map<std::string, Track> tracks_;
};

} // namespace dewpoint::trajectory
