// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/clicks/counterpart_search.h"

#include "core/color/likelihood/other_camera_likelihood.h"
#include "core/geometry/projector.h"
#include "core/geometry/ray.h"
#include "core/setup/clicks/ray_regions.h"

#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace dewpoint::setup {
namespace {

// Judgments; the weights were set by S22 in grade room, seeds 1 to 8.

/// Natural logarithm of the ratio between the areas seen and expected, standard deviation: another
/// side, partly hidden, a region that is grown too far.
constexpr double kLogAreaSigma = 0.7;
/// The same of the radius that the click's region has at a position, against the one that is known.
constexpr double kLogRadiusSigma = 0.35;
/// Radii of objects that are clicked, meters.
constexpr double kLeastRadius = 0.002;
constexpr double kMostRadius = 2.0;
/// How often the mean log ratio of a region counts: its pixels are not independent.
constexpr double kColorWeight = 2.0;
/// Log odds of a region before anything is known of it: a few places along a ray look like objects.
constexpr double kRegionPrior = -1.0;
/// Log odds of a camera that should see the object and shows nothing of it.
constexpr double kHiddenLogOdds = -2.0;
/// Probability from which on a region is the object, and up to which it is not.
constexpr double kAcceptProbability = 0.9;
constexpr double kRejectProbability = 0.02;
/// Log odds of what cannot be.
constexpr double kImpossibleLogOdds = -1e9;

double gauss(double sigmas) {
  return -0.5 * sigmas * sigmas;
}

bool isCalibrated(const Camera& camera, const cv::Mat& image) {
  return camera.intrinsics.focalX > 0.0 && camera.intrinsics.focalY > 0.0 &&
         image.type() == CV_8UC3 && image.cols == camera.intrinsics.width &&
         image.rows == camera.intrinsics.height;
}

bool containsExcluded(const RayRegion& region, int camera,
                      const std::vector<ColorSample>& excluded) {
  return std::ranges::any_of(excluded, [&](const ColorSample& sample) {
    const cv::Point at(static_cast<int>(std::lround(sample.x + 0.5 * sample.width)),
                       static_cast<int>(std::lround(sample.y + 0.5 * sample.height)));
    return sample.camera == camera && cv::Rect({0, 0}, region.mask.size()).contains(at) &&
           region.mask.at<std::uint8_t>(at) != 0;
  });
}

/// A position of the object, and which region shows it in each camera.
struct Hypothesis {
  std::vector<std::optional<std::size_t>> regions; ///< per camera
  double logOdds = 0.0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< meters, world
};

/// The object clicked, and what the other cameras show along its ray.
class CounterpartSearch {
public:
  CounterpartSearch(const CameraRig& rig, const std::vector<cv::Mat>& images,
                    const ClickedObject& object, const ColorSample& sample,
                    const CounterpartLimits& limits);

  Counterparts result() const;

private:
  bool isPossible(double depth) const;
  bool isInView(std::size_t camera, const Eigen::Vector3d& position) const;
  /// Log odds of a region if the object is at `position`, which is off by `depthSigma` (meters)
  /// along the click's ray.
  double weigh(std::size_t camera, const RayRegion& region, const Eigen::Vector3d& position,
               double depthSigma) const;
  /// That the object is where the click and a region meet, with what the other cameras show.
  std::optional<Hypothesis> hypothesisOf(std::size_t camera, std::size_t region) const;
  /// The probability of each region of a camera, and last that none of them is the object.
  std::vector<double> probabilities(std::size_t camera,
                                    const std::vector<Hypothesis>& hypotheses) const;
  void decide(std::size_t camera, const std::vector<double>& probabilities,
              Counterparts& counterparts) const;
  double radiusOf(const Hypothesis& hypothesis) const;

