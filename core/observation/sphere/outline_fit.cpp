// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/sphere/outline_fit.h"

#include "core/observation/sphere/sphere_evidence.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace dewpoint::observation {
namespace {

// Reasons: docs/method-dewpoint.md, section 3; those without a derivation are judgments.

constexpr std::size_t kMostSpokes = 32; ///< per camera
constexpr double kSearchRadii = 1.7;    ///< radii, length of a spoke on which edges are searched
constexpr double kStepPx = 0.5;         ///< pixels between two samples of a spoke
/// Radii by which edges may be off the expected outline, one iteration after the other.
constexpr std::array<double, 5> kFarWidths{1.2, 0.8, 0.45, 0.3, 0.25};
constexpr std::array<double, 5> kNearWidths{0.5, 0.35, 0.25, 0.25, 0.25};
constexpr int kFewestEdges = 6; ///< of one camera that together make a fit
/// Standard deviation of one edge, pixels: the pixel raster and a rough color boundary.
constexpr double kEdgeSigmaPx = 0.45;
/// Standard deviation of the common offset of all edges of a camera: pixels, and radii.
constexpr double kOffsetPx = 0.3;
constexpr double kOffsetShare = 0.02;
/// What is added to a camera's own information before it is inverted, as a share of it: depth.
constexpr double kLeastOwnShare = 1e-4;
constexpr double kJacobianStep = 1e-4; ///< meters
constexpr double kGoodEnough =
    2e-5; ///< meters, last step of an iteration: a fiftieth of a pixel of a usual camera

using Matrix4 = Eigen::Matrix4d;
using Vector4 = Eigen::Vector4d;

/// An edge of the color along a spoke.
struct Edge {
  Eigen::Vector2d direction;
  double distance; ///< from the outline's center, pixels
  double weight;   ///< trust beforehand, 0 to 1
};

/// Directions of the spokes, evenly around.
const std::array<Eigen::Vector2d, kMostSpokes>& spokeDirections() {
  static const auto table = [] {
    std::array<Eigen::Vector2d, kMostSpokes> all;
    for (std::size_t k = 0; k < kMostSpokes; ++k) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / kMostSpokes;
      all[k] = {std::cos(angle), std::sin(angle)};
    }
    return all;
  }();
  return table;
}

/// The distance at which the color ends along a spoke, nearest to the expected radius and between
/// `from` and `until`; nothing where it does not.
std::optional<Edge> findEdge(const LabelImage& labels, bool covered, const SphereImage& outline,
                             const Eigen::Vector2d& direction, double from, double until) {
  std::optional<Edge> best;
  double lastMatch = -1.0;
  double firstMiss = -1.0;
  PixelLabel missed = PixelLabel::Unlearned;
  int misses = 2;
  // Half a pixel more: truncation then rounds to the nearest.
  double x = outline.center.x() + from * direction.x() + 0.5;
  double y = outline.center.y() + from * direction.y() + 0.5;
  const double stepX = kStepPx * direction.x();
  const double stepY = kStepPx * direction.y();
  const cv::Mat& map = labels.labels();
  for (double s = from; s <= until; s += kStepPx, x += stepX, y += stepY) {
    const PixelLabel label =
        covered ? static_cast<PixelLabel>(
                      map.ptr<std::uint8_t>(static_cast<int>(y))[static_cast<int>(x)])
                : labels.at(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)));
    if (label == PixelLabel::Target) {
      lastMatch = s;
      misses = 0;
      continue;
    }
    if (++misses == 1) {
      firstMiss = s;
      missed = label;
    }
    // One odd sample is noise, a run of them an edge.
    if (misses == 3 && lastMatch >= 0.0 && missed != PixelLabel::Explained) {
      const double distance = 0.5 * (lastMatch + firstMiss);
      const double off = std::abs(distance - outline.radius);
      if (best && off >= std::abs(best->distance - outline.radius)) {
        break; // farther out it only gets worse
      }
      // Where something new begins, it may be what hides the target that makes the edge.
      best = Edge{direction, distance, missed == PixelLabel::Unknown ? 0.5 : 1.0};
    }
  }
  return best;
}

