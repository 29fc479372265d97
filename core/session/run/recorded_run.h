// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame_source.h"
#include "core/project/project.h"
#include "core/session/run/box_track_file.h"
#include "core/session/run/frame_loop.h"
#include "core/trajectory/trajectory.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::session {

/// Some particles of a target: rows x y z, meters, world frame, and their weights, linear, which
/// sum to 1 over all particles of the target.
struct ParticleSample {
  Eigen::Array<double, Eigen::Dynamic, 3, Eigen::RowMajor> positions;
  Eigen::ArrayXd weights;
};
/// At most `limit` particles of a target of a run, evenly picked.
ParticleSample particlesOf(const TrackingRun& run, std::size_t target, int limit);

/// What a run found, kept in memory.
struct RecordedRun {
  Trajectory trajectory; ///< as it is written by `dewpoint-cli track`; empty for image targets
  BoxTrack boxes;        ///< of methods that follow boxes
  /// By frame and number of the target; only where they were requested.
  std::map<std::pair<std::int64_t, std::size_t>, ParticleSample> particles;
  std::vector<std::string> targets; ///< by their numbers
  std::int64_t frames = 0;          ///< that were tracked
  bool finished = false;            ///< to the end of the frames that were requested
  std::optional<Error> broken;      ///< why the recording broke off after some frames
  std::vector<std::string> notices; ///< sentences about the recording and its cameras
};

/// What is wanted of a run.
struct RunOrder {
  FrameRange frames;
  int threads = 1;       ///< never change the result
  int particleLimit = 0; ///< of each target in each frame; 0: none is kept
};

/// How many frames are done, and of how many, if that is known; false: no more is wanted.
using RunProgress = std::function<bool(std::int64_t, std::optional<std::int64_t>)>;

/// Tracks a recording and keeps what is found; the same bits as `dewpoint-cli track`. `progress` is
/// called before each frame and after the last one; `emptyRooms` as of loadEmptyRooms(). Errors of
/// checkMethodTargets() and TrackingRun::create(), and of the source where not a single frame was
/// tracked; see `broken`.
Result<RecordedRun> recordRun(const Project& project, FrameSetSource& source,
                              const std::vector<cv::Mat>& emptyRooms, const RunOrder& order,
                              const RunProgress& progress);

} // namespace dewpoint::session
