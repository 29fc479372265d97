// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/figure/trajectory_figure.h"

#include <Eigen/Geometry>

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace dewpoint::trajectory {

/// Texts of a figure, in the user's language.
struct FigureTexts {
  std::string title;
  std::string timeAxisLabel; ///< for example "time (s)"
  std::string topViewTitle;  ///< title of the top view: "from above"
};

/// Returns a title with the project and method of a run, taken from the header entries of its
/// trajectory. The title is empty if there are no such entries.
std::string figureTitle(const std::vector<std::pair<std::string, std::string>>& entries);

/// A trajectory figure laid out on a page for printing. It shows x, y and z over time, each with a
/// band of two standard deviations, next to them the path as seen from above, and a legend. Lengths
/// are in units of the page, with x to the right and y down. figureSvg() and the window draw the
/// figure.
struct FigureDrawing {
  static constexpr double kWidth = 1000.0;
  static constexpr double kHeight = 707.0; ///< height; the aspect ratio is that of A4, 1.414 : 1
  static constexpr double kFontSize = 13.0;

  enum class Align { Left, Center, Right };

  /// Straight grid line.
  struct GridLine {
    Eigen::Vector2d from;
    Eigen::Vector2d to;
  };
  /// Outline of a plot.
  struct PlotFrame {
    Eigen::AlignedBox2d box;
  };
  /// Text, aligned in a box.
  struct Label {
    Eigen::AlignedBox2d box; ///< text that is too long extends beyond the box
    Align alignment = Align::Left;
    bool isCentered = false; ///< vertically centered; otherwise at the top of the box
    std::string text;
  };
  /// Part of the curve of one target, without gaps.
  struct Curve {
    std::size_t target = 0;
    Eigen::AlignedBox2d clipRectangle;
    std::vector<Eigen::Vector2d> path;
    /// Closed outline of the band, drawn below the path; empty: no band.
    std::vector<Eigen::Vector2d> uncertaintyBand;
  };
  /// Bar in the legend with the color of a target.
  struct LegendKey {
    std::size_t target = 0;
    Eigen::AlignedBox2d box;
  };
  using Item = std::variant<GridLine, PlotFrame, Label, Curve, LegendKey>;

  std::vector<Item> items; ///< elements of the figure, in drawing order
};

/// Lays out the figure of a table.
FigureDrawing layOutFigure(const ExportTable& table, const FigureTexts& texts);

/// Returns the drawing as an SVG file, dark on white, with colors that color-blind people can
/// distinguish.
std::string figureSvg(const FigureDrawing& drawing, const std::string& title);

} // namespace dewpoint::trajectory
