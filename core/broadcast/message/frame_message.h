// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/world_box.h"
#include "core/project/output_settings.h"
#include "core/session/snapshot/snapshot.h"
#include "core/trajectory/trajectory.h"

#include <Eigen/Core>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::broadcast {

/// Axes and unit of all data that is sent.
struct OutputCoordinates {
  OutputAxes axes = OutputAxes::ZUp;
  OutputUnit unit = OutputUnit::Meter;

  /// Returns the matrix that converts a position (meters, world frame) to output coordinates.
  Eigen::Matrix3d outputFromWorld() const;
  bool operator==(const OutputCoordinates&) const = default;
};

/// Position and direction of one camera, in output coordinates (OutputCoordinates).
struct CameraMessage {
  std::string name;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ(); ///< unit vector along the optical axis

  bool operator==(const CameraMessage&) const = default;
};

/// Data that stays the same from frame to frame. It is sent once, and again after a change.
struct RigMessage {
  OutputCoordinates coordinates;
  std::vector<CameraMessage> cameras; ///< cameras, in project order
  /// Volume in output coordinates: the project's volume of interest, or else the volume that at
  /// least two cameras see. TUIO output maps it to the range 0 to 1.
  WorldBox volume{Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()};

  bool operator==(const RigMessage&) const = default;
};
using RigMessagePtr = std::shared_ptr<const RigMessage>;

/// One target in one frame. Lengths are in output coordinates, times in seconds.
struct TargetMessage {
  int id = 0;       ///< number of the target, from 1; the id of a person is not reused during a run
  std::string name; ///< name in the project
  std::string state; ///< tracking state as one word, such as "searching" (stateWord())
  /// Position; empty if the images of this frame do not confirm the position.
  std::optional<Eigen::Vector3d> position;
  /// Covariance of the position. Meaningful only if there is a position.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  /// Velocity: slope of a line through the latest positions, length per second. Empty if fewer than
  /// two positions are known.
  std::optional<Eigen::Vector3d> velocity;
  /// Acceleration: change of the velocity since the previous frame, length per second squared; zero
  /// if unknown.
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
  double existenceProbability = 0.0; ///< existence probability, 0 to 1
  std::vector<int>
      seeingCameras; ///< cameras that see the target, as indices in RigMessage::cameras
};

/// All targets in one frame, as sent to other programs.
struct FrameMessage {
  std::int64_t frame = 0;          ///< number of the frame in the run
  std::int64_t sequenceNumber = 0; ///< number of this message since the outputs were opened, from 1
  double time = 0.0;               ///< capture time, seconds since the start of the run
  RigMessagePtr rig;               ///< rig of this frame; never null
  std::vector<TargetMessage> targets;
};

/// Returns the state of a target as one word: held (confirmed by the cameras), ambiguous,
/// searching, lost, hidden, or gone (no longer present). The same words are used in reasons.csv.
const char* stateWord(TrackingState state);

/// Returns the message that describes the rig of a snapshot, converted to `coordinates`. The
/// snapshot must have a rig. `volume` is the project's volume of interest (meters, world frame), if
/// there is one.
RigMessage rigMessageOf(const TrackSnapshot& snapshot, const OutputCoordinates& coordinates,
                        const std::optional<WorldBox>& volume);

/// Computes velocities and accelerations from the positions in the latest frames. Every frame must
/// be added, even if it is not sent.
class RecentPositions {
public:
  /// Adds the target positions in a snapshot. Forgets all earlier positions if the run was
  /// restarted or jumped back.
  void add(const TrackSnapshot& snapshot);
  /// Returns the velocity of a target (m/s, world frame) in the latest frame, or nothing if it is
  /// unknown.
  std::optional<Eigen::Vector3d> velocity(const std::string& target) const;
  /// Returns the acceleration of a target (m/s², world frame): the change of its velocity since the
  /// previous frame. Zero if it is unknown.
  Eigen::Vector3d acceleration(const std::string& target) const;

  /// Number of positions from which a velocity is computed. The velocity of an accelerating target
  /// lags by one and a half frames.
  static constexpr std::size_t kPositionsPerVelocity = 4;

private:
  struct Trail {
    std::vector<TrajectorySample> samples; ///< ascending, the newest last
    std::optional<Eigen::Vector3d> velocity;
    Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
  };
  std::map<std::string, Trail> trails_;
  std::int64_t frame_ = -1;
  std::uint64_t seed_ = 0;
};

/// Returns the message about the frame in a snapshot. The snapshot must have a rig and frames, and
/// must already have been added to `recent`, which provides the velocities. People who have left
/// are omitted. The caller must set FrameMessage::sequenceNumber, which is 0.
FrameMessage frameMessageOf(const TrackSnapshot& snapshot, const RecentPositions& recent,
                            const RigMessagePtr& rig);

} // namespace dewpoint::broadcast
