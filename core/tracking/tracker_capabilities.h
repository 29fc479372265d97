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

// Capabilities: interfaces that only some trackers implement. Callers obtain such an interface by
// capability() and must handle null.
namespace dewpoint::tracking {

/// Tracker whose parameters can be changed during a run.
class Configurable {
public:
  virtual ~Configurable() = default;
  /// Sets new values of the method's parameters, which apply from the next iteration on.
  virtual void configure(const ParameterValues& parameters) = 0;
};

/// Tracker for targets that the project defines.
class TargetTracking {
public:
  virtual ~TargetTracking() = default;
  /// Sets new definitions of the targets, in the same order. The number of targets may be another
  /// one, unless the tracker is also a FixedTargetCount.
  virtual void setTargets(const std::vector<Target>& targets) = 0;
};

/// Tracker whose number of targets cannot change during a run. For another number of targets, a new
/// tracker is needed.
class FixedTargetCount {
public:
  virtual ~FixedTargetCount() = default;
  /// Returns the number of targets, which is that of the tracker's construction.
  virtual std::size_t targetCount() const = 0;
};

/// Tracker in which the user can correct the position of a target.
class PositionCorrecting {
public:
  virtual ~PositionCorrecting() = default;
  /// Sets the target's position in the last iterated frame (world frame, m, m²). The new position
  /// replaces all previous information about the position, and estimate() returns it immediately.
  /// The radius, the colors and the learned backgrounds are kept. The images of the frame may be
  /// used to make the position more precise. Other tracked objects at this position are removed.
  virtual void correctPosition(std::size_t target, const Gaussian3& position, ThreadTeam& team) = 0;
};

/// Tracker that estimates positions in the world with calibrated cameras.
class RigConfigurable {
public:
  virtual ~RigConfigurable() = default;
  /// Sets another calibration of the same cameras from the next iteration on; tracks are kept.
  virtual void setCameras(const CameraRig& rig) = 0;
};

/// Tracker that searches for targets only inside a volume of interest, and reports no target
/// outside it.
class VolumeBounded {
public:
  virtual ~VolumeBounded() = default;
  /// Sets the volume from the next iteration on; without a value, the space is unlimited. New
  /// tracks begin inside the volume from the next restart on, or immediately if no frame has been
  /// processed yet.
  virtual void setVolumeOfInterest(const std::optional<WorldBox>& volume) = 0;
};

/// Tracker that uses background images, which show the scene without targets.
class BackgroundImageConfigurable {
public:
  virtual ~BackgroundImageConfigurable() = default;
  /// Sets one background image per camera (CV_8UC3, in the order of the cameras in the rig). The
  /// image is empty for a camera without a background image. The images take effect at the next
  /// restart. Methods for people then need no learning phase.
  virtual void setBackgroundImages(const std::vector<cv::Mat>& images) = 0;
};

/// Tracker that can be copied during a run, so that the run can return to an earlier frame.
class Copyable {
public:
  virtual ~Copyable() = default;
  /// Returns whether the tracker can be copied. The result is false if the tracker uses a
  /// background model of OpenCV, which cannot be copied. This is a question, and not a property of
  /// the type, because a parameter chooses the background model: the same type of tracker can be
  /// copied with one model and not with another.
  virtual bool canBeCopied() const = 0;
  /// Returns a copy that continues from the present state with bit-identical results and shares no
  /// writable data. Returns null if the tracker cannot be copied.
  virtual std::unique_ptr<Tracker> clone() const = 0;
  /// Returns the approximate size of a copy in bytes.
  virtual std::size_t memoryBytes() const = 0;
};

/// Tracker that represents the position of a track by weighted points (particles).
class ParticleCloud {
public:
  virtual ~ParticleCloud() = default;
  /// Copies an even selection of at most `limit` particles of a track: rows of x, y, z (meters),
  /// with linear weights that sum to 1 over all particles. For a person, the particles are the
  /// points of the body. Returns no particles if the track is absent.
  virtual void copyParticles(std::size_t track, int limit, Eigen::ArrayXXd& positions,
                             Eigen::ArrayXd& weights) const = 0;
};

/// Tracker that reports for each camera whether the camera confirms a track, and the reason if not.
class CameraReporting {
public:
  virtual ~CameraReporting() = default;
  /// Returns one report per camera on a track in the current frame, in the order of the cameras in
  /// the rig. Returns no reports before the first frame. Call this function after the last
  /// iteration of the frame.
  virtual std::vector<CameraReport> cameraReports(std::size_t track) const = 0;
};

/// Tracker that also estimates how late the cameras stamp their images.
class ClockEstimating {
public:
  virtual ~ClockEstimating() = default;
  /// Returns the current estimates of the delays, one per camera of the rig.
  virtual std::vector<ClockEstimate> clockEstimates() const = 0;
};

/// Tracker that reports the candidate positions of a track.
class CandidateReporting {
public:
  virtual ~CandidateReporting() = default;
  /// Returns the candidate positions found in the last iteration.
  virtual std::vector<CandidatePosition> positionCandidates(std::size_t track) const = 0;
};

/// Tracker that provides maps of the likelihood of a track over the pixels of every camera.
class LikelihoodMapping {
public:
  virtual ~LikelihoodMapping() = default;
  /// Returns one likelihood map per camera around the estimate of a track, up to `reach` pixels in
  /// each direction.
  virtual std::vector<LikelihoodMap> likelihoodMaps(std::size_t track, int reach) const = 0;
};

/// Tracker that provides maps of the likelihood of motion, by any object, over the images of every
/// camera.
class MotionMapping {
public:
  virtual ~MotionMapping() = default;
  /// Returns one map per camera: log D of the last frame, where D is the motion likelihood of
  /// Mohedano et al. 2009, equation 8. Each map covers the whole image, which may be smaller than
  /// the camera image. The area of a map is empty if its camera has no mask.
  virtual std::vector<LikelihoodMap> motionLikelihoodMaps() const = 0;
};

/// Centers of some particles of a box in the image: rows of x and y, pixels from the upper left
/// corner, with linear weights.
struct BoxParticles {
  Eigen::ArrayXXf centers;
  Eigen::ArrayXf weights;
};

/// Tracker of bounding boxes, each in the images of one camera, without calibration.
class BoxTracking {
public:
  virtual ~BoxTracking() = default;
  /// Starts tracking the content of a box in an image (CV_8UC3), in place of the previous content
  /// of this target. Error: BadValue with the field "image" or "box"; nothing changes then.
  virtual Status startFollowing(std::size_t target, const cv::Mat& bgr, const TargetBox& box,
                                std::uint64_t seed) = 0;
  /// Returns an even selection of at most `limit` particles of a target, or no particles while the
  /// target is absent.
  virtual BoxParticles boxParticles(std::size_t target, int limit) const = 0;
};

/// Tracker that remembers which colors a target had in the frame in which the target was defined.
class ReferenceColorReporting {
public:
  virtual ~ReferenceColorReporting() = default;
  /// Returns the color histogram (boxHistogram()) of the initial box of a target. The histogram is
  /// empty while the target is absent.
  virtual std::vector<double> referenceHistogram(std::size_t target) const = 0;
};

/// Tracker that creates tracks of people automatically. The person with identity N is track N - 1.
class PeopleFinding {
public:
  virtual ~PeopleFinding() = default;
  /// Returns all people tracked after the last frame, in the order of their identities.
  virtual const std::vector<PersonEstimate>& people() const = 0;
  /// Returns all people tracked so far in this run, as targets with the names "person 1", "person
  /// 2", ...
  virtual const std::vector<Target>& peopleAsTargets() const = 0;
  /// Returns the body of a person. The body is empty if the person is not in people().
  virtual BodyCloud bodyOf(int identity) const = 0;
  /// Returns the state of each camera's background model.
  virtual const std::vector<PeopleCameraState>& cameraStates() const = 0;
  /// Returns the motion mask of a camera (CV_8UC1, 255 where something differs from the background,
  /// 0 elsewhere), or an empty image if there is no mask. The mask may be smaller than the camera's
  /// images.
  virtual cv::Mat foregroundMask(std::size_t camera) const = 0;
};

/// Tracker in which the user can add and remove people.
class PersonEditing {
public:
  virtual ~PersonEditing() = default;
  /// Creates a track of a person with the center of the body at `center` (meters, world frame),
  /// regardless of the motion masks. Returns the identity of the new person. Takes effect in the
  /// next frame.
  virtual int addPerson(const Eigen::Vector3d& center) = 0;
  /// Removes the track of a person.
  virtual void removePerson(int identity) = 0;
};

} // namespace dewpoint::tracking
