// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace dewpoint::experiment::scenarios {

/// Gravitational acceleration, m/s² (standard gravity to two decimals).
inline const Eigen::Vector3d kGravity{0.0, 0.0, -9.81};

/// Path made of pieces with constant acceleration, appended from time 0 on. It describes a body
/// that rests, falls, is thrown or bounces. World frame; meters, seconds.
class PiecewisePath {
public:
  explicit PiecewisePath(const Eigen::Vector3d& start) : position_(start) {}

  /// Appends a piece of `seconds` with a constant acceleration (m/s²).
  void accelerate(const Eigen::Vector3d& acceleration, double seconds);
  /// Appends a piece of `seconds` at rest. The body stops immediately.
  void rest(double seconds);
  /// Sets the velocity (m/s) at the current end of the path, as after a push or a bounce.
  void setVelocity(const Eigen::Vector3d& velocity) { velocity_ = velocity; }

  /// Return the position, the velocity and the time at the current end of the path.
  const Eigen::Vector3d& position() const { return position_; }
  const Eigen::Vector3d& velocity() const { return velocity_; }
  double endTime() const { return end_; }

  /// Returns the position at a time. Before the start, this is the first position; after the end,
  /// it is the last position.
  Eigen::Vector3d operator()(double time) const;

private:
  struct Piece {
    double beginTime = 0.0;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
    Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
  };

  std::vector<Piece> pieces_;
  Eigen::Vector3d position_;
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();
  double end_ = 0.0;
};

/// Appends a throw that begins at rest and ends at rest at `to`. A hand accelerates the ball, the
/// ball flies freely for `flight` seconds, and a hand slows it down.
void addThrow(PiecewisePath& path, const Eigen::Vector3d& to, double flight);

/// Appends a movement along a straight line that begins at rest and ends at rest at `to`. The body
/// accelerates during the first half of the `seconds`, and slows down during the second half.
void addCarry(PiecewisePath& path, const Eigen::Vector3d& to, double seconds);

/// Properties of a ball that bounces on a level floor.
struct Bounce {
  double contactHeight =
      0.0; ///< height of the ball's center when the ball touches the floor, meters
  double restitution =
      0.7; ///< fraction of the speed perpendicular to the floor that is kept, 0 to 1
  double slidingRestitution = 0.9; ///< fraction of the speed along the floor that is kept
};

/// Appends a fall with bounces, which ends when the next bounce would be lower than a millimeter.
/// The ball then lies still.
void addBounces(PiecewisePath& path, const Bounce& bounce);

} // namespace dewpoint::experiment::scenarios
