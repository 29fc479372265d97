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

/// Some of a target's particles: rows of x, y, z in meters, world frame, and their linear weights.
/// The weights of all particles of the target, including those left out, sum to 1.
struct ParticleSample {
  Eigen::Array<double, Eigen::Dynamic, 3, Eigen::RowMajor> positions;
  Eigen::ArrayXd weights;
};
/// Returns an even selection of at most `limit` particles of a target.
ParticleSample particlesOf(const TrackingRun& run, std::size_t target, int limit);

/// Results of a run, kept in memory.
struct RecordedRun {
  Trajectory trajectory; ///< trajectory as written by `dewpoint-cli track`; empty for image targets
  BoxTrack boxTrack;     ///< bounding boxes; empty unless the method tracks boxes
  /// Particles by frame and target index. Contains only the particles that were requested.
  std::map<std::pair<std::int64_t, std::size_t>, ParticleSample> particles;
  std::vector<std::string> targetNames; ///< target names, by target index
  std::int64_t frameCount = 0;          ///< number of tracked frames
  bool isFinished = false;              ///< all requested frames were tracked
  std::optional<Error> endError;        ///< error that ended the recording after some frames
  std::vector<std::string> notices;     ///< messages about the recording and its cameras
};

/// Options of recordRun().
struct RecordRunOptions {
  FrameRange frames;
  int threadCount = 1;        ///< number of filter threads; it never affects the result
  int particleLimit = 0;      ///< maximum number of particles kept per target and frame; 0: none
  FrameObservers observers{}; ///< receive each tracked frame
};

/// Function that receives the number of finished frames and, if known, the total number. If it
/// returns false, the run ends.
using RunProgress = std::function<bool(std::int64_t, std::optional<std::int64_t>)>;

/// Tracks a recording and returns the results, which are bit-identical to those of `dewpoint-cli
/// track`. `progress` is called before each frame and after the last one. `backgroundImages` has
/// one image per camera, as returned by loadBackgroundImages(). Returns the errors of
/// checkMethodTargets() and TrackingRun::create(). If reading the source fails, returns its error
/// if no frame was tracked yet; otherwise, stores the error in `endError` and returns the results
/// so far.
Result<RecordedRun> recordRun(const Project& project, FrameSetSource& source,
                              const std::vector<cv::Mat>& backgroundImages,
                              const RecordRunOptions& order, const RunProgress& progress);

} // namespace dewpoint::session
