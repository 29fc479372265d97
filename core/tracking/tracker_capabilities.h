// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/filter/gaussian.h"
#include "core/geometry/camera.h"
#include "core/geometry/world_box.h"
#include "core/tracking/camera_report.h"
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

// What some trackers can do and others cannot. A tracker derives from those that are its method's;
// whoever needs one asks for it by type and does without when it is null: see capability().
namespace dewpoint::tracking {

/// Has parameters that can be changed during a run.
class Configurable {
public:
  virtual ~Configurable() = default;
  /// Other parameters of the same method, from the next iteration on.
  virtual void configure(const ParameterValues& parameters) = 0;
};

/// Tracks the targets that a project names.
class TargetFollowing {
public:
  virtual ~TargetFollowing() = default;
  /// New definitions of the same targets, in the same order; in another number only where
  /// takesAnyNumber() says so.
  virtual void setTargets(const std::vector<Target>& targets) = 0;
  virtual bool takesAnyNumber() const = 0;
};

/// Lets the user correct where a target is.
class PositionCorrecting {
public:
  virtual ~PositionCorrecting() = default;
  /// In the frame that was iterated last the target is here (world, m, m²): replaces all that was
  /// believed of its position, and estimate() says so at once. Its radius, its colors and the
  /// learned backgrounds stay. The images of the frame may make the position more precise, and what
  /// else was believed to be there gives way.
  virtual void correctPosition(std::size_t target, const Gaussian3& position, ThreadTeam& team) = 0;
};

/// Estimates positions in the world by calibrated cameras.
class CameraCalibrated {
public:
  virtual ~CameraCalibrated() = default;
  /// Another calibration of the same cameras, from the next iteration on; tracks stay.
  virtual void setCameras(const CameraRig& rig) = 0;
};

/// Searches for targets in a volume of interest alone, and reports none outside it.
class VolumeBounded {
public:
  virtual ~VolumeBounded() = default;
  /// From the next iteration on; nothing: anywhere. Where tracks begin is in it from the next
  /// restart on (at once, before the first frame).
  virtual void setVolumeOfInterest(const std::optional<WorldBox>& volume) = 0;
};

/// Uses what it is told of the empty room: images of the scene without targets.
class EmptyRoomKnowing {
public:
  virtual ~EmptyRoomKnowing() = default;
  /// One image per camera (CV_8UC3, in the order of the rig), empty where it is not known. Takes
  /// effect at the next restart; methods for people then need no learning phase.
  virtual void setEmptyRooms(const std::vector<cv::Mat>& images) = 0;
};

/// Can be copied during a run, so that the run can go back.
class Copying {
public:
  virtual ~Copying() = default;
  /// False with one of OpenCV's background models, which cannot be copied.
  virtual bool canBeCopied() const = 0;
  /// A copy that goes on from here with the same bits, and shares nothing that either writes; null
  /// when it cannot be copied.
  virtual std::unique_ptr<Tracker> clone() const = 0;
  /// About how many bytes a copy takes.
  virtual std::size_t memoryBytes() const = 0;
};

/// Represents the position of a track by weighted points.
class ParticleCloud {
public:
  virtual ~ParticleCloud() = default;
  /// At most `limit` particles of a track, evenly picked: rows x y z (meters), with linear weights
  /// that sum to 1 over all particles. Of a person the points of the body; none when absent.
  virtual void particles(std::size_t track, int limit, Eigen::ArrayXXd& positions,
                         Eigen::ArrayXd& weights) const = 0;
};

/// Reports for each camera whether, and if not why, it does not confirm a track.
class CameraExplaining {
public:
  virtual ~CameraExplaining() = default;
  /// After the iterations of a frame, in the order of the rig; empty before there is anything to
  /// explain.
  virtual std::vector<CameraReport> explain(std::size_t track) const = 0;
};

/// Reports the positions that it considered for a track.
class PositionProposing {
public:
  virtual ~PositionProposing() = default;
  /// Those considered at the last iteration.
  virtual std::vector<CandidatePosition> proposals(std::size_t track) const = 0;
};

/// Maps the likelihood of a track over the pixels of every camera.
class LikelihoodMapping {
public:
  virtual ~LikelihoodMapping() = default;
  /// Around the estimate of a track, up to `reach` pixels in each direction; one per camera.
  virtual std::vector<LikelihoodMap> likelihoodMaps(std::size_t track, int reach) const = 0;
};

/// Maps the likelihood of motion over the images of every camera, whoever it is that moves.
class MotionMapping {
public:
  virtual ~MotionMapping() = default;
  /// One per camera: log D of the last frame (Mohedano et al. 2009, equation 8) over the whole
  /// image, which is perhaps smaller than the camera's. An empty area where there is no mask.
  virtual std::vector<LikelihoodMap> motionLikelihoods() const = 0;
};

/// The centers of some particles of a box, in the image: rows x y, pixels from the upper left
/// corner, with linear weights.
struct BoxParticles {
  Eigen::ArrayXXf centers;
  Eigen::ArrayXf weights;
};

/// Tracks bounding boxes, each in the images of one camera, without any calibration.
class BoxFollowing {
public:
  virtual ~BoxFollowing() = default;
  /// Takes what is in the box of an image (CV_8UC3) as what a target is from now on, whatever was
  /// followed before. BadValue names "image" or "box", and nothing has changed.
  virtual Status follow(std::size_t target, const cv::Mat& bgr, const TargetBox& box,
                        std::uint64_t seed) = 0;
  /// At most `limit` particles of a target, evenly picked; none while it is absent.
  virtual BoxParticles boxParticles(std::size_t target, int limit) const = 0;
};

/// Knows the colors of a target as it was given.
class ReferenceColors {
public:
  virtual ~ReferenceColors() = default;
  /// The color histogram (boxHistogram()) of the box from which a target is followed; empty while
  /// it is absent.
  virtual std::vector<double> referenceHistogram(std::size_t target) const = 0;
};

/// Creates tracks of people by itself. Identity N is track N - 1, from its creation on.
class PeopleFinding {
public:
  virtual ~PeopleFinding() = default;
  /// All people who are tracked after the last frame, in the order of their identities.
  virtual const std::vector<PersonEstimate>& people() const = 0;
  /// All people who have been tracked: "person 1", "person 2", ...
  virtual const std::vector<Target>& everybody() const = 0;
  /// The body of a person of people(), empty for any other identity.
  virtual BodyCloud body(int identity) const = 0;
  virtual const std::vector<PeopleCameraState>& cameraStates() const = 0;
  /// The motion mask of a camera (CV_8UC1, 0 or 255), perhaps smaller than its images; empty when
  /// there is none.
  virtual cv::Mat foreground(std::size_t camera) const = 0;
};

/// Lets the user add and remove people.
class PersonPlacing {
public:
  virtual ~PersonPlacing() = default;
  /// Creates a track of a person whose body has its center here (meters, world), whatever the masks
  /// show. Returns the new identity. Effective with the next frame.
  virtual int addPerson(const Eigen::Vector3d& center) = 0;
  /// Removes the track of a person.
  virtual void removePerson(int identity) = 0;
};

} // namespace dewpoint::tracking
