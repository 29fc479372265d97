// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/sphere/sphere_observation.h"

#include "core/observation/sphere/sphere_evidence.h"

#include <algorithm>

namespace dewpoint::observation {
namespace {

/// Pixels, largest radius of an outline; a larger one is right in front of the lens. A judgment
/// (docs/method-dewpoint.md, section 4).
constexpr double kLargestRadiusPx = 2000.0;
/// Share of the spokes, of those that nothing hides, on which the color must end. A judgment: a
/// third may touch something of the color; of a disc in the corner of a large area half end.
constexpr double kRimShare = 0.6;

Eigen::Vector3d positionInRow(ConstStateRows rows, Eigen::Index row, double timeOffset) {
  Eigen::Vector3d position(rows(row, 0), rows(row, 1), rows(row, 2));
  if (rows.cols() >= 6 && timeOffset != 0.0) {
    position += timeOffset * Eigen::Vector3d(rows(row, 3), rows(row, 4), rows(row, 5));
  }
  return position;
}

} // namespace

SphereObservation::SphereObservation(const CameraRig& rig) {
  views_.reserve(rig.size());
  for (const Camera& camera : rig) {
    views_.push_back(View{SphereProjector(camera), {}, 0.0, {}});
  }
}

void SphereObservation::setImage(std::size_t camera, const cv::Mat& image, double timeOffset,
                                 const BackgroundModel& background,
                                 const ColorClassifier& classifier, const ColorClassifier& usual) {
  View& view = views_.at(camera);
  view.timeOffset = timeOffset;
  if (image.type() != CV_8UC3 || image.empty()) {
    view.labels.clear();
  } else {
    view.labels.setImage(image, background, classifier, usual);
  }
}

SphereImage SphereObservation::outlineOf(const View& view, ConstStateRows rows,
                                         Eigen::Index row) const {
  const auto outline = view.projector.project(positionInRow(rows, row, view.timeOffset), radius_);
  return outline && outline->radius < kLargestRadiusPx ? *outline : SphereImage{};
}

void SphereObservation::ensureLabelsFor(ConstStateRows rows) {
  ThreadTeam alone;
  logLikelihoods(rows, alone);
}

void SphereObservation::addLogLikelihood(ConstStateRows rows,
                                         LogWeightSegment logLikelihood) const {
  for (const View& view : views_) {
    for (Eigen::Index i = 0; !view.labels.empty() && i < rows.rows(); ++i) {
      const SphereImage outline = outlineOf(view, rows, i);
      if (outline.radius > 0.0) {
        logLikelihood[i] += SphereEvidence::logLikelihoodRatio(view.labels, outline);
      }
    }
  }
}

Eigen::ArrayXd SphereObservation::logLikelihoods(ConstStateRows rows, ThreadTeam& team) {
  Eigen::ArrayXd sums = Eigen::ArrayXd::Zero(rows.rows());
  for (View& view : views_) {
    if (view.labels.empty()) {
      continue;
    }
    view.outlines.resize(static_cast<std::size_t>(rows.rows()));
    team.forEachRange(rows.rows(), [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t i = begin; i < end; ++i) {
        view.outlines[static_cast<std::size_t>(i)] = outlineOf(view, rows, i);
      }
    });
    const cv::Rect whole(cv::Point(0, 0), view.labels.size());
    cv::Rect all;
    for (const SphereImage& outline : view.outlines) {
      if (outline.radius > 0.0) {
        all |= areaOf(outline, SphereEvidence::kSampleReach) & whole;
      }
    }
    view.labels.ensureLabels(all);
    team.forEachRange(rows.rows(), [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t i = begin; i < end; ++i) {
        const SphereImage& outline = view.outlines[static_cast<std::size_t>(i)];
        if (outline.radius > 0.0) {
          sums[i] += SphereEvidence::logLikelihoodRatio(view.labels, outline);
        }
      }
    });
  }
  return sums;
}

double SphereObservation::logLikelihoodRatio(const Eigen::Vector3d& center,
                                             const Eigen::Vector3d& velocity) {
  double sum = 0.0;
  for (View& view : views_) {
    const auto outline = view.projector.project(center + view.timeOffset * velocity, radius_);
    if (!view.labels.empty() && outline && outline->radius < kLargestRadiusPx) {
      view.labels.ensureLabels(areaOf(*outline, SphereEvidence::kSampleReach));
      sum += SphereEvidence::logLikelihoodRatio(view.labels, *outline);
    }
  }
  return sum;
}

