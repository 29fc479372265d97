// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/target_actors.h"

#include "ui/scene3d/ellipsoid_axes.h"

#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace dewpoint::ui {
namespace {

/// 95 % quantile of chi² with 3 degrees of freedom.
constexpr double kChiSquared95 = 7.815;
constexpr double kParticlePx = 1.7;       ///< radius
constexpr double kSmallestSpherePx = 4.5; ///< radius
constexpr Eigen::Index kMostParticles = 20000;
/// Of what is no ball: it may be large, and its cloud is inside.
constexpr double kBodyOpacity = 0.4;

/// A disc with a soft rim instead of VTK's Gaussian, whose wide skirt costs software OpenGL dearly.
constexpr const char* kDiscShader =
    "//VTK::Color::Impl\n"
    "float dist2 = dot(offsetVCVSOutput.xy, offsetVCVSOutput.xy);\n"
    "if (dist2 > 1.0) { discard; }\n"
    "opacity = 0.85 * opacity * (1.0 - smoothstep(0.5, 1.0, dist2));\n";

vtkSmartPointer<vtkActor> ballActor(int resolution) {
  vtkNew<vtkSphereSource> source;
  source->SetRadius(1.0);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution / 2 + 2);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.35);
  actor->GetProperty()->SetDiffuse(0.75);
  actor->PickableOff();
  actor->VisibilityOff();
  return actor;
}

/// Three great circles of the unit ball.
void unitRings(vtkPolyData* data) {
  constexpr int kSteps = 72;
  Strokes strokes;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Eigen::Vector3d> ring;
    for (int i = 0; i <= kSteps; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kSteps;
      Eigen::Vector3d point = Eigen::Vector3d::Zero();
      point[(axis + 1) % 3] = std::cos(angle);
      point[(axis + 2) % 3] = std::sin(angle);
      ring.push_back(point);
    }
    strokes.polyline(ring);
  }
  strokes.writeTo(data);
}

std::array<unsigned char, 3> bytes(const SceneColor& color) {
  std::array<unsigned char, 3> result{};
  for (int i = 0; i < 3; ++i) {
    result[static_cast<std::size_t>(i)] =
        static_cast<unsigned char>(std::lround(255.0 * std::clamp(color[i], 0.0, 1.0)));
  }
  return result;
}

bool isFinite(const Eigen::Vector3d& point) {
  return point.allFinite();
}

} // namespace

TargetActors::TargetActors(vtkRenderer* renderer, std::size_t index)
    : renderer_(renderer), index_(index), color_(targetColor(index)), palette_(scenePalette(false)),
      sphere_(ballActor(28)), halo_(ballActor(28)), ellipsoid_(ballActor(40)),
      rings_(flatActor(ringData_)), tail_(flatActor(tailData_)), plumb_(flatActor(plumbData_)),
      truthMark_(flatActor(truthData_)), bestMark_(flatActor(bestData_)), person_(renderer) {
  positions_->SetNumberOfComponents(3);
  colors_->SetNumberOfComponents(3);
  points_->SetData(positions_);
  cloudData_->SetPoints(points_);
  cloudData_->GetPointData()->SetScalars(colors_);
  cloudMapper_->SetInputData(cloudData_);
  cloudMapper_->EmissiveOff();
  cloudMapper_->SetSplatShaderCode(kDiscShader);
  cloudMapper_->SetTriangleScale(2.0F); // the triangle around the unit disc
  cloud_->SetMapper(cloudMapper_);
  cloud_->PickableOff();
  cloud_->VisibilityOff();
  unitRings(ringData_);
  halo_->GetProperty()->LightingOff();
  for (vtkActor* actor : {ellipsoid_.Get(), rings_.Get()}) {
    actor->SetUserMatrix(ellipsoidPose_);
  }
  // Translucent things are drawn in this order.
  for (vtkActor* actor : {plumb_.Get(), tail_.Get(), halo_.Get(), sphere_.Get(), truthMark_.Get(),
                          ellipsoid_.Get(), rings_.Get(), bestMark_.Get()}) {
    actor->VisibilityOff();
    renderer_->AddActor(actor);
  }
  renderer_->AddActor(cloud_);
}

