// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/path_filter.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace dewpoint::trajectory {
namespace {

/// What is known of a path before anything is seen: little. Place in m (about the first seen one)
/// and its derivatives, in m/s, m/s², ...
constexpr double kFirstSigmas[kMaxPathOrder] = {10.0, 10.0, 50.0, 500.0, 5000.0};

/// Looks that only begin a path: they determine its derivatives.
constexpr int kBeginning = kMaxPathOrder;

/// Position and derivatives of all axes: x y z vx vy vz ax ay az ... Of any size, because a fixed
/// size for each order takes the compiler five times as long.
struct State {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
};

/// The same matrix for each axis.
Eigen::MatrixXd forAllAxes(const Eigen::MatrixXd& one) {
  const Eigen::Index order = one.rows();
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(3 * order, 3 * order);
  for (Eigen::Index i = 0; i < order; ++i) {
    for (Eigen::Index j = 0; j < order; ++j) {
      all.block<3, 3>(3 * i, 3 * j).diagonal().setConstant(one(i, j));
    }
  }
  return all;
}

constexpr double factorial(int n) {
  return n < 2 ? 1.0 : n * factorial(n - 1);
}

/// Motion in a unit of time of its own, about that between two instants: otherwise powers of a
/// short time would make matrices of numbers of very different size.
class Motion {
public:
  Motion(std::span<const PathPoint> path, const PathModel& model)
      : order_(std::clamp(model.derivativeOrder, 2, kMaxPathOrder)),
        unit_(path.size() > 1
                  ? (path.back().time - path.front().time) / static_cast<double>(path.size() - 1)
                  : 1.0) {
    strength_ = model.spectralDensity * std::pow(unit_, 2 * order_ - 1);
  }

  State first(const Eigen::Vector3d& position) const {
    State state{Eigen::VectorXd::Zero(3 * order_), Eigen::MatrixXd::Zero(3 * order_, 3 * order_)};
    state.mean.head<3>() = position;
    for (Eigen::Index i = 0; i < order_; ++i) {
      const double sigma = kFirstSigmas[i] * std::pow(unit_, i);
      state.covariance.block<3, 3>(3 * i, 3 * i).diagonal().setConstant(sigma * sigma);
    }
    return state;
  }

  Eigen::MatrixXd transition(double seconds) const {
    const double t = seconds / unit_;
    Eigen::MatrixXd one = Eigen::MatrixXd::Zero(order_, order_);
    for (Eigen::Index i = 0; i < order_; ++i) {
      for (Eigen::Index j = i; j < order_; ++j) {
        one(i, j) = std::pow(t, j - i) / factorial(j - i);
      }
    }
    return forAllAxes(one);
  }

  void predict(State& state, double seconds) const {
    const auto step = transition(seconds);
    state.mean = step * state.mean;
    state.covariance = step * state.covariance * step.transpose() + noise(seconds / unit_);
  }

private:
  /// What white noise in the highest derivative adds: the integral over s from 0 to t of strength
  /// s^(a+b) / (a! b!), where a and b are how often it is integrated.
  Eigen::MatrixXd noise(double t) const {
    Eigen::MatrixXd one(order_, order_);
    for (Eigen::Index i = 0; i < order_; ++i) {
      for (Eigen::Index j = 0; j < order_; ++j) {
        const Eigen::Index a = order_ - 1 - i;
        const Eigen::Index b = order_ - 1 - j;
        one(i, j) =
            strength_ * std::pow(t, a + b + 1) / ((a + b + 1) * factorial(a) * factorial(b));
      }
    }
    return forAllAxes(one);
  }

  Eigen::Index order_;
  double unit_; ///< seconds
  double strength_;
};

/// How a seen position compares with the prediction.
struct Innovation {
  double squaredDistance = 0.0;
  double logDeterminant = 0.0; ///< of its covariance
};

/// The update of a Kalman filter in Joseph's form, which keeps the covariance positive. Beyond the
/// gate the state stays as it is.
Innovation update(State& state, const PositionMeasurement& seen, double noiseFactor, double gate) {
  const Eigen::Matrix3d noise = noiseFactor * seen.covariance;
  const Eigen::Matrix3d spread = state.covariance.topLeftCorner<3, 3>() + noise;
  const Eigen::LLT<Eigen::Matrix3d> factor(spread);
  const Eigen::Vector3d off = seen.position - state.mean.head<3>();
  Innovation result;
  result.squaredDistance = off.dot(factor.solve(off));
  result.logDeterminant = 2.0 * factor.matrixLLT().diagonal().array().log().sum();
  if (result.squaredDistance > gate) {
    return result;
  }
  const Eigen::Matrix<double, Eigen::Dynamic, 3> gain =
      factor.solve(state.covariance.topRows<3>()).transpose();
  state.mean += gain * off;
  const Eigen::Index size = state.mean.size();
  Eigen::MatrixXd remaining = Eigen::MatrixXd::Identity(size, size);
  remaining.leftCols<3>() -= gain;
  state.covariance =
      remaining * state.covariance * remaining.transpose() + gain * noise * gain.transpose();
  state.covariance = 0.5 * (state.covariance + state.covariance.transpose().eval());
  return result;
}

constexpr double kNoGate = std::numeric_limits<double>::infinity();

/// Calls `visit(index, innovation, begins)` for each seen position until it returns false; those
/// that only begin the path are told as such.
template <class Visit>
void forward(std::span<const PathPoint> path, const PathModel& model, double gate, Visit visit) {
  const auto found =
      std::ranges::find_if(path, [](const auto& point) { return point.measurement.has_value(); });
  if (found == path.end()) {
    return;
  }
  const Motion motion(path, model);
  State state = motion.first(found->measurement->position);
  double time = found->time;
  int measurements = 0;
  for (auto k = static_cast<std::size_t>(found - path.begin()); k < path.size(); ++k) {
    if (!path[k].measurement) {
      continue;
    }
    motion.predict(state, path[k].time - time);
    time = path[k].time;
    const bool begins = measurements++ < kBeginning;
    const Innovation innovation =
        update(state, *path[k].measurement, model.noiseFactor, begins ? kNoGate : gate);
    if (!visit(k, innovation, begins)) {
      return;
    }
  }
}

/// Asks at every thousandth instant, which is a few milliseconds.
bool wanted(std::size_t k, const std::function<bool()>& shouldContinue) {
  return k % 1000 != 0 || !shouldContinue || shouldContinue();
}

} // namespace