double SphereObservation::explainedRingGain(const Eigen::Vector3d& center,
                                            const std::vector<OutlineSphere>& others) const {
  double sum = 0.0;
  for (const View& view : views_) {
    const auto outline = view.projector.project(center, radius_);
    if (view.labels.empty() || !outline || outline->radius >= kLargestRadiusPx) {
      continue;
    }
    std::vector<SphereImage> covering;
    for (const OutlineSphere& other : others) {
      const auto its = view.projector.project(other.center, other.radius);
      if (its && (its->center - outline->center).norm() > outline->radius) {
        covering.push_back(*its);
      }
    }
    sum += SphereEvidence::explainedRingGain(view.labels, *outline, covering);
  }
  return sum;
}

double SphereObservation::fullyVisibleLogLikelihoodRatio(const Eigen::Vector3d& center,
                                                         const Eigen::Vector3d& velocity) const {
  double sum = 0.0;
  for (const View& view : views_) {
    const auto outline = view.projector.project(center + view.timeOffset * velocity, radius_);
    if (!view.labels.empty() && outline && isInImage(*outline, view.labels.size())) {
      sum += SphereEvidence::maxLogLikelihoodRatio();
    }
  }
  return sum;
}

bool SphereObservation::isRimVisible(const Eigen::Vector3d& center,
                                     const Eigen::Vector3d& velocity) {
  return std::any_of(views_.begin(), views_.end(), [&](View& view) {
    const auto outline = view.projector.project(center + view.timeOffset * velocity, radius_);
    if (view.labels.empty() || !outline || outline->radius >= kLargestRadiusPx ||
        !isInImage(*outline, view.labels.size())) {
      return false;
    }
    view.labels.ensureLabels(areaOf(*outline, SphereEvidence::kSampleReach));
    return SphereEvidence::rimShare(view.labels, *outline) >= kRimShare;
  });
}

int SphereObservation::countCamerasInView(const Eigen::Vector3d& center,
                                          const Eigen::Vector3d& velocity) const {
  int count = 0;
  for (const View& view : views_) {
    const auto outline = view.projector.project(center + view.timeOffset * velocity, radius_);
    count += !view.labels.empty() && outline && isInImage(*outline, view.labels.size()) ? 1 : 0;
  }
  return count;
}

std::vector<CameraEvidence> SphereObservation::evidence(const Eigen::Vector3d& center,
                                                        const Eigen::Vector3d& velocity) {
  std::vector<CameraEvidence> cameras(views_.size());
  for (std::size_t k = 0; k < views_.size(); ++k) {
    View& view = views_[k];
    const auto outline = view.projector.project(center + view.timeOffset * velocity, radius_);
    if (!view.labels.empty() && outline && outline->radius < kLargestRadiusPx) {
      view.labels.ensureLabels(areaOf(*outline, SphereEvidence::kSampleReach));
      cameras[k].isInView = isInImage(*outline, view.labels.size());
      cameras[k].logLikelihood = SphereEvidence::logLikelihoodRatio(view.labels, *outline);
      cameras[k].existenceProbability = probabilityFromLogOdds(cameras[k].logLikelihood);
      cameras[k].visibleShare = SphereEvidence::matchShare(view.labels, *outline);
    }
  }
  return cameras;
}

int SphereObservation::countSeeingCameras(const std::vector<CameraEvidence>& cameras) {
  return static_cast<int>(std::count_if(cameras.begin(), cameras.end(), [](const auto& camera) {
    return camera.visibleShare >= kSeenShare;
  }));
}

OutlineFit SphereObservation::fit(const OutlinePrior& prior, const Eigen::Vector3d& velocity,
                                  EdgeSearchRange reach) {
  std::vector<OutlineView> views;
  views.reserve(views_.size());
  for (View& view : views_) {
    views.push_back({&view.projector, &view.labels, view.timeOffset * velocity});
  }
  return fitOutline(views, prior, reach);
}

} // namespace dewpoint::observation
