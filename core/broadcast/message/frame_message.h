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

/// Coordinate system and unit of everything that is sent.
struct OutputCoordinates {
  OutputAxes axes = OutputAxes::ZUp;
  OutputUnit unit = OutputUnit::Meter;

  /// Returns the matrix that maps a position (m, world frame) to one that is sent.
  Eigen::Matrix3d fromWorld() const;
  bool operator==(const OutputCoordinates&) const = default;
};

/// Position and direction of one camera, in output coordinates.
struct CameraMessage {
  std::string name;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ(); ///< unit vector along the optical axis

  bool operator==(const CameraMessage&) const = default;
};

/// Everything that stays the same from frame to frame: sent once, and again after a change.
struct RigMessage {
  OutputCoordinates coordinates;
  std::vector<CameraMessage> cameras; ///< in the order of the project
  /// Volume that TUIO maps to 0 to 1, in output coordinates: the project's volume of interest, or
  /// the volume that at least two cameras see.
  WorldBox volume{Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()};

  bool operator==(const RigMessage&) const = default;
};
using RigMessagePtr = std::shared_ptr<const RigMessage>;

/// One target in one frame, in output coordinates; times in seconds.
struct TargetMessage {
  int id = 0;        ///< from 1 on; that of a person is never used again in a run
  std::string name;  ///< name in the project
  std::string state; ///< stateWord()
  /// Position; nothing unless the cameras confirm it in this frame.
  std::optional<Eigen::Vector3d> position;
  /// Covariance of the position; only meaningful with a position.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  /// Slope of a line through the last positions, per second; nothing until there are two.
  std::optional<Eigen::Vector3d> velocity;
  /// Change of the velocity since the frame before, per second squared; zero if unknown.
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
  double existence = 0.0;   ///< existence probability, 0 to 1
  std::vector<int> cameras; ///< cameras that see the target, as indices in RigMessage::cameras
};

/// All targets in one frame: what leaves the program while it runs.
struct FrameMessage {
  std::int64_t frame = 0;    ///< number of the frame in the run
  std::int64_t sequence = 0; ///< counts the messages since the start of the program, from 1 on
  double time = 0.0;         ///< capture time, seconds since the start of the run
  RigMessagePtr rig;         ///< never null
  std::vector<TargetMessage> targets;
};

/// Returns the state of a target as one word, as in reasons.csv: held, ambiguous, searching, lost,
/// hidden, or gone.
const char* stateWord(HoldState state);

/// Returns the rig of a snapshot, which must have one. `volume` is the project's volume of interest
/// in meters, world frame, if there is one.
RigMessage rigMessageOf(const TrackSnapshot& snapshot, const OutputCoordinates& coordinates,
                        const std::optional<WorldBox>& volume);

/// Positions of the last few frames, from which velocities are computed. It has to be given every
/// frame, also those that are not sent.
class RecentPositions {
public:
  /// Adds a snapshot. Starts over after a restart or a jump back.
  void add(const TrackSnapshot& snapshot);
  /// Returns the velocity of a target (m/s, world frame) in the frame added last.
  std::optional<Eigen::Vector3d> velocity(const std::string& target) const;
  /// Returns the change of this velocity since the frame before (m/s²); zero if unknown.
  Eigen::Vector3d acceleration(const std::string& target) const;

  /// Number of positions that a velocity is computed from. Velocities of accelerating targets lag
  /// by one and a half frames; noise of the positions is reduced by half.
  static constexpr std::size_t kPositions = 4;

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

/// Returns what is sent of a snapshot, whose rig and frames must exist. Persons who have left are
/// not in it. `recent` already has this
/// snapshot. `sequence` is left 0.
FrameMessage frameMessageOf(const TrackSnapshot& snapshot, const RecentPositions& recent,
                            const RigMessagePtr& rig);

} // namespace dewpoint::broadcast
