// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/color_adaptation.h"

#include <algorithm>

namespace dewpoint::tracking {
namespace {

// Judgments (docs/method-dewpoint.md, section 8).

/// Least existence of a target whose color is adapted.
constexpr double kMinExistence = 0.95;
/// Radii, largest spread of its particles: else its outline may lie elsewhere.
constexpr double kMaxSpreadRadii = 0.5;
/// Least effective sample size, as a share of the particles.
constexpr double kMinEffectiveShare = 0.1;
/// Pixels, least radius of an outline: of smaller ones most pixels are mixed with the background.
constexpr double kMinRadiusPx = 3.0;
/// Factor of the sum of their radii, least distance between two outlines that do not blur into each
/// other.
constexpr double kMinSeparation = 1.2;

bool liesWithin(const SphereImage& outline, const cv::Size& size) {
  const Eigen::Array2d corner(size.width - 1, size.height - 1);
  return (outline.center.array() >= outline.radius).all() &&
         (outline.center.array() <= corner - outline.radius).all();
}

bool isCertain(const TrackedObject& target, const SphereEstimate& estimate) {
  const TrackHypothesis* best = target.track.mostLikelyHypothesis();
  return best != nullptr && best->isSaturated() && estimate.isValid && !estimate.isDegenerate &&
         !estimate.extent && // its outline is not known to the pixel
         estimate.existenceProbability >= kMinExistence &&
         estimate.spread() <= kMaxSpreadRadii * estimate.radius &&
         estimate.effectiveSampleSize >= kMinEffectiveShare * estimate.particleCount;
}

/// Outlines of the other objects in one camera, or of those of the target's color only.
std::vector<SphereImage> outlinesOfOthers(const TrackedObjects& objects, std::size_t target,
                                          std::size_t camera, bool sameColor) {
  const TrackedObject& own = objects[target];
  std::vector<SphereImage> outlines;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const TrackHypothesis* other = k != target ? objects[k].track.confidentHypothesis() : nullptr;
    if (other == nullptr || (sameColor && !haveSameColor(objects[k], own))) {
      continue;
    }
    if (const auto outline =
            own.observation.projector(camera).project(other->position(), other->radius)) {
      outlines.push_back(*outline);
    }
  }
  return outlines;
}

/// Whether a camera shows a target, whose outline there is `outline`, whole and alone.
bool showsWhole(const TrackedObjects& objects, const FrameImages& images,
                const SphereEstimate& estimate, std::size_t target, std::size_t camera,
                const SphereImage& outline) {
  const auto& cameras = estimate.cameras;
  if (camera >= cameras.size() || !cameras[camera].isInView ||
      cameras[camera].visibleShare < kWholeShare || outline.radius < kMinRadiusPx ||
      !liesWithin(outline, images.frame(camera)->image.size())) {
    return false;
  }
  const auto others = outlinesOfOthers(objects, target, camera, false);
  return std::ranges::none_of(others, [&](const SphereImage& other) {
    return (other.center - outline.center).norm() <
           kMinSeparation * (other.radius + outline.radius);
  });
}

void adaptColor(TrackedObjects& objects, const FrameImages& images, const SphereEstimate& estimate,
                std::size_t target, double share) {
  TrackedObject& own = objects[target];
  const Eigen::Vector3d velocity = own.track.mostLikelyHypothesis()->velocity();
  for (std::size_t camera = 0; camera < images.cameraCount(); ++camera) {
    const FramePtr frame = images.frame(camera);
    if (!frame) {
      continue;
    }
    const Eigen::Vector3d position = estimate.mean + images.timeOffset(camera) * velocity;
    const auto outline = own.observation.projector(camera).project(position, estimate.radius);
    if (outline && showsWhole(objects, images, estimate, target, camera, *outline)) {
      own.color.adapt(camera, frame->image, *outline,
                      outlinesOfOthers(objects, target, camera, true), share);
    }
  }
}

} // namespace

void adaptColors(TrackedObjects& objects, const FrameImages& images,
                 const std::vector<SphereEstimate>& estimates, double share) {
  for (std::size_t k = 0; k < objects.targetCount(); ++k) {
    if (isCertain(objects[k], estimates[k])) {
      adaptColor(objects, images, estimates[k], k, share);
    }
  }
  // A distractor looks like its target in this light as well.
  for (std::size_t k = objects.targetCount(); k < objects.size(); ++k) {
    const auto end = objects.begin() + static_cast<std::ptrdiff_t>(objects.targetCount());
    const auto same = std::find_if(objects.begin(), end, [&](const TrackedObject& target) {
      return haveSameColor(target, objects[k]);
    });
    if (same != end) {
      objects[k].color = same->color;
    }
  }
}

} // namespace dewpoint::tracking
