// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/target_actors.h"

#include "core/base/belief_region.h"
#include "ui/scene3d/ellipsoid_axes.h"

#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace dewpoint::ui {
namespace {

constexpr double kSmallestBodyPx = 5.5;  ///< radius
constexpr double kSmallestRingsPx = 7.0; ///< radius; smaller ones would cover the cloud
constexpr double kTailPx = 2.5;
constexpr double kTailOutlinePx = 0.8;
constexpr double kPathPx = 1.3;
constexpr double kSightPx = 1.0;
constexpr double kSightOpacity = 0.5;
constexpr int kSightDashes = 28;

/// Opacities of the glass: looked through, and at its rim.
struct GlassLook {
  double middle;
  double rim;
};
constexpr GlassLook kHeldGlass{0.28, 0.9};
constexpr GlassLook kGhost{0.07, 0.4}; ///< not held

/// Three great circles of the unit ball.
void unitRings(vtkPolyData* data) {
  constexpr int kSteps = 72;
  LinesAndFaces strokes;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Eigen::Vector3d> ring;
    for (int i = 0; i <= kSteps; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kSteps;
      Eigen::Vector3d point = Eigen::Vector3d::Zero();
      point[(axis + 1) % 3] = std::cos(angle);
      point[(axis + 2) % 3] = std::sin(angle);
      ring.push_back(point);
    }
    strokes.addPolyline(ring);
  }
  strokes.writeTo(data);
}

} // namespace

TargetActors::TargetActors(vtkRenderer* renderer)
    : renderer_(renderer), palette_(scenePalette(false)), shadow_(renderer),
      seen_(renderer, kSightPx), hidden_(renderer, kSightPx),
      tail_(renderer, kTailPx, kTailOutlinePx), path_(renderer, kPathPx, 0.0),
      body_(renderer, GlassBody::Layer::Fill), rings_(addNewActor(renderer, ringData_)),
      cloud_(renderer), rim_(renderer, GlassBody::Layer::Rim),
      truthMark_(addNewActor(renderer, truthData_)), bestMark_(addNewActor(renderer, bestData_)) {
  unitRings(ringData_);
  rings_->SetUserMatrix(ellipsoidPose_);
}

TargetActors::~TargetActors() {
  for (const auto& actor : {rings_, truthMark_, bestMark_}) {
    renderer_->RemoveActor(actor);
  }
}

void TargetActors::show(const TargetSnapshot& target) {
  showPerson(target.shape.get());
  // The hull says it better than the points it is made of.
  target.shape == nullptr ? cloud_.show(target.particles, target.weights) : cloud_.hide();
  showEstimate(target);
  tail_.show(target.tailPositions);
  showTruth(target);
  best_ = bestParticleOf(target.estimate);
  showBest();
}

void TargetActors::showPerson(const PersonShape* shape) {
  if (shape != nullptr && person_ == nullptr) {
    person_ = std::make_unique<PersonActors>(renderer_);
    person_->setColor(color_, palette_);
    person_->setChosen(chosen_);
  }
  if (person_ != nullptr) {
    person_->show(shape);
  }
}

void TargetActors::setChosen(bool chosen) {
  chosen_ = chosen;
  if (person_ != nullptr) {
    person_->setChosen(chosen);
  }
}

void TargetActors::showLinesOfSight(const std::vector<SightLine>& lines) {
  std::vector<std::vector<Eigen::Vector3d>> seen;
  std::vector<std::vector<Eigen::Vector3d>> hidden;
  for (const SightLine& line : lines) {
    if (line.seesTarget) {
      seen.push_back({line.from, line.to});
    } else {
      const auto strokes = dashedLine(line.from, line.to, kSightDashes);
      hidden.insert(hidden.end(), strokes.begin(), strokes.end());
    }
  }
  seen_.show(seen);
  hidden_.show(hidden);
}

void TargetActors::setBestParticleShown(bool shown) {
  bestShown_ = shown;
  showBest();
}

void TargetActors::showBest() {
  bestMark_->SetVisibility(bestShown_ && best_ && best_->allFinite());
}

void TargetActors::showEstimate(const TargetSnapshot& target) {
  const auto position = positionOf(target.estimate);
  const bool known = position && position->mean.allFinite() &&
                     particleCountOf(target.estimate) > 0 && target.shape == nullptr;
  held_ = isConfirmed(target.estimate);
  cloudRadius_ = 0.0;
  body_.setVisible(known);
  rim_.setVisible(known);
  if (!known) {
    shadow_.hide();
    return;
  }
  mean_ = position->mean;
  showBody(target);
  paintBody();
  shadow_.show(mean_, radius_);
  showEllipsoid(position->covariance);
}

void TargetActors::showBody(const TargetSnapshot& target) {
  radius_ = std::isfinite(target.target.radius) ? std::max(0.0, target.target.radius) : 0.0;
  semiAxes_.setConstant(radius_);
  directions_.setIdentity();
  if (const auto extent = extentOf(target.estimate)) {
    if (const auto axes = ellipsoidAxesOf(*extent)) {
      semiAxes_ = axes->eigenvalues.cwiseMax(1e-8).cwiseSqrt();
      directions_ = axes->directions;
      radius_ = semiAxes_.maxCoeff();
    }
  }
}