/// Edges within `width` radii of the expected outline.
std::vector<Edge> findEdges(LabelImage& labels, const SphereImage& outline, double width) {
  const double margin = std::min(width, 1.0) * outline.radius + 3.0;
  const double from = std::max(0.0, outline.radius - margin);
  const double until = std::min(outline.radius + margin, kSearchRadii * outline.radius + 3.0);
  const cv::Rect area = areaOf(outline, kSearchRadii, 5.0);
  labels.ensureLabels(area);
  const bool covered = (area & labels.labeledArea()) == area;
  // A spoke for every three pixels of the outline.
  const int every = outline.radius < 9.0 ? 2 : 1;
  std::vector<Edge> edges;
  edges.reserve(kMostSpokes);
  for (std::size_t k = 0; k < kMostSpokes; k += static_cast<std::size_t>(every)) {
    if (const auto edge = findEdge(labels, covered, outline, spokeDirections()[k], from, until)) {
      edges.push_back(*edge);
    }
  }
  return edges;
}

double tukey(double residual, double width) {
  const double ratio = residual / width;
  const double inside = 1.0 - ratio * ratio;
  return inside > 0.0 ? inside * inside : 0.0;
}

/// Change of the outline (column, row, radius) with the center (3 columns) and log radius.
Eigen::Matrix<double, 3, 4> jacobian(const SphereProjector& projector,
                                     const Eigen::Vector3d& center, double radius,
                                     const SphereImage& outline) {
  Eigen::Matrix<double, 3, 4> j = Eigen::Matrix<double, 3, 4>::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::Vector3d moved = center;
    moved[axis] += kJacobianStep;
    if (const auto image = projector.project(moved, radius)) {
      j.block<2, 1>(0, axis) = (image->center - outline.center) / kJacobianStep;
      j(2, axis) = (image->radius - outline.radius) / kJacobianStep;
    }
  }
  j(2, 3) = outline.radius;
  return j;
}

/// Normal equations of one camera at the present guess, its common edge offset eliminated.
struct CameraEquations {
  Matrix4 matrix = Matrix4::Zero();
  Vector4 vector = Vector4::Zero();
  int edges = 0;
  double sizeDeviation = 0.0;
};

CameraEquations equationsOf(const OutlineView& view, const Eigen::Vector3d& center, double radius,
                            double width) {
  CameraEquations result;
  const Eigen::Vector3d here = center + view.offset;
  const auto outline = view.projector->project(here, radius);
  if (!outline || outline->radius < 0.5 || outline->radius > 2000.0) {
    return result;
  }
  const auto edges = findEdges(*view.labels, *outline, width);
  const auto j = jacobian(*view.projector, here, radius, *outline);
  const double offsetSigma = kOffsetPx + kOffsetShare * outline->radius;
  const double tukeyWidth = std::max(width * outline->radius, 2.5);
  const double information = 1.0 / (kEdgeSigmaPx * kEdgeSigmaPx);
  Vector4 cross = Vector4::Zero();
  double offsetInformation = 1.0 / (offsetSigma * offsetSigma);
  double offsetVector = 0.0;
  for (const Edge& edge : edges) {
    const double residual = edge.distance - outline->radius;
    const double weight = edge.weight * tukey(residual, tukeyWidth) * information;
    if (weight <= 0.0) {
      continue;
    }
    Vector4 row = (edge.direction.transpose() * j.topRows<2>()).transpose();
    row += j.row(2).transpose();
    result.matrix += weight * row * row.transpose();
    result.vector += weight * residual * row;
    cross += weight * row;
    offsetInformation += weight;
    offsetVector += weight * residual;
    ++result.edges;
  }
  result.matrix -= cross * cross.transpose() / offsetInformation;
  const double offset = offsetVector / offsetInformation;
  result.vector -= cross * offset;
  result.sizeDeviation = offset * offset / (offsetSigma * offsetSigma);
  return result;
}

