// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/sphere/sphere_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace dewpoint::observation {
namespace {

// Reasons: docs/method-dewpoint.md, section 4; those without a derivation are judgments.

constexpr int kSpokes = 12;
constexpr double kInner = 0.45; ///< radii from the center, samples well inside
constexpr double kEdge = 0.80;  ///< radii from the center, samples near the edge
constexpr double kRing = 1.25;  ///< radii from the center, samples in the ring

// Log likelihood ratios "target here" against "not here" of what a sample shows. A matching sample
// inside: 0.9 against 0.01 (stray pixels of the color). One that does not match although nothing
// new is there: 0.01 against 0.97. In the ring, given a match inside: clean 0.96 against 0.3;
// matching as well, a larger object of the color: as bad as a miss, so that a few such samples are
// outvoted, while a whole ring takes away all that the inside says.
constexpr double kInsideMatch = 4.5;
constexpr double kInsideMiss = -4.5;
constexpr double kRingClean = 1.2;
constexpr double kRingMatch = -9.0;
/// Share, 0 to 1, at which the sum of an image's samples counts: they are far from independent.
constexpr double kSampleCorrelationFactor = 0.12;
/// Pixels; smaller outlines count less, since their samples fall on the same pixels.
constexpr double kFullArea = 60.0;
/// Spokes that nothing may hide, to show where a target ends.
constexpr int kFewestShown = kSpokes / 3;

struct Spoke {
  double x;
  double y;
};

const std::array<Spoke, kSpokes>& spokes() {
  static const auto table = [] {
    std::array<Spoke, kSpokes> all{};
    for (int k = 0; k < kSpokes; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / kSpokes;
      all[static_cast<std::size_t>(k)] = {std::cos(angle), std::sin(angle)};
    }
    return all;
  }();
  return table;
}

// Tables: which label comes next cannot be foreseen by a processor that has to branch on it.
constexpr auto kInsideOf = [] {
  std::array<double, kPixelLabelCount> values{};
  values[std::size_t(PixelLabel::Target)] = kInsideMatch;
  values[std::size_t(PixelLabel::Background)] = kInsideMiss;
  values[std::size_t(PixelLabel::Unlearned)] = kInsideMiss;
  return values;
}();

/// By the label outside, given a match at the edge; without one the ring says nothing.
constexpr auto kRingOf = [] {
  std::array<std::array<double, kPixelLabelCount>, kPixelLabelCount> values{};
  auto& matchingEdge = values[std::size_t(PixelLabel::Target)];
  matchingEdge.fill(kRingClean);
  matchingEdge[std::size_t(PixelLabel::Target)] = kRingMatch;
  matchingEdge[std::size_t(PixelLabel::Explained)] = 0.0;
  return values;
}();

double inside(PixelLabel label) {
  return kInsideOf[std::size_t(label)];
}

double ring(PixelLabel edge, PixelLabel outer) {
  return kRingOf[std::size_t(edge)][std::size_t(outer)];
}

/// Reads labels around a center; whether all of them are covered is found out once.
class Sampler {
public:
  Sampler(const LabelImage& labels, const SphereImage& outline)
      : labels_(labels), outline_(outline) {
    const cv::Rect area = areaOf(outline, SphereEvidence::kSampleReach);
    inside_ = (area & labels.labeledArea()) == area;
    data_ = labels.labels().ptr<std::uint8_t>();
    stride_ = static_cast<std::ptrdiff_t>(labels.labels().step[0]);
  }

  PixelLabel at(const Spoke& spoke, double radii) const {
    const double reach = radii * outline_.radius;
    const double x = outline_.center.x() + reach * spoke.x + 0.5;
    const double y = outline_.center.y() + reach * spoke.y + 0.5;
    if (inside_) { // so both are positive, and truncation is the floor
      const auto column = static_cast<std::ptrdiff_t>(x);
      const auto row = static_cast<std::ptrdiff_t>(y);
      return static_cast<PixelLabel>(data_[row * stride_ + column]);
    }
    return labels_.at(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)));
  }

