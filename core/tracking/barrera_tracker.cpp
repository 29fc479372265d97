// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/barrera_tracker.h"

#include "core/filter/isotropic_motion.h"
#include "core/filter/multinomial_resampling.h"
#include "core/tracking/start_parameters.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint {

BarreraTracker::BarreraTracker(const ParameterValues& parameters, const CameraRig& rig,
                               const Target& target)
    : parameters_(parameters), classifier_(target.color), observation_(rig, classifier_) {
  for (const Camera& camera : rig) {
    projectors_.emplace_back(camera);
  }
  filter_.start(drawStart());
}

void BarreraTracker::configure(const ParameterValues& parameters) {
  parameters_ = parameters;
  if (!started_) {
    filter_.start(drawStart());
  }
}

void BarreraTracker::setTarget(const Target& target) {
  classifier_ = ColorClassifier(target.color);
  observation_.setClassifier(classifier_);
}

void BarreraTracker::setCameras(const CameraRig& rig) {
  projectors_ = std::vector<Projector>(rig.begin(), rig.end());
  observation_ = ColorWindow(rig, classifier_);
  showImages();
}

void BarreraTracker::restart(std::uint64_t seed) {
  key_.seed = seed;
  key_.iteration = 0;
  started_ = false;
  estimate_ = {};
  filter_.start(drawStart());
}

int BarreraTracker::iterationsPerFrame() const {
  return static_cast<int>(parameters_.at("iterations_per_frame"));
}

void BarreraTracker::beginFrame(FrameSetPtr frames) {
  key_.iteration = 0;
  key_.frame = frames ? static_cast<std::uint32_t>(frames->index) : 0;
  frames_ = std::move(frames);
  showImages();
}

void BarreraTracker::showImages() {
  for (std::size_t camera = 0; camera < observation_.cameraCount(); ++camera) {
    observation_.setImage(camera, imageOf(camera));
  }
}

cv::Mat BarreraTracker::imageOf(std::size_t camera) const {
  const bool present =
      frames_ && camera < frames_->frames.size() && frames_->frames[camera] != nullptr;
  return present ? frames_->frames[camera]->image : cv::Mat();
}

TargetEstimate BarreraTracker::iterate(ThreadTeam& team) {
  const auto particleCount = static_cast<Eigen::Index>(parameters_.at("particles"));
  const MotionProposal<IsotropicMotion> proposal{{parameters_.at("motion_sigma")}};
  const MultinomialResampling resampling;
  if (filter_.nextCount() != particleCount) {
    filter_.resize(resampling, particleCount, key_, team);
  }
  observation_.prepare(particleCount * iterationsPerFrame());
  const StateEstimate state =
      filter_.iterate(proposal, observation_, resampling, particleCount, key_, team);
  ++key_.iteration;
  started_ = true;

  TargetEstimate result;
  result.mean = state.mean;
  result.best = filter_.states().row(state.bestIndex).transpose();
  result.covariance = state.covariance;
  result.effectiveSampleSize = state.effectiveSampleSize;
  result.particleCount = static_cast<int>(particleCount);
  result.cameras = evidence(result.mean);
  result.camerasSeeing = static_cast<int>(std::ranges::count_if(
      result.cameras, [](const CameraEvidence& camera) { return camera.visible > 0.0; }));
  const int needed = std::clamp(static_cast<int>(observation_.cameraCount()), 1, 2);
  result.valid = result.camerasSeeing >= needed;
  result.existence = result.valid ? 1.0 : 0.0; // the paper's filter has no opinion of its own
  result.degenerate = state.degenerate;
  estimate_ = result;
  return result;
}

void BarreraTracker::particles(int limit, Eigen::ArrayXXd& positions,
                               Eigen::ArrayXd& weights) const {
  const Eigen::ArrayXXd& states = filter_.states();
  const Eigen::Index shown = std::clamp<Eigen::Index>(limit, 0, states.rows());
  positions.resize(shown, 3);
  weights.resize(shown);
  for (Eigen::Index i = 0; i < shown; ++i) {
    const Eigen::Index picked = i * states.rows() / shown;
    positions.row(i) = states.row(picked);
    weights[i] = filter_.weights()[picked];
  }
}

Eigen::ArrayXXd BarreraTracker::drawStart() const {
  const StartVolume volume = startVolume(parameters_);
  const RandomStream stream(key_.seed, 0, 0, RandomPurpose::Start);
  Eigen::ArrayXXd states(static_cast<Eigen::Index>(parameters_.at("particles")), 3);
  for (Eigen::Index i = 0; i < states.rows(); ++i) {
    const auto unit = stream.uniform3(static_cast<std::uint32_t>(i));
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      states(i, axis) = volume.center[axis] +
                        volume.half[axis] * (2.0 * unit[static_cast<std::size_t>(axis)] - 1.0);
    }
  }
  return states;
}

std::vector<CameraEvidence> BarreraTracker::evidence(const Eigen::Vector3d& point) const {
  std::vector<CameraEvidence> cameras(observation_.cameraCount());
  for (std::size_t k = 0; k < cameras.size(); ++k) {
    if (const auto count = observation_.matchCount(k, point)) {
      const int counted = std::max(*count, 1);
      cameras[k].looked = true;
      cameras[k].visible = static_cast<double>(*count) / WindowCounts::kPixels;
      cameras[k].logLikelihood = std::log(static_cast<double>(counted) / WindowCounts::kPixels);
      cameras[k].existence = probabilityFrom(std::log(static_cast<double>(counted)));
    }
  }
  return cameras;
}

} // namespace dewpoint
