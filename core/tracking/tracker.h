// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame.h"
#include "core/color/color_range.h"
#include "core/filter/gaussian.h"
#include "core/geometry/camera.h"
#include "core/observation/sphere/camera_evidence.h"
#include "core/tracking/camera_report.h"
#include "core/tracking/insight.h"
#include "core/tracking/parameters.h"
#include "core/tracking/target.h"

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::base {
class ThreadTeam;
} // namespace dewpoint::base

namespace dewpoint::tracking {

/// What a tracker believes after one filter iteration. World frame, metres.
struct TargetEstimate {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();       ///< weighted mean (MMSE)
  Eigen::Vector3d best = Eigen::Vector3d::Zero();       ///< particle of highest weight (MAP)
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< m²
  double effectiveSampleSize = 0.0;
  int particleCount = 0;
  int camerasSeeing = 0;  ///< cameras with target color at the projected mean
  bool valid = false;     ///< seen by two cameras (by the only one, if there is one)
  double existence = 0.0; ///< probability that the target is where the estimate says
  double radius = 0.0;    ///< metres, of the target as known or as estimated; 0 when neither
  /// What the images of this frame alone say of the place (m, m²), with errors of its own; nothing
  /// if the target was not found in them, or the method does not tell.
  std::optional<Gaussian3> seen;
  bool gone = false;       ///< has left for good, or is not there yet: a person
  bool degenerate = false; ///< no particle had a usable weight; all were kept as equal
  /// What each camera says about the mean, in the order of the rig; empty when the method cannot
  /// tell, or has no place to ask about.
  std::vector<CameraEvidence> cameras;
  /// The color range in use in each camera where it follows the light; empty while all cameras use
  /// the target's own.
  std::vector<ColorRange> colors;
  /// Root mean square distance of the particles to their mean, metres.
  double spread() const;
};

/// One method tracking one target. `beginFrame` once per frame set, then `iterate` any number of
/// times. Not thread safe; the same seed gives the same bits for any size of the ThreadTeam.
class Tracker {
public:
  virtual ~Tracker() = default;
  virtual void configure(const ParameterValues& parameters) = 0;
  virtual void setTarget(const Target& target) = 0;
  /// Another calibration of the same cameras, from the next iteration on; beliefs stay.
  virtual void setCameras(const CameraRig& rig) = 0;
  /// Forgets everything and starts anew.
  virtual void restart(std::uint64_t seed) = 0;
  virtual int iterationsPerFrame() const = 0;
  virtual void beginFrame(FrameSetPtr frames) = 0;
  virtual TargetEstimate iterate(ThreadTeam& team) = 0;
  /// At most `limit` particles, evenly picked: rows x y z (metres), with linear weights that sum
  /// to 1 over all particles.
  virtual void particles(int limit, Eigen::ArrayXXd& positions, Eigen::ArrayXd& weights) const = 0;
  /// A copy that goes on from here with the same bits, and shares nothing that either writes.
  virtual std::unique_ptr<Tracker> clone() const = 0;
  /// About how many bytes a copy takes.
  virtual std::size_t memoryBytes() const = 0;
  /// What each camera has to say on the target being held or not, after the iterations of a frame.
  virtual std::vector<CameraReport> explain() const = 0;
  /// Around the estimate, up to `reach` pixels in each direction; one per camera.
  virtual std::vector<LikelihoodMap> likelihoodMaps(int reach) const = 0;
};

/// A tracker of the named method; NotFound for an unknown one.
Result<std::unique_ptr<Tracker>> makeTracker(const std::string& method,
                                             const ParameterValues& parameters,
                                             const CameraRig& rig, const Target& target);

} // namespace dewpoint::tracking
