// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/report/report_drawing.h"

#include "core/base/markup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace dewpoint::calibration {
namespace {

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

/// Length that nine of ten residuals stay below, pixels.
double usualResidual(const std::vector<ImageResidual>& residuals) {
  std::vector<double> sizes;
  sizes.reserve(residuals.size());
  for (const ImageResidual& one : residuals) {
    sizes.push_back(one.residual.norm());
  }
  std::ranges::sort(sizes);
  return sizes.empty() ? 1.0 : std::max(1e-3, sizes[sizes.size() * 9 / 10]);
}

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>{}</title><style>
:root {{ color-scheme: light dark; --ink: #1d2430; --paper: #fff; --line: #9aa4b2; --blue: #1f6feb;
  --red: #c8321f; --amber: #b26a00 }}
@media (prefers-color-scheme: dark) {{ :root {{ --ink: #e3e8ef; --paper: #14181f; --line: #5a6675;
  --blue: #6cb0ff; --red: #ff7b6b; --amber: #f0b048 }} }}
body {{ font: 15px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper);
  max-width: 62rem; margin: 2rem auto; padding: 0 1rem }}
svg {{ max-width: 100%; margin: .3rem 1rem .6rem 0; vertical-align: top; overflow: visible }}
svg text {{ font: 11px system-ui, sans-serif; fill: var(--ink) }}
table {{ border-collapse: collapse; font-variant-numeric: tabular-nums }}
td, th {{ padding: .1rem .9rem .1rem 0; text-align: left; border-bottom: 1px solid var(--line) }}
.frame, polyline, path {{ fill: none; stroke: var(--line) }} .arrow {{ stroke: var(--blue); stroke-width: .8 }}
.cell {{ fill: var(--blue); stroke: var(--line) }} .bar {{ fill: var(--blue) }} .doubtful {{ fill: var(--amber) }}
.left {{ fill: none }} .camera {{ stroke: var(--blue); stroke-width: 1.4 }} .board {{ stroke: var(--amber) }}
.axis {{ stroke: var(--red); stroke-width: 1.6 }} .notice {{ color: var(--amber) }}
</style></head><body>
)";

} // namespace

std::string htmlHead(const std::string& title) {
  return fmt::format(kHead, htmlEscaped(title));
}

std::string residualDrawing(const Intrinsics& image, const std::vector<ImageResidual>& residuals) {
  const double scale = kDrawingWidth / image.width;
  const double height = image.height * scale;
  const double lengthen = kArrowPart * kDrawingWidth / usualResidual(residuals);
  std::string svg =
      opened(kDrawingWidth, height + 22.0, "residuals") + frame(kDrawingWidth, height);
  svg += "<path class=\"arrow\" d=\"";
  auto out = std::back_inserter(svg);
  for (const ImageResidual& one : residuals) {
    const Eigen::Vector2d from = scale * (one.pixel - one.residual);
    const Eigen::Vector2d along = lengthen * one.residual;
    const Eigen::Vector2d across(-along.y(), along.x());
    const Eigen::Vector2d left = from + 0.7 * along + 0.15 * across;
    const Eigen::Vector2d right = from + 0.7 * along - 0.15 * across;
    const Eigen::Vector2d tip = from + along;
    fmt::format_to(out, "M{:.1f} {:.1f}L{:.1f} {:.1f}M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}",
                   from.x(), from.y(), tip.x(), tip.y(), left.x(), left.y(), tip.x(), tip.y(),
                   right.x(), right.y());
  }
  const double sample = roundBelow(2.0 * usualResidual(residuals));
  fmt::format_to(out,
                 "\"/>\n<path class=\"arrow\" d=\"M4 {0:.1f}h{1:.1f}\"/><text x=\"{2:.1f}\" "
                 "y=\"{3:.1f}\">{4:g} px</text>\n</svg>\n",
                 height + 12.0, sample * lengthen, 10.0 + sample * lengthen, height + 16.0, sample);
  return svg;
}

std::string coverageDrawing(const Intrinsics& image, const BoardCoverage& coverage,
                            const std::vector<std::string>& notes) {
  const double width = 0.6 * kDrawingWidth;
  const double height = width * image.height / image.width;
  const double cellWidth = width / BoardCoverage::kColumns;
  const double cellHeight = height / BoardCoverage::kRows;
  const auto& counts = coverage.cornerCounts;
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
  for (std::size_t k = 0; k < notes.size(); ++k) {
    fmt::format_to(out, "<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", width + 16.0,
                   18.0 + 20.0 * static_cast<double>(k), htmlEscaped(notes[k]));
  }
  return svg + "</svg>\n";
}

std::string viewErrorDrawing(const std::vector<ViewFit>& views) {
  double most = 1e-6;
  for (const ViewFit& view : views) {
    most = std::max(most, view.isUsed ? view.rmsPx : 0.0);
  }
  const double height = (kBarHeight + 2.0) * static_cast<double>(views.size());
  std::string svg = opened(kDrawingWidth, height, "error of each image");
  auto out = std::back_inserter(svg);
  double y = 0.0;
  for (const ViewFit& view : views) {
    const double width = 0.4 * kDrawingWidth * std::min(1.0, view.rmsPx / most);
    const char* kind = !view.isUsed ? "left" : view.isDoubtful ? "doubtful" : "bar";
    const std::string words =
        !view.isUsed ? "left out: " + view.reason : fmt::format("{:.3f} px", view.rmsPx);
    fmt::format_to(out,
                   "<text x=\"0\" y=\"{0:.1f}\">{1}</text><rect class=\"{2}\" x=\"{3:.1f}\" "
                   "y=\"{4:.1f}\" width=\"{5:.1f}\" height=\"{6}\"/><text x=\"{7:.1f}\" "
                   "y=\"{0:.1f}\">{8}</text>\n",
                   y + kBarHeight - 2.0, htmlEscaped(view.name), kind, 0.3 * kDrawingWidth, y,
                   view.isUsed ? width : 0.0, kBarHeight,
                   0.3 * kDrawingWidth + (view.isUsed ? width : 0.0) + 4.0, htmlEscaped(words));
    y += kBarHeight + 2.0;
  }
  return svg + "</svg>\n";
}

} // namespace dewpoint::calibration
