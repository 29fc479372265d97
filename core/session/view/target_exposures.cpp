// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/view/target_exposures.h"

#include "core/base/overloaded.h"
#include "core/base/units.h"
#include "core/color/color_region.h"
#include "core/geometry/sphere_image.h"
#include "core/session/snapshot/snapshot_state.h"
#include "core/session/view/camera_overlay.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <ranges>

namespace dewpoint::session {
namespace {

/// Share of the outline that is measured: at its edge, pixels mix with the surroundings. Chosen.
constexpr double kMeasuredShare = 0.9;
/// Fewest pixels that say anything about an exposure. Chosen.
constexpr std::int64_t kFewestMeasured = 12;
/// colorDistance() up to which a pixel may belong to the sampled object in other light: that of a
/// different object.
constexpr double kSameObjectDistance = 5.0;

/// Whether the camera itself sees the target at its estimate.
bool isConfirmedBy(const TargetSnapshot& target, std::size_t camera) {
  if (!isConfirmed(target.estimate)) {
    return false;
  }
  if (camera < target.cameraReports.size()) {
    return target.cameraReports[camera].status == CameraStatus::None;
  }
  const auto& evidence = cameraEvidenceOf(target.estimate);
  constexpr double kMostlyVisible = 0.5;
  return camera >= evidence.size() ||
         (evidence[camera].isInView && evidence[camera].visibleShare >= kMostlyVisible);
}

std::optional<ImageEllipse> outlineOfBall(const Camera& camera, const SphereEstimate& ball,
                                          double givenRadius) {
  const double radius = ball.radius > 0.0 ? ball.radius : givenRadius;
  const auto circle =
      radius > 0.0 ? SphereProjector(camera).project(ball.mean, radius) : std::nullopt;
  return circle ? std::optional(ImageEllipse{circle->center, circle->radius, circle->radius, 0.0})
                : std::nullopt;
}

std::optional<ImageEllipse> outlineInView(const TrackSnapshot& snapshot, int camera,
                                          const TargetSnapshot& target) {
  const Camera* its = cameraOf(snapshot, camera);
  if (its == nullptr || !isConfirmedBy(target, static_cast<std::size_t>(camera))) {
    return std::nullopt;
  }
  using Outline = std::optional<ImageEllipse>;
  return std::visit(Overloaded{[&](const SphereEstimate& ball) -> Outline {
                                 return ball.extent
                                            ? cameraOverlay(snapshot, camera, target).outline
                                            : outlineOfBall(*its, ball, target.target.radius);
                               },
                               [&](const BoxEstimate& estimate) -> Outline {
                                 if (estimate.camera != camera) {
                                   return std::nullopt;
                                 }
                                 const ImageBox& box = estimate.box;
                                 return ImageEllipse{{box.x + 0.5 * box.width - 0.5,
                                                      box.y + 0.5 * box.height - 0.5},
                                                     0.5 * box.width,
                                                     0.5 * box.height,
                                                     0.0};
                               },
                               [](const PersonEstimate&) -> Outline { return std::nullopt; },
                               [](const AbsentEstimate&) -> Outline { return std::nullopt; }},
                    target.estimate);
}

/// The pixels inside an ellipse, as far as the image shows it.
TargetExposure exposureInside(const cv::Mat& image, const ImageEllipse& outline) {
  const double reach = kMeasuredShare * std::max(outline.semiMajorAxis, outline.semiMinorAxis);
  if (!outline.center.allFinite() || !(reach < 4.0 * (image.cols + image.rows))) {
    return {};
  }
  const cv::Point first(static_cast<int>(std::floor(outline.center.x() - reach)),
                        static_cast<int>(std::floor(outline.center.y() - reach)));
  const int size = static_cast<int>(std::ceil(2.0 * reach)) + 2;
  const cv::Rect area = cv::Rect(first, cv::Size(size, size)) & cv::Rect({0, 0}, image.size());
  if (area.empty()) {
    return {};
  }
  cv::Mat mask(area.size(), CV_8UC1, cv::Scalar(0));
  const Eigen::Vector2d center = outline.center - Eigen::Vector2d(area.x, area.y);
  cv::ellipse(
      mask,
      cv::RotatedRect(cv::Point2f(static_cast<float>(center.x()), static_cast<float>(center.y())),
                      cv::Size2f(static_cast<float>(2.0 * kMeasuredShare * outline.semiMajorAxis),
                                 static_cast<float>(2.0 * kMeasuredShare * outline.semiMinorAxis)),
                      static_cast<float>(inDegrees(outline.angleRadians))),
      cv::Scalar(255), cv::FILLED);
  return exposureOf(image(area), mask);
}

/// The pixel at which a sample was taken: of a box, its center.
cv::Point pixelOfSample(const ColorSample& sample) {
  return {static_cast<int>(std::lround(sample.x + 0.5 * sample.width)),
          static_cast<int>(std::lround(sample.y + 0.5 * sample.height))};
}

/// The region of a sample in an image, if the sampled object is still there.
TargetExposure exposureOfSample(const cv::Mat& image, const ColorSample& sample) {
  const cv::Point at = pixelOfSample(sample);
  if (sample.colors.empty() || !cv::Rect({0, 0}, image.size()).contains(at)) {
    return {};
  }
  const auto pixel = image.at<cv::Vec3b>(at);
  const BgrColor seen{pixel[0], pixel[1], pixel[2]};
  if (colorDistance(seen, medianColor(sample.colors)) > kSameObjectDistance) {
    return {};
  }
  return exposureOf(image, regionOfSample(image, sample));
}

} // namespace

std::vector<ExposureInView> exposuresInView(const TrackSnapshot& snapshot, int camera) {
  std::vector<ExposureInView> found;
  const auto index = static_cast<std::size_t>(camera);
  const bool hasImage = camera >= 0 && snapshot.frames && !snapshot.isPreview &&
                        index < snapshot.frames->frames.size() && snapshot.frames->frames[index] &&
                        snapshot.frames->frames[index]->image.type() == CV_8UC3;
  if (!hasImage) {
    return found;
  }
  const cv::Mat& image = snapshot.frames->frames[index]->image;
  for (std::size_t k = 0; k < snapshot.targets.size(); ++k) {
    const TargetSnapshot& target = snapshot.targets[k];
    ExposureInView view{k, target.target.name, false, {}};
    if (const auto outline = outlineInView(snapshot, camera, target)) {
      view.isTracked = true;
      view.exposure = exposureInside(image, *outline);
    } else {
      const auto isHere = [&](const ColorSample& sample) {
        return sample.camera == camera && !sample.isExcluded;
      };
      const auto& samples = target.target.samples;
      const auto newest = std::ranges::find_if(samples.rbegin(), samples.rend(), isHere);
      if (newest != samples.rend()) {
        view.exposure = exposureOfSample(image, *newest);
      }
    }
    if (view.exposure.pixelCount >= kFewestMeasured) {
      found.push_back(std::move(view));
    }
  }
  return found;
}

const ExposureInView* worstExposure(const std::vector<ExposureInView>& exposures) {
  const auto badness = [](const ExposureInView& view) {
    const TargetExposure& exposure = view.exposure;
    const double clipped = exposure.clippedShare() / TargetExposure::kMaxClippedShare;
    return clipped >= 1.0 ? 1.0 + clipped
                          : std::max(clipped, exposure.darkShare() / TargetExposure::kMaxDarkShare);
  };
  const auto worst = std::ranges::max_element(exposures, {}, badness);
  return worst == exposures.end() ? nullptr : &*worst;
}

} // namespace dewpoint::session
