// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace dewpoint::experiment::scenarios {

/// Free fall, m/s² (standard gravity to two places).
inline const Eigen::Vector3d kGravity{0.0, 0.0, -9.81};

/// A path of pieces with a constant acceleration each, appended one after the other from time 0 on:
/// what rests, falls, is thrown or bounces. World frame; meters, seconds.
class PiecewisePath {
public:
  explicit PiecewisePath(const Eigen::Vector3d& start) : position_(start) {}

  /// Goes on with this acceleration, m/s².
  void accelerate(const Eigen::Vector3d& acceleration, double seconds);
  /// Stops at once.
  void rest(double seconds);
  /// Goes on with another velocity, m/s: a push or a bounce.
  void setVelocity(const Eigen::Vector3d& velocity) { velocity_ = velocity; }

  /// Where and how fast it is at its end so far, and when that is.
  const Eigen::Vector3d& position() const { return position_; }
  const Eigen::Vector3d& velocity() const { return velocity_; }
  double end() const { return end_; }

  /// The position at a time; before the start that of the start, after the end that of the end.
  Eigen::Vector3d operator()(double time) const;

private:
  struct Piece {
    double begin = 0.0;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
    Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
  };

  std::vector<Piece> pieces_;
  Eigen::Vector3d position_;
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();
  double end_ = 0.0;
};

/// From rest to rest at `to`: a hand speeds the ball up, it flies freely for `flight` seconds, and
/// a hand slows it down.
void addThrow(PiecewisePath& path, const Eigen::Vector3d& to, double flight);

/// From rest to rest at `to` along a straight line: speeds up for half of the time.
void addCarry(PiecewisePath& path, const Eigen::Vector3d& to, double seconds);

/// How a ball bounces on a level floor.
struct Bounce {
  double floor = 0.0;       ///< height of the ball's center in contact, meters
  double restitution = 0.7; ///< of the speed across the floor, 0 to 1
  double slide = 0.9;       ///< of the speed along the floor
};

/// Falls and bounces until it would rise by less than a millimeter; then it lies still.
void addBounces(PiecewisePath& path, const Bounce& bounce);

} // namespace dewpoint::experiment::scenarios