private:
  const LabelImage& labels_;
  const SphereImage& outline_;
  bool inside_ = false;
  const std::uint8_t* data_ = nullptr;
  std::ptrdiff_t stride_ = 0;
};

} // namespace

cv::Rect areaOf(const SphereImage& outline, double radii, double margin) {
  const double reach = radii * outline.radius + margin;
  // Kept within what integers hold: a sphere near the camera's plane projects far away.
  const auto bounded = [](double value) { return static_cast<int>(std::clamp(value, -1e8, 1e8)); };
  const int left = bounded(std::floor(outline.center.x() - reach));
  const int top = bounded(std::floor(outline.center.y() - reach));
  return {left, top, bounded(std::ceil(outline.center.x() + reach)) - left + 1,
          bounded(std::ceil(outline.center.y() + reach)) - top + 1};
}

double SphereEvidence::maxLogLikelihoodRatio() {
  return kSampleCorrelationFactor * (kInsideMatch * (2 * kSpokes + 1) + kRingClean * kSpokes);
}

double SphereEvidence::logLikelihoodRatio(const LabelImage& labels, const SphereImage& outline) {
  const Sampler sampler(labels, outline);
  double sum = inside(sampler.at({0.0, 0.0}, 0.0));
  for (const Spoke& spoke : spokes()) {
    const PixelLabel edge = sampler.at(spoke, kEdge);
    sum += inside(sampler.at(spoke, kInner)) + inside(edge) + ring(edge, sampler.at(spoke, kRing));
  }
  const double area = std::numbers::pi * outline.radius * outline.radius;
  return kSampleCorrelationFactor * std::min(1.0, area / kFullArea) * sum;
}

double SphereEvidence::explainedRingGain(const LabelImage& labels, const SphereImage& outline,
                                         const std::vector<SphereImage>& others) {
  const Sampler sampler(labels, outline);
  int explained = 0;
  for (const Spoke& spoke : spokes()) {
    const Eigen::Vector2d sample =
        outline.center + kRing * outline.radius * Eigen::Vector2d(spoke.x, spoke.y);
    const bool covered = std::any_of(others.begin(), others.end(), [&](const SphereImage& other) {
      return (sample - other.center).norm() <= SphereEvidence::kOutlineMargin * other.radius + 1.0;
    });
    explained += covered && sampler.at(spoke, kEdge) == PixelLabel::Target &&
                         sampler.at(spoke, kRing) == PixelLabel::Target
                     ? 1
                     : 0;
  }
  const double area = std::numbers::pi * outline.radius * outline.radius;
  return -kSampleCorrelationFactor * std::min(1.0, area / kFullArea) * kRingMatch * explained;
}

double SphereEvidence::rimShare(const LabelImage& labels, const SphereImage& outline) {
  const Sampler sampler(labels, outline);
  int shown = 0;
  int ends = 0;
  for (const Spoke& spoke : spokes()) {
    const PixelLabel edge = sampler.at(spoke, kEdge);
    const PixelLabel outer = sampler.at(spoke, kRing);
    shown += edge != PixelLabel::Unknown ? 1 : 0;
    ends +=
        edge == PixelLabel::Target && outer != PixelLabel::Target && outer != PixelLabel::Explained
            ? 1
            : 0;
  }
  return shown >= kFewestShown ? static_cast<double>(ends) / shown : 0.0;
}

double SphereEvidence::matchShare(const LabelImage& labels, const SphereImage& outline) {
  const Sampler sampler(labels, outline);
  int matching = sampler.at({0.0, 0.0}, 0.0) == PixelLabel::Target ? 1 : 0;
  for (const Spoke& spoke : spokes()) {
    matching += sampler.at(spoke, kInner) == PixelLabel::Target ? 1 : 0;
    matching += sampler.at(spoke, kEdge) == PixelLabel::Target ? 1 : 0;
  }
  return static_cast<double>(matching) / (2 * kSpokes + 1);
}

} // namespace dewpoint::observation