/// Fills in how much the cameras disagree after the last step, and which way each one pulls.
void compareCameras(const std::vector<CameraEquations>& cameras, const Vector4& step,
                    OutlineFit& fit) {
  int seeing = 0;
  double sum = 0.0;
  fit.cameraInformation.assign(cameras.size(), {});
  for (std::size_t k = 0; k < cameras.size(); ++k) {
    const CameraEquations& camera = cameras[k];
    if (camera.edges < kFewestEdges) {
      continue;
    }
    ++seeing;
    fit.sizeDeviation += camera.sizeDeviation;
    const Eigen::Vector3d left = (camera.vector - camera.matrix * step).head<3>();
    Eigen::Matrix3d own = camera.matrix.topLeftCorner<3, 3>();
    fit.cameraInformation[k] = {own, left};
    own.diagonal().array() += kLeastOwnShare * own.trace();
    sum += left.dot(own.inverse() * left);
  }
  if (seeing > 1) {
    fit.disagreement = sum;
    fit.degreesOfFreedom = 2 * seeing - 3; // a column and a row each, against one position
  }
}

} // namespace

OutlineFit fitOutline(const std::vector<OutlineView>& views, const OutlinePrior& prior,
                      EdgeSearchRange reach) {
  OutlineFit fit;
  fit.center = prior.center;
  fit.radius = prior.radius;
  Matrix4 total = Matrix4::Zero();
  Vector4 step = Vector4::Zero();
  std::vector<CameraEquations> cameras(views.size());
  for (const double width : reach == EdgeSearchRange::Near ? kNearWidths : kFarWidths) {
    total.setZero();
    total.topLeftCorner<3, 3>() = prior.information;
    Vector4 vector = Vector4::Zero();
    vector.head<3>() = prior.information * (prior.center - fit.center);
    // A known radius: so much information that it does not move.
    const double logRadius = std::log(fit.radius / prior.radius);
    total(3, 3) = 1.0 / std::max(prior.logRadiusVariance, 1e-12);
    vector[3] = -logRadius * total(3, 3);
    fit.edgeCounts.assign(views.size(), 0);
    int most = 0;
    for (std::size_t k = 0; k < views.size(); ++k) {
      if (views[k].labels == nullptr || views[k].labels->empty()) {
        continue;
      }
      cameras[k] = equationsOf(views[k], fit.center, fit.radius, width);
      const CameraEquations& equations = cameras[k];
      total += equations.matrix;
      vector += equations.vector;
      fit.edgeCounts[k] = equations.edges;
      most = std::max(most, equations.edges);
    }
    const Eigen::LDLT<Matrix4> solver(total);
    fit.isFound = most >= kFewestEdges && solver.info() == Eigen::Success && solver.isPositive();
    if (!fit.isFound) {
      return fit;
    }
    step = solver.solve(vector);
    if (!step.allFinite()) {
      fit.isFound = false;
      return fit;
    }
    // A step of more than two radii leaves the region where the edges mean anything.
    const double length = step.head<3>().norm();
    const double longest = 2.0 * fit.radius;
    if (length > longest) {
      step *= longest / length;
    }
    fit.center += step.head<3>();
    if (prior.logRadiusVariance > 0.0) {
      fit.radius *= std::exp(std::clamp(step[3], -0.5, 0.5));
    }
    // Not before the weights are narrow enough to leave out what hides the target.
    if (length < kGoodEnough && width < 0.5) {
      break;
    }
  }
  const Matrix4 covariance = total.inverse();
  fit.covariance = covariance.topLeftCorner<3, 3>();
  fit.logRadiusVariance = prior.logRadiusVariance > 0.0 ? covariance(3, 3) : 0.0;
  fit.isFound = covariance.allFinite();
  compareCameras(cameras, step, fit);
  return fit;
}

} // namespace dewpoint::observation
