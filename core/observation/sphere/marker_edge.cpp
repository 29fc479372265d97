// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/sphere/marker_edge.h"

#include "core/base/statistics.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace dewpoint::observation {
namespace {

// Origin of the values not recorded.

constexpr int kRounds = 4;           ///< searches for edges about the outline found so far
constexpr double kWidestPx = 1.6;    ///< pixels from the outline within which edges are searched
constexpr double kWidestShare = 0.4; ///< radii, likewise
constexpr double kBandPx = 1.0;      ///< pixels, width of the bands that show the unmixed colors
constexpr double kFineStepPx = 0.25; ///< pixels between two samples of a spoke
constexpr double kLeastAngle = 0.12; ///< sine of the angle between both colors
constexpr double kLeastAgreeingShare = 0.6; ///< of the spokes that must agree
constexpr double kLargestSpread = 0.6;      ///< pixels: of the edges about the ellipse
constexpr double kLeastSpread = 0.05;       ///< pixels: what remains of the raster
constexpr double kTukeyWidth = 4.0;         ///< in spreads

using BgrColor = Eigen::Vector3d;
using Vector5 = Eigen::Matrix<double, 5, 1>;

/// The color between pixels, by bilinear interpolation, at a point inside the image.
BgrColor colorAt(const cv::Mat& bgr, const Eigen::Vector2d& point) {
  const auto column = static_cast<int>(std::floor(point.x()));
  const auto row = static_cast<int>(std::floor(point.y()));
  const double x = point.x() - column;
  const double y = point.y() - row;
  const auto* above = bgr.ptr<cv::Vec3b>(row) + column;
  const auto* below = bgr.ptr<cv::Vec3b>(row + 1) + column;
  BgrColor color;
  for (int i = 0; i < 3; ++i) {
    color[i] = (1.0 - y) * ((1.0 - x) * above[0][i] + x * above[1][i]) +
               y * ((1.0 - x) * below[0][i] + x * below[1][i]);
  }
  return color;
}

/// Where an edge was found.
struct PolarEdge {
  double angle = 0.0;
  double distance = 0.0; ///< from the center, pixels
};

/// The outline in polar form about a center: r = p0 + p1 cos + p2 sin + p3 cos 2 + p4 sin 2.
Vector5 terms(double angle) {
  Vector5 row;
  row << 1.0, std::cos(angle), std::sin(angle), std::cos(2.0 * angle), std::sin(2.0 * angle);
  return row;
}

/// Share of the background in a color that is p * ball + w * background: w, by least squares.
class Unmixing {
public:
  Unmixing(const BgrColor& ball, const BgrColor& background) {
    const double bb = ball.squaredNorm();
    const double gg = background.squaredNorm();
    const double bg = ball.dot(background);
    const double determinant = bb * gg - bg * bg;
    usable_ = determinant > kLeastAngle * kLeastAngle * bb * gg;
    if (usable_) {
      row_ = (bb * background - bg * ball) / determinant;
    }
  }
  bool usable() const { return usable_; }
  double operator()(const BgrColor& color) const { return std::clamp(row_.dot(color), -0.3, 1.3); }

private:
  bool usable_ = false;
  BgrColor row_ = BgrColor::Zero();
};

/// The edge on one spoke within `reach` of the expected distance.
std::optional<PolarEdge> edgeOn(const cv::Mat& bgr, const Eigen::Vector2d& center, double angle,
                                double expected, double reach) {
  const Eigen::Vector2d way(std::cos(angle), std::sin(angle));
  const auto bandColor = [&](double from) {
    BgrColor sum = BgrColor::Zero();
    int count = 0;
    for (double s = from; s <= from + kBandPx + 1e-9; s += 0.5 * kBandPx, ++count) {
      sum += colorAt(bgr, center + s * way);
    }
    return BgrColor(sum / count);
  };
  const double inner = expected - reach;
  const Unmixing background(bandColor(std::max(inner - kBandPx, 0.0)), bandColor(expected + reach));
  if (!background.usable()) {
    return std::nullopt;
  }
  const int steps = std::max(1, static_cast<int>(std::lround(2.0 * reach / kFineStepPx)));
  const double step = 2.0 * reach / steps;
  double covered = 0.0;
  for (int k = 0; k < steps; ++k) {
    covered += step * (1.0 - background(colorAt(bgr, center + (inner + (k + 0.5) * step) * way)));
  }
  return PolarEdge{angle, inner + covered};
}

struct PolarFit {
  Vector5 shape = Vector5::Zero();
  double spread = 0.0; ///< standard deviation of the edges, pixels
  double agreeing = 0.0;
  double middleVariance = 0.0;
};

/// Robust least squares (Tukey's weights about the median spread).
std::optional<PolarFit> fitPolar(const std::vector<PolarEdge>& edges) {
  PolarFit fit;
  std::vector<double> sorted;
  sorted.reserve(edges.size());
  for (const PolarEdge& edge : edges) {
    sorted.push_back(edge.distance);
  }
  fit.shape[0] = upperMedianInPlace(sorted);
  std::vector<double> off(edges.size());
  for (int round = 0; round < 6; ++round) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      off[i] = edges[i].distance - fit.shape.dot(terms(edges[i].angle));
      sorted[i] = std::abs(off[i]);
    }
    fit.spread = std::max(kLeastSpread, 1.48 * upperMedianInPlace(sorted));
    Eigen::Matrix<double, 5, 5> matrix = Eigen::Matrix<double, 5, 5>::Zero();
    Vector5 vector = Vector5::Zero();
    fit.agreeing = 0.0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const double ratio = off[i] / (kTukeyWidth * fit.spread);
      const double weight = std::abs(ratio) < 1.0 ? (1 - ratio * ratio) * (1 - ratio * ratio) : 0.0;
      const Vector5 row = terms(edges[i].angle);
      matrix += weight * row * row.transpose();
      vector += weight * off[i] * row;
      fit.agreeing += weight > 0.0 ? 1.0 : 0.0;
    }
    const Eigen::LDLT<Eigen::Matrix<double, 5, 5>> solver(matrix);
    if (solver.info() != Eigen::Success || !solver.isPositive()) {
      return std::nullopt;
    }
    fit.shape += solver.solve(vector);
    const Eigen::Matrix<double, 5, 5> inverse =
        solver.solve(Eigen::Matrix<double, 5, 5>::Identity());
    fit.middleVariance = 0.5 * (inverse(1, 1) + inverse(2, 2));
  }
  if (!fit.shape.allFinite() || !std::isfinite(fit.middleVariance)) {
    return std::nullopt;
  }
  return fit;
}

} // namespace