double pathLogLikelihood(std::span<const PathPoint> path, const PathModel& model, double gate) {
  double sum = 0.0;
  const auto add = [&](std::size_t, const Innovation& innovation, bool begins) {
    if (!begins) {
      sum -= 0.5 * (innovation.logDeterminant + std::min(innovation.squaredDistance, gate) +
                    3.0 * std::log(2.0 * std::numbers::pi));
    }
    return true;
  };
  forward(path, model, gate, add);
  return sum;
}

void forEachNormalizedInnovation(std::span<const PathPoint> path, const PathModel& model,
                                 double gate,
                                 const std::function<bool(std::size_t, double)>& onInnovation) {
  const auto visit = [&](std::size_t k, const Innovation& innovation, bool begins) {
    return onInnovation(k, begins ? 0.0 : innovation.squaredDistance);
  };
  forward(path, model, gate, visit);
}

std::vector<double> normalizedInnovations(std::span<const PathPoint> path, const PathModel& model,
                                          double gate) {
  std::vector<double> result(path.size());
  forEachNormalizedInnovation(path, model, gate, [&](std::size_t k, double surprise) {
    result[k] = surprise;
    return true;
  });
  return result;
}

std::vector<PathEstimate> smoothPath(std::span<const PathPoint> path, const PathModel& model,
                                     const std::function<bool()>& shouldContinue) {
  const std::size_t count = path.size();
  const Motion motion(path, model);
  std::vector<State> filtered(count);
  std::vector<State> predicted(count);
  State state = motion.first(path.front().measurement->position);
  for (std::size_t k = 0; k < count && wanted(k, shouldContinue); ++k) {
    if (k > 0) {
      motion.predict(state, path[k].time - path[k - 1].time);
    }
    predicted[k] = state;
    if (path[k].measurement) {
      update(state, *path[k].measurement, model.noiseFactor, kNoGate);
    }
    filtered[k] = state;
  }
  if (filtered.back().mean.size() == 0) {
    return std::vector<PathEstimate>(count); // stopped on the way
  }
  // Särkkä (2013), theorem 8.2.
  for (std::size_t k = count - 1; k-- > 0 && wanted(k, shouldContinue);) {
    const auto step = motion.transition(path[k + 1].time - path[k].time);
    State& here = filtered[k];
    const Eigen::MatrixXd gain =
        predicted[k + 1].covariance.ldlt().solve(step * here.covariance).transpose();
    here.mean += gain * (filtered[k + 1].mean - predicted[k + 1].mean);
    here.covariance +=
        gain * (filtered[k + 1].covariance - predicted[k + 1].covariance) * gain.transpose();
    here.covariance = 0.5 * (here.covariance + here.covariance.transpose().eval());
  }
  std::vector<PathEstimate> result(count);
  for (std::size_t k = 0; k < count; ++k) {
    result[k] = {filtered[k].mean.head<3>(), filtered[k].covariance.topLeftCorner<3, 3>()};
  }
  return result;
}

std::vector<Eigen::Matrix3d> sharedErrorCovariances(std::span<const PathPoint> path,
                                                    const PathModel& model,
                                                    const std::function<bool()>& shouldContinue) {
  std::vector<Eigen::Matrix3d> effects(path.size(), Eigen::Matrix3d::Zero());
  std::vector<PathPoint> errors(path.begin(), path.end());
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t k = 0; k < path.size(); ++k) {
      if (path[k].measurement) {
        // The symmetric root changes little where the covariance does.
        errors[k].measurement->position =
            Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(path[k].measurement->covariance)
                .operatorSqrt()
                .col(axis);
      }
    }
    // The smoother is linear: smoothed errors are the errors of what is smoothed.
    const auto after = smoothPath(errors, model, shouldContinue);
    for (std::size_t k = 0; k < path.size(); ++k) {
      effects[k] += after[k].position * after[k].position.transpose();
    }
  }
  return effects;
}

} // namespace dewpoint::trajectory