  const CameraRig& rig_;
  const std::vector<cv::Mat>& images_;
  const ClickedObject& object_;
  const CounterpartLimits& limits_;
  std::vector<Projector> projectors_;
  std::vector<std::vector<RayRegion>> regions_; ///< per camera
};

CounterpartSearch::CounterpartSearch(const CameraRig& rig, const std::vector<cv::Mat>& images,
                                     const ClickedObject& object, const ColorSample& sample,
                                     const CounterpartLimits& limits)
    : rig_(rig), images_(images), object_(object), limits_(limits) {
  const color::OtherCameraLikelihood likelihood(sample.colors);
  for (std::size_t camera = 0; camera < rig.size(); ++camera) {
    projectors_.emplace_back(rig[camera]);
    auto& regions = regions_.emplace_back();
    if (camera != object.camera && isCalibrated(rig[camera], images[camera])) {
      regions = regionsAlongRay(object, rig[camera], images[camera], likelihood,
                                [this](double depth) { return isPossible(depth); });
      std::erase_if(regions, [&](const RayRegion& region) {
        return containsExcluded(region, static_cast<int>(camera), limits.excludedSamples);
      });
    }
  }
}

bool CounterpartSearch::isPossible(double depth) const {
  const double radius = object_.radiusAt(depth);
  return depth > 0.0 && radius >= kLeastRadius && radius <= kMostRadius &&
         (!limits_.volume || limits_.volume->contains(object_.positionAt(depth), radius)) &&
         (limits_.radius <= 0.0 || std::abs(std::log(radius / limits_.radius)) <
                                       ClickedObject::kSearchSigmas * kLogRadiusSigma);
}

bool CounterpartSearch::isInView(std::size_t camera, const Eigen::Vector3d& position) const {
  const auto pixel = projectors_[camera].project(position);
  const cv::Mat& image = images_[camera];
  return pixel && pixel->x() >= 0.0 && pixel->y() >= 0.0 && pixel->x() <= image.cols - 1.0 &&
         pixel->y() <= image.rows - 1.0;
}

double CounterpartSearch::weigh(std::size_t camera, const RayRegion& region,
                                const Eigen::Vector3d& position, double depthSigma) const {
  const auto pixel = projectors_[camera].project(position);
  if (!pixel) {
    return kImpossibleLogOdds;
  }
  const double radiusPx = object_.radiusPxIn(rig_[camera], position);
  const double sigma = ClickedObject::centerSigma(rig_[camera], radiusPx);
  const auto farther = projectors_[camera].project(position + depthSigma * object_.ray.direction);
  const Eigen::Vector2d alongRay =
      farther ? Eigen::Vector2d(*farther - *pixel) : Eigen::Vector2d::Zero();
  const Eigen::Matrix2d covariance =
      sigma * sigma * Eigen::Matrix2d::Identity() + alongRay * alongRay.transpose();
  const Eigen::Vector2d off = region.center - *pixel;
  const double expectedArea = std::numbers::pi * radiusPx * radiusPx;
  return kRegionPrior + kColorWeight * region.meanLogLikelihoodRatio -
         0.5 * off.dot(covariance.inverse() * off) +
         gauss(std::log(region.areaPx / expectedArea) / kLogAreaSigma);
}

std::optional<Hypothesis> CounterpartSearch::hypothesisOf(std::size_t camera,
                                                          std::size_t region) const {
  const RayRegion& shown = regions_[camera][region];
  const auto ray = Unprojector(rig_[camera]).ray(shown.center);
  const auto meeting = ray ? nearestPoint({object_.ray, *ray}) : std::nullopt;
  const double depth = meeting ? object_.depthOf(*meeting) : 0.0;
  if (!isPossible(depth)) {
    return std::nullopt;
  }
  const Eigen::Vector3d position = object_.positionAt(depth);
  const double across = std::hypot(ClickedObject::kDirectionSigma * (position - ray->origin).norm(),
                                   ClickedObject::kCenterSigmaInRadii * object_.radiusAt(depth));
  const double depthSigma = across / object_.ray.direction.cross(ray->direction).norm();
  Hypothesis hypothesis;
  hypothesis.position = position;
  hypothesis.regions.resize(rig_.size());
  hypothesis.regions[camera] = region;
  hypothesis.logOdds = weigh(camera, shown, position, 0.0);
  if (limits_.radius > 0.0) {
    hypothesis.logOdds +=
        gauss(std::log(object_.radiusAt(depth) / limits_.radius) / kLogRadiusSigma);
  }
  for (std::size_t other = 0; other < rig_.size(); ++other) {
    if (other == camera || other == object_.camera || !isCalibrated(rig_[other], images_[other]) ||
        !isInView(other, position)) {
      continue;
    }
    double best = kHiddenLogOdds;
    for (std::size_t i = 0; i < regions_[other].size(); ++i) {
      const double logOdds = weigh(other, regions_[other][i], position, depthSigma);
      if (logOdds > best) {
        best = logOdds;
        hypothesis.regions[other] = i;
      }
    }
    hypothesis.logOdds += best;
  }
  return hypothesis;
}

std::vector<double>
CounterpartSearch::probabilities(std::size_t camera,
                                 const std::vector<Hypothesis>& hypotheses) const {
  const std::size_t none = regions_[camera].size();
  // Hypotheses that agree on the region of this camera are one as far as it is concerned.
  std::vector<double> best(none + 1, kImpossibleLogOdds);
  best[none] = 0.0;
  double most = 0.0;
  for (const Hypothesis& hypothesis : hypotheses) {
    double& logOdds = best[hypothesis.regions[camera].value_or(none)];
    logOdds = std::max(logOdds, hypothesis.logOdds);
    most = std::max(most, logOdds);
  }
  double sum = 0.0;
  for (double& value : best) {
    value = std::exp(value - most);
    sum += value;
  }
  for (double& value : best) {
    value /= sum;
  }
  return best;
}

void CounterpartSearch::decide(std::size_t camera, const std::vector<double>& probabilities,
                               Counterparts& counterparts) const {
  const auto& regions = regions_[camera];
  for (std::size_t i = 0; i < regions.size(); ++i) {
    ColorSample sample;
    sample.isFoundByGeometry = true;
    sample.camera = static_cast<int>(camera);
    sample.x = regions[i].seedPixel.x;
    sample.y = regions[i].seedPixel.y;
    const auto taken = probabilities[i] >= kAcceptProbability
                           ? color::takeSample(images_[camera], sample)
                           : Result<ColorSample>(sample);
    if (probabilities[i] >= kAcceptProbability && taken) {
      std::vector<std::vector<cv::Point>> outlines;
      cv::findContours(regions[i].mask.clone(), outlines, cv::RETR_EXTERNAL,
                       cv::CHAIN_APPROX_SIMPLE);
      counterparts.samples.push_back(*taken);
      counterparts.outlines.push_back(outlines.front());
      counterparts.centers.push_back({sample.camera, regions[i].center});
      counterparts.undecidedMasks[camera].release();
      return;
    }
    if (probabilities[i] > kRejectProbability) {
      cv::Mat& mask = counterparts.undecidedMasks[camera];
      mask = mask.empty() ? regions[i].mask.clone() : cv::Mat(mask | regions[i].mask);
    }
  }
}

/// The geometric mean of what the regions show, that of the click included.
double CounterpartSearch::radiusOf(const Hypothesis& hypothesis) const {
  double sum = std::log(object_.radiusAt(object_.depthOf(hypothesis.position)));
  double count = 1.0;
  for (std::size_t camera = 0; camera < rig_.size(); ++camera) {
    if (const auto& region = hypothesis.regions[camera]) {
      const double radiusPx = std::sqrt(regions_[camera][*region].areaPx / std::numbers::pi);
      const double distance = (hypothesis.position - rig_[camera].center()).norm();
      sum += std::log(radiusPx * distance / meanFocalLength(rig_[camera]));
      count += 1.0;
    }
  }
  return std::exp(sum / count);
}

Counterparts CounterpartSearch::result() const {
  std::vector<Hypothesis> hypotheses;
  for (std::size_t camera = 0; camera < rig_.size(); ++camera) {
    for (std::size_t i = 0; i < regions_[camera].size(); ++i) {
      if (auto hypothesis = hypothesisOf(camera, i)) {
        hypotheses.push_back(std::move(*hypothesis));
      }
    }
  }
  Counterparts counterparts;
  counterparts.undecidedMasks.resize(rig_.size());
  for (std::size_t camera = 0; camera < rig_.size(); ++camera) {
    decide(camera, probabilities(camera, hypotheses), counterparts);
  }
  if (!counterparts.samples.empty()) {
    counterparts.centers.push_back({static_cast<int>(object_.camera), object_.center});
    counterparts.radius = radiusOf(*std::ranges::max_element(hypotheses, {}, &Hypothesis::logOdds));
  }
  return counterparts;
}

} // namespace

Counterparts findCounterparts(const CameraRig& rig, const std::vector<cv::Mat>& images,
                              const ColorSample& sample, const CounterpartLimits& limits) {
  Counterparts nothing;
  nothing.undecidedMasks.resize(images.size());
  const auto camera = static_cast<std::size_t>(sample.camera);
  if (sample.camera < 0 || camera >= rig.size() || images.size() != rig.size() ||
      sample.colors.empty() || !isCalibrated(rig[camera], images[camera])) {
    return nothing;
  }
  const auto object = findClickedObject(rig[camera], images[camera], sample);
  if (!object) {
    return nothing;
  }
  Counterparts counterparts = CounterpartSearch(rig, images, *object, sample, limits).result();
  if (counterparts.samples.empty() && limits.radius > 0.0) {
    CounterpartLimits anySize = limits;
    anySize.radius = 0.0;
    Counterparts others = CounterpartSearch(rig, images, *object, sample, anySize).result();
    return others.samples.empty() ? counterparts : others;
  }
  return counterparts;
}

} // namespace dewpoint::setup
