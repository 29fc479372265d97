// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/thread_team.h"
#include "core/capture/frame.h"
#include "core/filter/gaussian.h"
#include "core/filter/isotropic_motion.h"
#include "core/filter/multinomial_resampling.h"
#include "core/filter/particle_filter.h"
#include "core/geometry/world_box.h"
#include "core/tracking/barrera/bounded_observation.h"
#include "core/tracking/parameters.h"
#include "core/tracking/track_estimate.h"

#include <optional>

namespace dewpoint::tracking {

/// Common part of the particle filters of Barrera et al.: an isotropic random walk, multinomial
/// resampling at every iteration, and a start volume. Derived methods provide the observation
/// model.
class RandomWalkTracker {
public:
  /// Sets the parameters. The start volume takes effect at the next restart, or immediately if no
  /// iteration has run since the last restart. All other parameters take effect at the next
  /// iteration.
  void configure(const ParameterValues& parameters);
  /// Limits the positions of the target from the next iteration on. Without a value, positions are
  /// unlimited. If the estimate lies outside the volume, the particles restart inside the volume.
  void setVolumeOfInterest(const std::optional<WorldBox>& volume);
  /// Discards all particles and estimates, and starts from scratch with this random seed.
  void restart(std::uint64_t seed);
  int iterationsPerFrame() const;
  void beginFrame(FrameSetPtr frames);
  /// Draws the particles again from a Gaussian given by the user (world frame, m, m²). Returns the
  /// new estimate.
  SphereEstimate correct(const Gaussian3& position);
  /// Copies an even selection of at most `limit` particles: rows of x, y, z (meters), with linear
  /// weights that sum to 1 over all particles.
  void copyParticles(int limit, Eigen::ArrayXXd& positions, Eigen::ArrayXd& weights) const;
  /// Returns the approximate size of a copy of this tracker in bytes.
  std::size_t memoryBytes() const;

protected:
  /// Creates a tracker. `parameters` must declare particles, motion_sigma, iterations_per_frame and
  /// the start volume.
  explicit RandomWalkTracker(const ParameterValues& parameters);

  /// Runs one iteration and returns the estimate. SphereEstimate::cameras and the values derived
  /// from it are not filled in yet.
  template <ObservationModel O> SphereEstimate step(const O& observation, ThreadTeam& team);
  /// Returns whether a position (world frame, meters) lies in the volume of interest, if there is
  /// one.
  bool isInVolumeOfInterest(const Eigen::Vector3d& position) const {
    return !volume_ || volume_->contains(position);
  }
  /// Returns the image of a camera in the current frame, or an empty image if the camera has none.
  cv::Mat imageOf(std::size_t camera) const;

  ParameterValues parameters_;
  FrameSetPtr frames_;
  SphereEstimate estimate_;

private:
  Eigen::ArrayXXd drawStartParticles() const;

  std::optional<WorldBox> volume_; ///< volume of interest
  ParticleFilter filter_;
  RandomKey key_;
  bool started_ = false; ///< an iteration has run since the last restart
};

template <ObservationModel O>
SphereEstimate RandomWalkTracker::step(const O& observation, ThreadTeam& team) {
  const auto particleCount = static_cast<Eigen::Index>(parameters_.at("particles"));
  const MotionProposal<IsotropicMotion> proposal{{parameters_.at("motion_sigma")}};
  const MultinomialResampling resampling;
  if (filter_.nextParticleCount() != particleCount) {
    filter_.resize(resampling, particleCount, key_, team);
  }
  const StateEstimate state =
      volume_ ? filter_.iterate(proposal, BoundedObservation<O>{observation, *volume_}, resampling,
                                particleCount, key_, team)
              : filter_.iterate(proposal, observation, resampling, particleCount, key_, team);
  ++key_.iteration;
  started_ = true;

  SphereEstimate result;
  result.mean = state.mean;
  result.best = filter_.states().row(state.bestIndex).transpose();
  result.covariance = state.covariance;
  result.effectiveSampleSize = state.effectiveSampleSize;
  result.particleCount = static_cast<int>(particleCount);
  result.isDegenerate = state.isDegenerate;
  return result;
}

} // namespace dewpoint::tracking