std::optional<MarkerImage> fitBallEdge(const cv::Mat& bgr, const SphereImage& initial) {
  Eigen::Vector2d center = initial.center;
  Vector5 shape = Vector5::Zero();
  shape[0] = initial.radius;
  const int spokes = std::clamp(static_cast<int>(2.0 * std::numbers::pi * initial.radius), 24, 96);
  PolarFit fit;
  for (int round = 0; round < kRounds; ++round) {
    const double reach = std::min(kWidestPx, kWidestShare * shape[0]);
    const double outer = shape[0] * 1.5 + reach + kBandPx + 2.0;
    if (!center.allFinite() || center.x() < outer || center.y() < outer ||
        center.x() > bgr.cols - 1 - outer || center.y() > bgr.rows - 1 - outer) {
      return std::nullopt;
    }
    std::vector<PolarEdge> edges;
    for (int k = 0; k < spokes; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / spokes;
      const double expected = std::clamp(shape.dot(terms(angle)), 0.6 * shape[0], 1.5 * shape[0]);
      if (const auto edge = edgeOn(bgr, center, angle, expected, reach)) {
        edges.push_back(*edge);
      }
    }
    const double enough = kLeastAgreeingShare * spokes;
    if (static_cast<double>(edges.size()) < enough) {
      return std::nullopt;
    }
    const auto found = fitPolar(edges);
    if (!found || found->agreeing < enough || found->spread > kLargestSpread ||
        std::abs(found->shape[0] - initial.radius) > 0.4 * initial.radius) {
      return std::nullopt;
    }
    fit = *found;
    center += fit.shape.segment<2>(1);
    shape = fit.shape;
    shape.segment<2>(1).setZero();
  }
  if ((center - initial.center).norm() > std::max(1.5, 0.25 * initial.radius)) {
    return std::nullopt;
  }
  MarkerImage ball;
  ball.outline.center = center;
  ball.outline.radius = shape[0];
  // Neighboring spokes see the same pixels: about two of them are one measurement.
  ball.sigma = std::max(0.02, fit.spread * std::sqrt(2.0 * fit.middleVariance));
  return ball;
}

} // namespace dewpoint::observation
