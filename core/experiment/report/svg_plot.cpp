// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/report/svg_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::experiment {
namespace {

constexpr double kWidth = 380.0;
constexpr double kHeight = 250.0;
constexpr double kLeft = 50.0;
constexpr double kRight = 10.0;
constexpr double kTop = 10.0;
constexpr double kBottom = 40.0;
constexpr double kMarkCount = 5.0;

/// 0 at the low end of the axis, 1 at the high end.
double share(const SvgAxis& axis, double value) {
  const double part = axis.isLogarithmic ? std::log(std::max(value, axis.low) / axis.low) /
                                               std::log(axis.high / axis.low)
                                         : (value - axis.low) / (axis.high - axis.low);
  return std::clamp(part, 0.0, 1.0);
}

double column(const Plot& plot, double x) {
  return kLeft + share(plot.x, x) * (kWidth - kLeft - kRight);
}

double row(const Plot& plot, double y) {
  return kHeight - kBottom - share(plot.y, y) * (kHeight - kTop - kBottom);
}

std::string at(const Plot& plot, double x, double y) {
  return fmt::format("{:.1f} {:.1f}", column(plot, x), row(plot, y));
}

std::string gridOf(const Plot& plot) {
  std::string text;
  for (const double mark : axisTicks(plot.x)) {
    const double x = column(plot, mark);
    text += fmt::format("<line class='grid' x1='{0:.1f}' x2='{0:.1f}' y1='{1}' y2='{2}'/>"
                        "<text class='mark' x='{0:.1f}' y='{3}' text-anchor='middle'>{4:g}</text>",
                        x, kTop, kHeight - kBottom, kHeight - kBottom + 14.0, mark);
  }
  for (const double mark : axisTicks(plot.y)) {
    const double y = row(plot, mark);
    text += fmt::format("<line class='grid' x1='{1}' x2='{2}' y1='{0:.1f}' y2='{0:.1f}'/>"
                        "<text class='mark' x='{3}' y='{4:.1f}' text-anchor='end'>{5:g}</text>",
                        y, kLeft, kWidth - kRight, kLeft - 6.0, y + 3.5, mark);
  }
  return text;
}

std::string labelsOf(const Plot& plot) {
  const double middleX = 0.5 * (kLeft + kWidth - kRight);
  const double middleY = 0.5 * (kTop + kHeight - kBottom);
  return fmt::format("<text class='label' x='{}' y='{}' text-anchor='middle'>{}</text>"
                     "<text class='label' transform='translate(13 {}) rotate(-90)' "
                     "text-anchor='middle'>{}</text>",
                     middleX, kHeight - 6.0, plot.x.label, middleY, plot.y.label);
}

/// The pieces of the line between its interruptions, [begin, end).
std::vector<std::pair<std::size_t, std::size_t>> piecesOf(const std::vector<SvgPoint>& line) {
  std::vector<std::pair<std::size_t, std::size_t>> pieces;
  for (std::size_t begin = 0; begin < line.size(); ++begin) {
    std::size_t end = begin;
    while (end < line.size() && !std::isnan(line[end].y)) {
      ++end;
    }
    if (end > begin) {
      pieces.emplace_back(begin, end);
      begin = end;
    }
  }
  return pieces;
}

std::string lineOf(const Plot& plot, const SvgSeries& series) {
  std::string path;
  for (const auto& [begin, end] : piecesOf(series.points)) {
    for (std::size_t k = begin; k < end; ++k) {
      path += fmt::format("{}{}", k == begin ? "M" : "L",
                          at(plot, series.points[k].x, series.points[k].y));
    }
  }
  return path.empty() ? path : fmt::format("<path class='line' d='{}'/>", path);
}

std::string bandOf(const Plot& plot, const SvgSeries& series) {
  if (series.bandLow.empty()) {
    return {};
  }
  std::string path;
  for (const auto& [begin, end] : piecesOf(series.points)) {
    for (std::size_t k = begin; k < end; ++k) {
      path += fmt::format("{}{}", k == begin ? "M" : "L",
                          at(plot, series.points[k].x, series.bandLow[k]));
    }
    for (std::size_t k = end; k-- > begin;) {
      path += fmt::format("L{}", at(plot, series.points[k].x, series.bandHigh[k]));
    }
    path += "Z";
  }
  return fmt::format("<path class='band' d='{}'/>", path);
}

std::string disksOf(const Plot& plot, const SvgSeries& series) {
  std::string text;
  for (std::size_t k = 0; k < series.diskAreas.size(); ++k) {
    if (std::isnan(series.points[k].y)) {
      continue;
    }
    text += fmt::format("<circle class='disk' cx='{:.1f}' cy='{:.1f}' r='{:.1f}'/>",
                        column(plot, series.points[k].x), row(plot, series.points[k].y),
                        std::sqrt(series.diskAreas[k] / 3.14159265));
  }
  return text;
}

} // namespace

std::vector<double> axisTicks(const SvgAxis& axis) {
  std::vector<double> marks;
  if (axis.isLogarithmic) {
    const auto first = static_cast<int>(std::ceil(std::log10(axis.low) - 1e-9));
    const auto last = static_cast<int>(std::floor(std::log10(axis.high) + 1e-9));
    for (int power = first; power <= last; ++power) {
      marks.push_back(std::pow(10.0, power));
    }
    return marks;
  }
  // Steps of 1, 2 or 5 times a power of ten.
  const double rough = (axis.high - axis.low) / kMarkCount;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double factor = rough / power;
  const double step = power * (factor < 1.5 ? 1.0 : factor < 3.5 ? 2.0 : factor < 7.5 ? 5.0 : 10.0);
  for (double k = std::ceil(axis.low / step - 1e-9); k * step <= axis.high + 1e-9 * step; ++k) {
    marks.push_back(k * step + 0.0); // no minus zero
  }
  return marks;
}

std::string renderSvg(const Plot& plot) {
  std::string text = fmt::format("<svg viewBox='0 0 {} {}' role='img' aria-label='{}'>", kWidth,
                                 kHeight, plot.title) +
                     gridOf(plot);
  if (plot.drawsDiagonal) {
    text += fmt::format("<path class='guide' d='M{}L{}'/>", at(plot, plot.x.low, plot.y.low),
                        at(plot, plot.x.high, plot.y.high));
  }
  for (const SvgSeries& series : plot.series) {
    text += fmt::format("<g class='{}'>{}</g>", series.style, bandOf(plot, series));
  }
  for (const SvgSeries& series : plot.series) {
    text += fmt::format("<g class='{}'>{}{}</g>", series.style, lineOf(plot, series),
                        disksOf(plot, series));
  }
  return text + labelsOf(plot) + "</svg>";
}

} // namespace dewpoint::experiment