TargetActors::~TargetActors() {
  for (vtkActor* actor : {plumb_.Get(), tail_.Get(), halo_.Get(), sphere_.Get(), truthMark_.Get(),
                          ellipsoid_.Get(), rings_.Get(), bestMark_.Get()}) {
    renderer_->RemoveActor(actor);
  }
  renderer_->RemoveActor(cloud_);
}

void TargetActors::show(const TargetSnapshot& target) {
  if (const SceneColor color = targetColor(target.target.name, index_); color != color_) {
    color_ = color;
    setPalette(palette_);
  }
  person_.show(target.shape.get());
  showParticles(target);
  showEstimate(target);
  showTail(target);
  showTruth(target);
  best_ = bestParticleOf(target.estimate);
  showBest();
}

void TargetActors::setBestShown(bool shown) {
  bestShown_ = shown;
  showBest();
}

void TargetActors::showBest() {
  bestMark_->SetVisibility(bestShown_ && best_ && best_->allFinite());
}

void TargetActors::showParticles(const TargetSnapshot& target) {
  const Eigen::ArrayXXd& rows = target.particles;
  // The hull says it better than the points it is made of.
  const bool shown = rows.cols() >= 3 && target.shape == nullptr;
  const Eigen::Index count = shown ? rows.rows() : 0;
  const Eigen::Index stride = count / (kMostParticles + 1) + 1;
  const bool weighted = target.weights.size() == count;
  double largest = 0.0;
  for (Eigen::Index i = 0; weighted && i < count; ++i) {
    largest = std::isfinite(target.weights[i]) ? std::max(largest, target.weights[i]) : largest;
  }
  positions_->SetNumberOfTuples((count + stride - 1) / stride);
  brightness_.clear();
  vtkIdType used = 0;
  for (Eigen::Index i = 0; i < count; i += stride) {
    const Eigen::Vector3f point(rows.row(i).head(3).cast<float>().transpose());
    if (!point.allFinite()) {
      continue;
    }
    positions_->SetTypedTuple(used++, point.data());
    const double share = weighted && largest > 0.0 ? target.weights[i] / largest : 1.0;
    // The root lifts the many faint ones into sight.
    brightness_.push_back(std::isfinite(share) ? static_cast<float>(std::sqrt(std::max(0.0, share)))
                                               : 0.0F);
  }
  positions_->SetNumberOfTuples(used);
  colorParticles();
  positions_->Modified();
  points_->Modified();
  cloudData_->Modified();
  cloud_->SetVisibility(used > 0);
}

void TargetActors::colorParticles() {
  const SceneColor faint = mix(palette_.floor, color_, 0.45);
  const SceneColor strong = mix(color_, palette_.truth, 0.12);
  colors_->SetNumberOfTuples(static_cast<vtkIdType>(brightness_.size()));
  for (std::size_t i = 0; i < brightness_.size(); ++i) {
    const auto rgb = bytes(mix(faint, strong, std::clamp<double>(brightness_[i], 0.0, 1.0)));
    colors_->SetTypedTuple(static_cast<vtkIdType>(i), rgb.data());
  }
  colors_->Modified();
}

void TargetActors::showEstimate(const TargetSnapshot& target) {
  const auto position = positionOf(target.estimate);
  const bool known = position && position->mean.allFinite() &&
                     particleCountOf(target.estimate) > 0 && target.shape == nullptr;
  const bool held = isHeld(target.estimate);
  sphere_->SetVisibility(known);
  const bool isBall = !extentOf(target.estimate);
  halo_->SetVisibility(known && held && isBall);
  cloudReach_ = 0.0;
  plumb_->SetVisibility(known);
  ellipsoid_->VisibilityOff();
  rings_->VisibilityOff();
  if (!known) {
    return;
  }
  mean_ = position->mean;
  showBody(target);
  // Not held: a ghost only.
  const double opacity = isBall ? 1.0 : kBodyOpacity;
  sphere_->GetProperty()->SetOpacity(held ? opacity : 0.35 * opacity);
  Strokes plumb;
  plumb.line(mean_, {mean_.x(), mean_.y(), 0.0});
  plumb.writeTo(plumbData_);
  showEllipsoid(position->covariance);
}

