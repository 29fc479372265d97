// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/report_drawing.h"

#include "core/base/markup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace dewpoint {
namespace {

constexpr double kDrawingWidth = 460.0;
constexpr double kArrowPart = 0.06; // of the drawing's width: how long a usual arrow is drawn
constexpr double kBarHeight = 12.0;

std::string opened(double width, double height, const char* label) {
  return fmt::format("<svg role=\"img\" aria-label=\"{}\" viewBox=\"0 0 {:.0f} {:.0f}\" "
                     "width=\"{:.0f}\">\n",
                     label, width, height, width);
}

std::string frame(double width, double height) {
  return fmt::format("<rect class=\"frame\" x=\"0.5\" y=\"0.5\" width=\"{:.1f}\" "
                     "height=\"{:.1f}\"/>\n",
                     width - 1.0, height - 1.0);
}

/// 1, 2 or 5 times a power of ten, not above `value`.
double roundBelow(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  const double digits = value / power;
  return power * (digits >= 5.0 ? 5.0 : digits >= 2.0 ? 2.0 : 1.0);
}

/// Length of the residuals that nine of ten corners stay below, pixels.
double usualResidual(const BoardReport::CameraPart& camera) {
  std::vector<double> sizes;
  for (const ViewFit& view : camera.views) {
    for (const Eigen::Vector2d& residual : view.residuals) {
      sizes.push_back(residual.norm());
    }
  }
  std::ranges::sort(sizes);
  return sizes.empty() ? 1.0 : std::max(1e-3, sizes[sizes.size() * 9 / 10]);
}

} // namespace

std::string residualDrawing(const BoardReport::CameraPart& camera) {
  const auto& in = camera.camera.intrinsics;
  const double scale = kDrawingWidth / in.width;
  const double height = in.height * scale;
  const double lengthen = kArrowPart * kDrawingWidth / usualResidual(camera);
  std::string svg =
      opened(kDrawingWidth, height + 22.0, "residuals") + frame(kDrawingWidth, height);
  svg += "<path class=\"arrow\" d=\"";
  auto out = std::back_inserter(svg);
  for (const ViewFit& view : camera.views) {
    for (std::size_t k = 0; view.used && k < view.residuals.size(); ++k) {
      const Eigen::Vector2d from = scale * (view.pixels[k] - view.residuals[k]);
      const Eigen::Vector2d along = lengthen * view.residuals[k];
      const Eigen::Vector2d across(-along.y(), along.x());
      const Eigen::Vector2d left = from + 0.7 * along + 0.15 * across;
      const Eigen::Vector2d right = from + 0.7 * along - 0.15 * across;
      const Eigen::Vector2d tip = from + along;
      fmt::format_to(out, "M{:.1f} {:.1f}L{:.1f} {:.1f}M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}",
                     from.x(), from.y(), tip.x(), tip.y(), left.x(), left.y(), tip.x(), tip.y(),
                     right.x(), right.y());
    }
  }
  const double sample = roundBelow(2.0 * usualResidual(camera));
  fmt::format_to(out,
                 "\"/>\n<path class=\"arrow\" d=\"M4 {0:.1f}h{1:.1f}\"/><text x=\"{2:.1f}\" "
                 "y=\"{3:.1f}\">{4:g} px</text>\n</svg>\n",
                 height + 12.0, sample * lengthen, 10.0 + sample * lengthen, height + 16.0, sample);
  return svg;
}

std::string coverageDrawing(const BoardReport::CameraPart& camera) {
  const auto& in = camera.camera.intrinsics;
  const double width = 0.6 * kDrawingWidth;
  const double height = width * in.height / in.width;
  const double cellWidth = width / BoardCoverage::kColumns;
  const double cellHeight = height / BoardCoverage::kRows;
  const auto& counts = camera.coverage.corners;
  const double most = std::max(1, *std::ranges::max_element(counts));
  std::string svg = opened(kDrawingWidth, height, "coverage");
  auto out = std::back_inserter(svg);
  for (int k = 0; k < static_cast<int>(counts.size()); ++k) {
    const int count = counts[static_cast<std::size_t>(k)];
    const double x = k % BoardCoverage::kColumns * cellWidth;
    const double y = k / BoardCoverage::kColumns * cellHeight; // NOLINT: whole rows
    fmt::format_to(out,
                   "<rect class=\"cell\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
                   "height=\"{:.1f}\" fill-opacity=\"{:.2f}\"/><text x=\"{:.1f}\" y=\"{:.1f}\" "
                   "text-anchor=\"middle\">{}</text>\n",
                   x, y, cellWidth, cellHeight, 0.75 * std::sqrt(count / most), x + 0.5 * cellWidth,
                   y + 0.5 * cellHeight + 4.0, count);
  }
  const char* names[] = {"flat", "left near", "right near", "top near", "bottom near"};
  for (int k = 0; k < BoardCoverage::kTilts; ++k) {
    fmt::format_to(out, "<text x=\"{:.1f}\" y=\"{:.1f}\">{}: {}</text>\n", width + 16.0,
                   18.0 + 20.0 * k, names[k], camera.coverage.tilts[static_cast<std::size_t>(k)]);
  }
  return svg + "</svg>\n";
}

std::string errorDrawing(const BoardReport::CameraPart& camera) {
  double most = 1e-6;
  for (const ViewFit& view : camera.views) {
    most = std::max(most, view.used ? view.rmsPx : 0.0);
  }
  const double height = (kBarHeight + 2.0) * static_cast<double>(camera.views.size());
  std::string svg = opened(kDrawingWidth, height, "error of each picture");
  auto out = std::back_inserter(svg);
  double y = 0.0;
  for (const ViewFit& view : camera.views) {
    const double width = 0.4 * kDrawingWidth * std::min(1.0, view.rmsPx / most);
    const char* kind = !view.used ? "left" : view.doubtful ? "doubtful" : "bar";
    const std::string words =
        !view.used ? "left out: " + view.reason : fmt::format("{:.3f} px", view.rmsPx);
    fmt::format_to(out,
                   "<text x=\"0\" y=\"{0:.1f}\">{1}</text><rect class=\"{2}\" x=\"{3:.1f}\" "
                   "y=\"{4:.1f}\" width=\"{5:.1f}\" height=\"{6}\"/><text x=\"{7:.1f}\" "
                   "y=\"{0:.1f}\">{8}</text>\n",
                   y + kBarHeight - 2.0, escaped(view.name), kind, 0.3 * kDrawingWidth, y,
                   view.used ? width : 0.0, kBarHeight,
                   0.3 * kDrawingWidth + (view.used ? width : 0.0) + 4.0, escaped(words));
    y += kBarHeight + 2.0;
  }
  return svg + "</svg>\n";
}

} // namespace dewpoint
