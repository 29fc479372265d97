// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/thread_team.h"
#include "core/capture/frame.h"
#include "core/geometry/camera.h"
#include "core/tracking/parameters.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::tracking {

/// What is believed about one person after a frame. World frame, metres.
struct PersonEstimate {
  int identity = 0;                                     ///< from 1 on, never given twice in a run
  Eigen::Vector3d position = Eigen::Vector3d::Zero();   ///< mean of the occupied volume
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< of the occupied volume, m²
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();   ///< m/s
  double effectiveSampleSize = 0.0;
  int particleCount = 0;
  int camerasSeeing = 0;    ///< cameras with foreground of this person
  double existence = 1.0;   ///< falls from 1 to 0 while no camera sees the person
  double age = 0.0;         ///< seconds since the birth
  bool interacting = false; ///< near another person: what cannot be told apart is not learned
  double height = 0.0;      ///< metres; 0: the method does not estimate it
  /// Hue and saturation of the person, in [0, 1], if the method has them.
  std::optional<Eigen::Vector2d> color;
};

/// The 3D points that stand for where a person's body is: rows x y z, metres, with linear weights
/// that sum to 1.
struct BodyCloud {
  Eigen::ArrayXXd points;
  Eigen::ArrayXd weights;
};

/// What is known about one camera's background.
struct PeopleCameraState {
  double learned = 0.0;         ///< 0 to 1: how much of the learning phase is over
  double foregroundShare = 0.0; ///< of the image, 0 to 1
  bool usable = false;          ///< had an image, is learned, and is not all foreground
};

/// A method that tracks people who enter, meet and leave, so that their number changes while it
/// runs. A run uses it as a MultiTracker through PeopleTargets. Call `step` once per frame set. Not
/// thread safe; the same seed gives the same bits for any size of the ThreadTeam.
class PeopleTracker {
public:
  virtual ~PeopleTracker() = default;
  /// From the next frame on; the choice of background model from the next restart on.
  virtual void configure(const ParameterValues& parameters) = 0;
  /// Another calibration of the same cameras, from the next frame on; beliefs stay.
  virtual void setCameras(const CameraRig& rig) = 0;
  /// What the cameras show when nobody is there (CV_8UC3, in the order of the rig; empty where it
  /// is not known); from the next restart on. With it there is no learning phase.
  virtual void setEmptyRooms(const std::vector<cv::Mat>& rooms) = 0;
  /// Forgets everything but the empty rooms and starts anew.
  virtual void restart(std::uint64_t seed) = 0;
  virtual void step(const FrameSetPtr& frames, ThreadTeam& team) = 0;

  /// Everybody who is there after the last frame, in the order of their identities.
  virtual const std::vector<PersonEstimate>& people() const = 0;
  /// The body of a person of people(), empty for any other identity.
  virtual BodyCloud body(int identity) const = 0;
  virtual const std::vector<PeopleCameraState>& cameraStates() const = 0;
  /// The motion mask of a camera (CV_8UC1, 0 or 255), perhaps smaller than its images; empty when
  /// there is none.
  virtual cv::Mat foreground(std::size_t camera) const = 0;

  /// Somebody stands here (metres, world; the middle of the body), whatever the masks say. Returns
  /// the new identity. Effective with the next frame.
  virtual int addPerson(const Eigen::Vector3d& middle) = 0;
  /// Forgets a person.
  virtual void removePerson(int identity) = 0;

  /// A copy that goes on from here with the same bits, and shares nothing that either writes; null
  /// when it cannot be copied: with one of OpenCV's background models.
  virtual std::unique_ptr<PeopleTracker> clone() const { return nullptr; }
  virtual bool canBeCopied() const { return false; }
  /// About how many bytes a copy takes.
  virtual std::size_t memoryBytes() const { return 0; }
};

/// How a person is called in files and views: "person 3".
std::string personName(int identity);
/// The identity in such a name; nothing for any other name.
std::optional<int> personIdentity(std::string_view name);

/// Names of the methods that track people, the default first: "people", "mohedano-msc",
/// "mohedano-ms".
std::vector<std::string> peopleMethodNames();
/// One sentence: what the method is for; empty for an unknown method.
std::string_view peopleMethodSentence(std::string_view method);
/// Declarations of one method's parameters; empty for an unknown method. Lives for ever.
std::span<const ParameterDeclaration> peopleMethodParameters(std::string_view method);

/// A tracker of the named method; NotFound for an unknown method, MissingKey when `parameters` are
/// not the method's.
Result<std::unique_ptr<PeopleTracker>> makePeopleTracker(const std::string& method,
                                                         const ParameterValues& parameters,
                                                         const CameraRig& rig);

} // namespace dewpoint::tracking