void TargetActors::showBody(const TargetSnapshot& target) {
  radius_ = std::isfinite(target.target.radius) ? std::max(0.0, target.target.radius) : 0.0;
  semiAxes_.setConstant(radius_);
  Eigen::Matrix3d directions = Eigen::Matrix3d::Identity();
  if (const auto extent = extentOf(target.estimate)) {
    if (const auto axes = axesOf(*extent)) {
      semiAxes_ = axes->values.cwiseMax(1e-8).cwiseSqrt();
      directions = axes->directions;
      radius_ = semiAxes_.maxCoeff();
    }
  }
  turn(sphere_, directions);
  turn(halo_, directions);
}

void TargetActors::showEllipsoid(const Eigen::Matrix3d& covariance) {
  const auto axes = axesOf(covariance);
  if (!axes) {
    return;
  }
  const Eigen::Matrix3d& directions = axes->directions;
  const Eigen::Vector3d semiAxes =
      (axes->values * kChiSquared95).cwiseMax(1e-12).cwiseSqrt().cwiseMax(1e-4);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      ellipsoidPose_->SetElement(row, column, directions(row, column) * semiAxes[column]);
    }
    ellipsoidPose_->SetElement(row, 3, mean_[row]);
  }
  ellipsoidPose_->Modified();
  cloudReach_ = semiAxes.maxCoeff();
  ellipsoid_->VisibilityOn();
  rings_->VisibilityOn();
}

void TargetActors::showTail(const TargetSnapshot& target) {
  vtkNew<vtkUnsignedCharArray> fade;
  fade->SetNumberOfComponents(4);
  const auto rgb = bytes(color_);
  Strokes strokes;
  bool any = false;
  // One stroke for each stretch in which the target was held: nothing is known of what is between.
  for (auto begin = target.tail.begin(); begin != target.tail.end();) {
    const auto end = std::find_if_not(begin, target.tail.end(), isFinite);
    if (end - begin > 1) {
      strokes.polyline({begin, end});
      any = true;
      for (auto point = begin; point != end; ++point) {
        const double age = static_cast<double>(target.tail.end() - point - 1) /
                           static_cast<double>(target.tail.size());
        const std::array<unsigned char, 4> rgba{
            rgb[0], rgb[1], rgb[2], static_cast<unsigned char>(255.0 * (1.0 - 0.85 * age))};
        fade->InsertNextTypedTuple(rgba.data());
      }
    }
    begin = std::find_if(end, target.tail.end(), isFinite);
  }
  strokes.writeTo(tailData_);
  tailData_->GetPointData()->SetScalars(any ? fade.Get() : nullptr);
  tail_->SetVisibility(any);
}

void TargetActors::showTruth(const TargetSnapshot& target) {
  const bool known = target.truth && target.truth->allFinite();
  truthMark_->SetVisibility(known);
  if (known) {
    truth_ = *target.truth;
  }
}

void TargetActors::setPalette(const ScenePalette& palette) {
  palette_ = palette;
  const double opacity = sphere_->GetProperty()->GetOpacity();
  paint(sphere_, color_, opacity);
  paint(halo_, palette.floor);
  paint(ellipsoid_, color_, 0.13);
  paint(rings_, mix(color_, palette.truth, 0.1), 0.55);
  paint(plumb_, mix(color_, palette.floor, 0.35), 0.8);
  paint(truthMark_, palette.truth);
  paint(bestMark_, mix(color_, palette.truth, 0.2));
  person_.setColor(color_, palette);
  colorParticles();
}