void TargetActors::showEllipsoid(const Eigen::Matrix3d& covariance) {
  const auto axes = ellipsoidAxesOf(covariance);
  if (!axes) {
    return;
  }
  const Eigen::Matrix3d& directions = axes->directions;
  const Eigen::Vector3d semiAxes =
      (axes->eigenvalues * kChiSquared95ThreeDof).cwiseMax(1e-12).cwiseSqrt().cwiseMax(1e-4);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      ellipsoidPose_->SetElement(row, column, directions(row, column) * semiAxes[column]);
    }
    ellipsoidPose_->SetElement(row, 3, mean_[row]);
  }
  ellipsoidPose_->Modified();
  cloudRadius_ = semiAxes.maxCoeff();
}

void TargetActors::showTruth(const TargetSnapshot& target) {
  const bool known = target.truth && target.truth->allFinite();
  truthMark_->SetVisibility(known);
  if (known) {
    truth_ = *target.truth;
  }
}

void TargetActors::setColors(const SceneColor& color, const ScenePalette& palette, bool dark) {
  color_ = color;
  palette_ = palette;
  paintBody();
  cloud_.setColors(mix(palette.floor, color, 0.45), mix(color, palette.truth, dark ? 0.6 : 0.4));
  setActorColor(rings_, mix(color, palette.truth, 0.1), 0.55);
  shadow_.setColors(mix(color, palette.text, 0.5), dark);
  tail_.setColors(color, SceneColor::Zero());
  path_.setColors(palette.truth, SceneColor::Zero());
  for (WireActor* sight : {&seen_, &hidden_}) {
    sight->setColor(mix(color, palette.text, 0.25), kSightOpacity);
  }
  setActorColor(truthMark_, palette.truth);
  setActorColor(bestMark_, mix(color, palette.truth, 0.2));
  if (person_ != nullptr) {
    person_->setColor(color, palette);
  }
}

void TargetActors::paintBody() {
  const GlassLook& look = held_ ? kHeldGlass : kGhost;
  const SceneColor edge = mix(color_, palette_.truth, 0.35);
  body_.setAppearance(color_, edge, look.middle, look.rim);
  rim_.setAppearance(color_, edge, 0.0, look.rim);
}

void TargetActors::placeBody(const ScreenScale& scale) {
  const Eigen::Vector3d axes = semiAxes_.cwiseMax(scale.lengthInMeters(mean_, kSmallestBodyPx));
  body_.setPose(mean_, directions_, axes, scale);
  rim_.setPose(mean_, directions_, axes, scale);
  rings_->SetVisibility(cloudRadius_ > scale.lengthInMeters(mean_, kSmallestRingsPx));
}

/// Cross hairs about the true position that leave the middle open for the estimate.
void TargetActors::drawTruth(const ScreenScale& scale) {
  if (truthMark_->GetVisibility() == 0) {
    return;
  }
  const double inner = std::max(scale.lengthInMeters(truth_, kSmallestBodyPx), radius_) +
                       scale.lengthInMeters(truth_, 1.0);
  const double outer = inner + scale.lengthInMeters(truth_, 7.0);
  const double nearer = 1.5 * cloudRadius_ + 3.0 * outer;
  LinesAndFaces hairs;
  for (int axis = 0; axis < 3; ++axis) {
    // Along the line of sight a hair would be a dot on the estimate.
    if (std::abs(scale.direction[axis]) > 0.97) {
      continue;
    }
    for (const double sign : {-1.0, 1.0}) {
      const Eigen::Vector3d arm = Eigen::Vector3d::Unit(axis) * sign;
      hairs.addLine(scale.movedCloser(truth_ + arm * inner, nearer),
                    scale.movedCloser(truth_ + arm * outer, nearer));
    }
  }
  hairs.writeTo(truthData_);
}

/// A triangle in the plane of the picture, as in the images of the cameras.
void TargetActors::drawBest(const ScreenScale& scale) {
  if (bestMark_->GetVisibility() == 0) {
    return;
  }
  const double pixel = scale.lengthInMeters(*best_, 1.0);
  const double nearer = 1.5 * cloudRadius_ + 3.0 * (radius_ + 8.0 * pixel);
  std::vector<Eigen::Vector3d> corners;
  for (const auto& [right, up] : {std::pair{0.0, 8.0}, {7.0, -4.5}, {-7.0, -4.5}, {0.0, 8.0}}) {
    const Eigen::Vector3d corner = *best_ + pixel * (right * scale.right + up * scale.up);
    corners.push_back(scale.movedCloser(corner, nearer));
  }
  LinesAndFaces triangle;
  triangle.addPolyline(corners);
  triangle.writeTo(bestData_);
}

void TargetActors::prepareRendering(const ScreenScale& scale) {
  placeBody(scale);
  cloud_.prepareRendering(scale, mean_);
  shadow_.prepareRendering(scale);
  seen_.prepareRendering(scale);
  hidden_.prepareRendering(scale);
  tail_.prepareRendering(scale);
  path_.prepareRendering(scale);
  drawTruth(scale);
  drawBest(scale);
  if (person_ != nullptr) {
    person_->prepareRendering(scale);
  }
  const auto width = [&](double pixels) { return static_cast<float>(pixels * scale.pixelRatio); };
  rings_->GetProperty()->SetLineWidth(width(1.0));
  truthMark_->GetProperty()->SetLineWidth(width(1.6));
  bestMark_->GetProperty()->SetLineWidth(width(1.6));
}

} // namespace dewpoint::ui
