// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/particle_cloud.h"

#include <vtkPointData.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::ui {
namespace {

constexpr double kParticlePx = 2.2; ///< radius
constexpr Eigen::Index kMostParticles = 20000;

/// A disc with a soft rim instead of VTK's Gaussian, whose wide skirt costs software OpenGL dearly.
constexpr const char* kDiscShader =
    "//VTK::Color::Impl\n"
    "float dist2 = dot(offsetVCVSOutput.xy, offsetVCVSOutput.xy);\n"
    "if (dist2 > 1.0) { discard; }\n"
    "opacity = 0.85 * opacity * (1.0 - smoothstep(0.5, 1.0, dist2));\n";

} // namespace

ParticleCloud::ParticleCloud(vtkRenderer* renderer) : renderer_(renderer) {
  positions_->SetNumberOfComponents(3);
  colors_->SetNumberOfComponents(3);
  points_->SetData(positions_);
  data_->SetPoints(points_);
  data_->GetPointData()->SetScalars(colors_);
  mapper_->SetInputData(data_);
  mapper_->EmissiveOff();
  mapper_->SetSplatShaderCode(kDiscShader);
  mapper_->SetTriangleScale(2.0F); // the triangle around the unit disc
  actor_->SetMapper(mapper_);
  actor_->ForceTranslucentOn(); // in its turn, and without hiding what is behind a soft rim
  actor_->PickableOff();
  actor_->VisibilityOff();
  addNewProp(renderer_, actor_);
}

ParticleCloud::~ParticleCloud() {
  renderer_->RemoveActor(actor_);
}

void ParticleCloud::show(const Eigen::ArrayXXd& rows, const Eigen::ArrayXd& weights) {
  const Eigen::Index count = rows.cols() >= 3 ? rows.rows() : 0;
  const Eigen::Index stride = count / (kMostParticles + 1) + 1;
  const bool weighted = weights.size() == count;
  double largest = 0.0;
  for (Eigen::Index i = 0; weighted && i < count; ++i) {
    largest = std::isfinite(weights[i]) ? std::max(largest, weights[i]) : largest;
  }
  std::vector<std::pair<float, Eigen::Vector3f>> drawn;
  drawn.reserve(static_cast<std::size_t>((count + stride - 1) / stride));
  for (Eigen::Index i = 0; i < count; i += stride) {
    const Eigen::Vector3f point(rows.row(i).head(3).cast<float>().transpose());
    if (!point.allFinite()) {
      continue;
    }
    const double share = weighted && largest > 0.0 ? weights[i] / largest : 1.0;
    // The root lifts the many faint ones into sight.
    drawn.emplace_back(
        std::isfinite(share) ? static_cast<float>(std::sqrt(std::max(0.0, share))) : 0.0F, point);
  }
  std::ranges::stable_sort(drawn, {}, &std::pair<float, Eigen::Vector3f>::first);
  positions_->SetNumberOfTuples(static_cast<vtkIdType>(drawn.size()));
  brightness_.clear();
  for (const auto& [brightness, point] : drawn) {
    positions_->SetTypedTuple(static_cast<vtkIdType>(brightness_.size()), point.data());
    brightness_.push_back(brightness);
  }
  colorParticles();
  positions_->Modified();
  points_->Modified();
  data_->Modified();
  actor_->SetVisibility(!drawn.empty());
}

void ParticleCloud::setColors(const SceneColor& unlikely, const SceneColor& likely) {
  if (unlikely != unlikely_ || likely != likely_) {
    unlikely_ = unlikely;
    likely_ = likely;
    colorParticles();
  }
}

void ParticleCloud::colorParticles() {
  colors_->SetNumberOfTuples(static_cast<vtkIdType>(brightness_.size()));
  for (std::size_t i = 0; i < brightness_.size(); ++i) {
    const auto rgb =
        colorBytes(mix(unlikely_, likely_, std::clamp<double>(brightness_[i], 0.0, 1.0)));
    colors_->SetTypedTuple(static_cast<vtkIdType>(i), rgb.data());
  }
  colors_->Modified();
}

void ParticleCloud::prepareRendering(const ScreenScale& scale, const Eigen::Vector3d& about) {
  const double dot = scale.lengthInMeters(about, kParticlePx);
  // A new scale makes the mapper upload all points again: only when it shows.
  if (std::abs(dot - mapper_->GetScaleFactor()) > 0.1 * dot) {
    mapper_->SetScaleFactor(dot);
  }
}

} // namespace dewpoint::ui