/// Cross hairs about the true position that leave the middle open for the estimate.
void TargetActors::drawTruth(const ScreenScale& scale) {
  if (truthMark_->GetVisibility() == 0) {
    return;
  }
  const double inner =
      std::max(scale.meters(truth_, kSmallestSpherePx), radius_) + scale.meters(truth_, 1.0);
  const double outer = inner + scale.meters(truth_, 7.0);
  const double nearer = 1.5 * cloudReach_ + 3.0 * outer;
  Strokes hairs;
  for (int axis = 0; axis < 3; ++axis) {
    // Along the line of sight a hair would be a dot on the estimate.
    if (std::abs(scale.direction[axis]) > 0.97) {
      continue;
    }
    for (const double sign : {-1.0, 1.0}) {
      const Eigen::Vector3d arm = Eigen::Vector3d::Unit(axis) * sign;
      hairs.line(scale.nearer(truth_ + arm * inner, nearer),
                 scale.nearer(truth_ + arm * outer, nearer));
    }
  }
  hairs.writeTo(truthData_);
}

/// A triangle in the plane of the picture, as in the images of the cameras.
void TargetActors::drawBest(const ScreenScale& scale) {
  if (bestMark_->GetVisibility() == 0) {
    return;
  }
  const double pixel = scale.meters(*best_, 1.0);
  const double nearer = 1.5 * cloudReach_ + 3.0 * (radius_ + 8.0 * pixel);
  std::vector<Eigen::Vector3d> corners;
  for (const auto& [right, up] : {std::pair{0.0, 8.0}, {7.0, -4.5}, {-7.0, -4.5}, {0.0, 8.0}}) {
    const Eigen::Vector3d corner = *best_ + pixel * (right * scale.right + up * scale.up);
    corners.push_back(scale.nearer(corner, nearer));
  }
  Strokes triangle;
  triangle.polyline(corners);
  triangle.writeTo(bestData_);
}

void TargetActors::prepareFrame(const ScreenScale& scale) {
  // Estimate and truth are drawn before their own cloud, which would bury them.
  const double radius = std::max(radius_, scale.meters(mean_, kSmallestSpherePx));
  const double nearer = 1.5 * cloudReach_ + radius;
  const Eigen::Vector3d place = scale.nearer(mean_, nearer);
  sphere_->SetPosition(place.x(), place.y(), place.z());
  const double smallest = scale.meters(mean_, kSmallestSpherePx);
  const auto scaled = [&](double more, double factor) {
    return Eigen::Vector3d(factor * (semiAxes_.array().max(smallest) + more));
  };
  sphere_->SetScale(scaled(0.0, scale.nearerFactor(mean_, nearer)).data());
  const double haloNearer = nearer - 0.7 * radius;
  const Eigen::Vector3d behind = scale.nearer(mean_, haloNearer);
  halo_->SetPosition(behind.x(), behind.y(), behind.z());
  halo_->SetScale(scaled(scale.meters(mean_, 1.5), scale.nearerFactor(mean_, haloNearer)).data());
  const double dot = scale.meters(mean_, kParticlePx);
  // A new scale makes the mapper upload all points again: only when it shows.
  if (std::abs(dot - cloudMapper_->GetScaleFactor()) > 0.1 * dot) {
    cloudMapper_->SetScaleFactor(dot);
  }
  drawTruth(scale);
  drawBest(scale);
  const auto width = [&](double pixels) { return static_cast<float>(pixels * scale.pixelRatio); };
  person_.prepareFrame(scale);
  tail_->GetProperty()->SetLineWidth(width(2.5));
  rings_->GetProperty()->SetLineWidth(width(1.0));
  plumb_->GetProperty()->SetLineWidth(width(1.0));
  truthMark_->GetProperty()->SetLineWidth(width(1.6));
  bestMark_->GetProperty()->SetLineWidth(width(1.6));
}

} // namespace dewpoint::ui
