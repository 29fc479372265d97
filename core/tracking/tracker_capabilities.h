// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/filter/gaussian.h"
#include "core/geometry/camera.h"
#include "core/geometry/world_box.h"
#include "core/tracking/camera_report.h"
#include "core/tracking/clock_estimate.h"
#include "core/tracking/parameters.h"
#include "core/tracking/people_state.h"
#include "core/tracking/target_box.h"
#include "core/tracking/tracker.h"
#include "core/tracking/tracker_diagnostics.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

// Capabilities that only some trackers have. A tracker derives from the capabilities that its
// method supports. Callers obtain a capability by type and must handle null; see capability().
namespace dewpoint::tracking {

/// Has parameters that can be changed during a run.
class Configurable {
public:
  virtual ~Configurable() = default;
  /// Sets new values of the method's parameters, which apply from the next iteration on.
  virtual void configure(const ParameterValues& parameters) = 0;
};

/// Tracks the targets defined in a project.
class TargetTracking {
public:
  virtual ~TargetTracking() = default;
  /// Sets new definitions of the same targets, in the same order. The number of targets may change
  /// only if canChangeTargetCount() returns true.
  virtual void setTargets(const std::vector<Target>& targets) = 0;
  /// Returns whether the number of targets may change during a run.
  virtual bool canChangeTargetCount() const = 0;
};

/// Lets the user correct the position of a target.
class PositionCorrecting {
public:
  virtual ~PositionCorrecting() = default;
  /// Sets the target's position in the last iterated frame (world frame, m, m²). It replaces all
  /// previous information about the position, and estimate() returns it immediately. The radius,
  /// the colors and the learned backgrounds are kept. The images of the frame may be used to make
  /// the position more precise. Other tracked objects at this position are removed.
  virtual void correctPosition(std::size_t target, const Gaussian3& position, ThreadTeam& team) = 0;
};

/// Estimates positions in the world with calibrated cameras.
class CameraCalibrated {
public:
  virtual ~CameraCalibrated() = default;
  /// Sets another calibration of the same cameras from the next iteration on; tracks are kept.
  virtual void setCameras(const CameraRig& rig) = 0;
};

/// Searches for targets only inside a volume of interest, and reports none outside it.
class VolumeBounded {
public:
  virtual ~VolumeBounded() = default;
  /// Sets the volume from the next iteration on; without a value, the space is unlimited. New
  /// tracks begin inside the volume from the next restart on, or immediately if no frame has been
  /// processed yet.
  virtual void setVolumeOfInterest(const std::optional<WorldBox>& volume) = 0;
};

/// Uses background images, which show the scene without targets.
class BackgroundImageUsing {
public:
  virtual ~BackgroundImageUsing() = default;
  /// Sets one image per camera (CV_8UC3, in the order of the cameras in the rig); an image that is
  /// not known is empty. The images take effect at the next restart. Methods for people then need
  /// no learning phase.
  virtual void setBackgroundImages(const std::vector<cv::Mat>& images) = 0;
};

/// Can be copied during a run, so that the run can return to an earlier frame.
class Copyable {
public:
  virtual ~Copyable() = default;
  /// Returns whether the tracker can be copied; false if it uses a background model of OpenCV,
  /// which cannot be copied.
  virtual bool canBeCopied() const = 0;
  /// Returns a copy that continues from here with bit-identical results and shares no writable
  /// data; null if the tracker cannot be copied.
  virtual std::unique_ptr<Tracker> clone() const = 0;
  /// Returns the approximate size of a copy in bytes.
  virtual std::size_t memoryBytes() const = 0;
};

/// Represents the position of a track by weighted points.
class ParticleCloud {
public:
  virtual ~ParticleCloud() = default;
  /// Returns an even selection of at most `limit` particles of a track: rows of x, y, z (meters),
  /// with linear weights that sum to 1 over all particles. For a person, the particles are the
  /// points of the body. There are none if the track is absent.
  virtual void particles(std::size_t track, int limit, Eigen::ArrayXXd& positions,
                         Eigen::ArrayXd& weights) const = 0;
};

/// Reports for each camera whether it confirms a track, and the reason if it does not.
class CameraReporting {
public:
  virtual ~CameraReporting() = default;
  /// Returns one report per camera on a track in the current frame, in the order of the cameras in
  /// the rig; empty before the first frame. Call it after the last iteration of the frame.
  virtual std::vector<CameraReport> cameraReports(std::size_t track) const = 0;
};

/// Estimates during tracking how late the cameras stamp their images.
class ClockEstimating {
public:
  virtual ~ClockEstimating() = default;
  /// Returns the current estimates, one per camera of the rig.
  virtual std::vector<ClockEstimate> clockEstimates() const = 0;
};

/// Reports the candidate positions of a track.
class CandidateReporting {
public:
  virtual ~CandidateReporting() = default;
  /// Returns the candidate positions found in the last iteration.
  virtual std::vector<CandidatePosition> positionCandidates(std::size_t track) const = 0;
};

/// Provides maps of the likelihood of a track over the pixels of every camera.
class LikelihoodMapping {
public:
  virtual ~LikelihoodMapping() = default;
  /// Returns one map per camera around the estimate of a track, up to `reach` pixels in each
  /// direction.
  virtual std::vector<LikelihoodMap> likelihoodMaps(std::size_t track, int reach) const = 0;
};

/// Provides maps of the likelihood of motion, by any object, over the images of every camera.
class MotionMapping {
public:
  virtual ~MotionMapping() = default;
  /// Returns one map per camera: log D of the last frame (Mohedano et al. 2009, equation 8). Each
  /// map covers the whole image, which may be smaller than the camera image. The area of a map is
  /// empty if its camera has no mask.
  virtual std::vector<LikelihoodMap> motionLikelihoods() const = 0;
};

/// Centers of some particles of a box in the image: rows of x and y, pixels from the upper left
/// corner, with linear weights.
struct BoxParticles {
  Eigen::ArrayXXf centers;
  Eigen::ArrayXf weights;
};

/// Tracks bounding boxes, each in the images of one camera, without calibration.
class BoxTracking {
public:
  virtual ~BoxTracking() = default;
  /// Starts tracking the content of a box in an image (CV_8UC3), replacing what this target tracked
  /// before. On an error, BadValue names "image" or "box", and nothing has changed.
  virtual Status follow(std::size_t target, const cv::Mat& bgr, const TargetBox& box,
                        std::uint64_t seed) = 0;
  /// Returns an even selection of at most `limit` particles of a target; none while it is absent.
  virtual BoxParticles boxParticles(std::size_t target, int limit) const = 0;
};

/// Stores the colors of a target as they were when it was defined.
class ReferenceColors {
public:
  virtual ~ReferenceColors() = default;
  /// Returns the color histogram (boxHistogram()) of the initial box of a target; empty while the
  /// target is absent.
  virtual std::vector<double> referenceHistogram(std::size_t target) const = 0;
};

/// Creates tracks of people automatically. Identity N is track N - 1 from its creation on.
class PeopleFinding {
public:
  virtual ~PeopleFinding() = default;
  /// Returns all people tracked after the last frame, in the order of their identities.
  virtual const std::vector<PersonEstimate>& people() const = 0;
  /// Returns all people tracked so far: "person 1", "person 2", ...
  virtual const std::vector<Target>& allPeople() const = 0;
  /// Returns the body of a person of people(); empty for any other identity.
  virtual BodyCloud body(int identity) const = 0;
  /// Returns the state of each camera's background model.
  virtual const std::vector<PeopleCameraState>& cameraStates() const = 0;
  /// Returns the motion mask of a camera (CV_8UC1, 0 or 255), possibly smaller than its images;
  /// empty if there is none.
  virtual cv::Mat foreground(std::size_t camera) const = 0;
};

/// Lets the user add and remove people.
class PersonPlacing {
public:
  virtual ~PersonPlacing() = default;
  /// Creates a track of a person with the center of the body at this position (meters, world
  /// frame), regardless of the masks. Returns the new identity. Takes effect in the next frame.
  virtual int addPerson(const Eigen::Vector3d& center) = 0;
  /// Removes the track of a person.
  virtual void removePerson(int identity) = 0;
};

} // namespace dewpoint::tracking
