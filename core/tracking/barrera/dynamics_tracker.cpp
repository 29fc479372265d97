// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/barrera/dynamics_tracker.h"

#include "core/observation/boxes/mass_center.h"
#include "core/observation/sphere/position_likelihood.h"

#include <algorithm>
#include <utility>

namespace dewpoint::tracking {

DynamicsTracker::DynamicsTracker(const ParameterValues& parameters, const CameraRig& rig,
                                 const Target& target)
    : RandomWalkTracker(parameters), unprojectors_(rig.begin(), rig.end()),
      classifier_(target.colors()), seen_(rig.size(), false) {}

void DynamicsTracker::setTarget(const Target& target) {
  classifier_ = ColorClassifier(target.colors());
}

void DynamicsTracker::setCameras(const CameraRig& rig) {
  unprojectors_ = std::vector<Unprojector>(rig.begin(), rig.end());
  measure();
}

void DynamicsTracker::beginFrame(FrameSetPtr frames) {
  RandomWalkTracker::beginFrame(std::move(frames));
  measure();
}

void DynamicsTracker::beginFrame(std::int64_t frame,
                                 const std::optional<Eigen::Vector3d>& measured) {
  FrameSet empty;
  empty.index = frame; // the random numbers go by frame number
  RandomWalkTracker::beginFrame(std::make_shared<const FrameSet>(std::move(empty)));
  seen_.assign(seen_.size(), false);
  measured_ = measured;
}

void DynamicsTracker::measure() {
  std::vector<Ray> rays;
  for (std::size_t camera = 0; camera < unprojectors_.size(); ++camera) {
    const auto center = centerOfMass(imageOf(camera), classifier_);
    seen_[camera] = center.has_value();
    if (const auto ray = center ? unprojectors_[camera].ray(*center) : std::nullopt) {
      rays.push_back(*ray);
    }
  }
  measured_ = nearestPoint(rays);
  if (measured_ && !isInVolumeOfInterest(*measured_)) {
    measured_.reset();
  }
}

SphereEstimate DynamicsTracker::iterate(ThreadTeam& team) {
  const double sigma = parameters_.at("observation_sigma");
  SphereEstimate result = step(PositionLikelihood{measured_, sigma}, team);
  result.cameras.resize(unprojectors_.size());
  for (std::size_t camera = 0; camera < seen_.size(); ++camera) {
    result.cameras[camera].isInView = !imageOf(camera).empty();
    result.cameras[camera].visibleShare = seen_[camera] ? 1.0 : 0.0;
    result.cameras[camera].existenceProbability = result.cameras[camera].visibleShare;
  }
  result.seeingCameraCount = static_cast<int>(std::ranges::count(seen_, true));
  result.isValid = measured_.has_value() && isInVolumeOfInterest(result.mean);
  result.existenceProbability = result.isValid ? 1.0 : 0.0; // the filter has no opinion of its own
  if (measured_) {
    result.measurement = Gaussian3{*measured_, sigma * sigma * Eigen::Matrix3d::Identity()};
  }
  estimate_ = result;
  return result;
}

std::vector<CameraReport> DynamicsTracker::cameraReports() const {
  std::vector<CameraReport> reports(unprojectors_.size());
  for (std::size_t camera = 0; camera < reports.size(); ++camera) {
    const cv::Mat image = imageOf(camera);
    reports[camera].status = image.empty()   ? CameraStatus::NoImage
                             : seen_[camera] ? CameraStatus::None
                             : isDark(image) ? CameraStatus::Dark
                                             : CameraStatus::NoColor;
  }
  return reports;
}

} // namespace dewpoint::tracking
