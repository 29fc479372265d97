// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/barrera/barrera_tracker.h"

#include "core/tracking/barrera/barrera_diagnostics.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::tracking {

BarreraTracker::BarreraTracker(const ParameterValues& parameters, const CameraRig& rig,
                               const Target& target)
    : RandomWalkTracker(parameters), projectors_(rig.begin(), rig.end()),
      classifier_(target.colors()), observation_(rig, classifier_) {}

void BarreraTracker::setTarget(const Target& target) {
  classifier_ = ColorClassifier(target.colors());
  observation_.setClassifier(classifier_);
}

void BarreraTracker::setCameras(const CameraRig& rig) {
  projectors_ = std::vector<Projector>(rig.begin(), rig.end());
  observation_ = ColorWindow(rig, classifier_);
  passImages();
}

void BarreraTracker::beginFrame(FrameSetPtr frames) {
  RandomWalkTracker::beginFrame(std::move(frames));
  passImages();
}

void BarreraTracker::passImages() {
  for (std::size_t camera = 0; camera < observation_.cameraCount(); ++camera) {
    observation_.setImage(camera, imageOf(camera));
  }
}

SphereEstimate BarreraTracker::iterate(ThreadTeam& team) {
  const auto particleCount = static_cast<Eigen::Index>(parameters_.at("particles"));
  observation_.prepare(particleCount * iterationsPerFrame());
  SphereEstimate result = step(observation_, team);
  addEvidence(result);
  const int needed = std::clamp(static_cast<int>(observation_.cameraCount()), 1, 2);
  result.isValid = result.seeingCameraCount >= needed && isInVolumeOfInterest(result.mean);
  result.existenceProbability =
      result.isValid ? 1.0 : 0.0; // the paper's filter has no existence probability
  estimate_ = result;
  return result;
}

SphereEstimate BarreraTracker::correct(const Gaussian3& position) {
  RandomWalkTracker::correct(position);
  addEvidence(estimate_);
  return estimate_;
}

void BarreraTracker::addEvidence(SphereEstimate& estimate) const {
  estimate.cameras = evidence(estimate.mean);
  estimate.seeingCameraCount = static_cast<int>(std::ranges::count_if(
      estimate.cameras, [](const CameraEvidence& camera) { return camera.visibleShare > 0.0; }));
}

std::vector<CameraEvidence> BarreraTracker::evidence(const Eigen::Vector3d& point) const {
  std::vector<CameraEvidence> cameras(observation_.cameraCount());
  for (std::size_t k = 0; k < cameras.size(); ++k) {
    if (const auto count = observation_.matchCount(k, point)) {
      const int counted = std::max(*count, 1);
      cameras[k].isInView = true;
      cameras[k].visibleShare = static_cast<double>(*count) / WindowCounts::kWindowPixelCount;
      cameras[k].logLikelihood =
          std::log(static_cast<double>(counted) / WindowCounts::kWindowPixelCount);
      cameras[k].existenceProbability =
          probabilityFromLogOdds(std::log(static_cast<double>(counted)));
    }
  }
  return cameras;
}

std::size_t BarreraTracker::memoryBytes() const {
  // With many particles also the counts over the whole images.
  std::size_t bytes = RandomWalkTracker::memoryBytes();
  for (std::size_t camera = 0; camera < observation_.cameraCount(); ++camera) {
    bytes += imageOf(camera).total();
  }
  return bytes;
}

std::vector<CameraReport> BarreraTracker::cameraReports() const {
  std::vector<CameraReport> reports;
  for (std::size_t camera = 0; camera < observation_.cameraCount(); ++camera) {
    reports.push_back(
        reportByColor(imageOf(camera), classifier_, projectors_[camera], estimate_, camera));
  }
  return reports;
}

std::vector<LikelihoodMap> BarreraTracker::likelihoodMaps(int reach) const {
  std::vector<LikelihoodMap> maps;
  for (std::size_t camera = 0; camera < observation_.cameraCount(); ++camera) {
    maps.push_back(windowLikelihoodMap(imageOf(camera), classifier_, projectors_[camera],
                                       estimate_.mean, reach));
  }
  return maps;
}

} // namespace dewpoint::tracking
