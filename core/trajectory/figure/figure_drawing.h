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
  std::string time;    ///< "time (s)"
  std::string topView; ///< "from above"
};

/// Project and method of a run, from the entries of its header; empty without them.
std::string figureTitle(const std::vector<std::pair<std::string, std::string>>& entries);

/// A figure of a trajectory for print, laid out on a page: x, y and z over time with a band of two
/// standard deviations, the path from above beside them, a legend. Lengths in units of the page, x
/// right, y down. Drawn by figureSvg() and by the window.
struct FigureDrawing {
  static constexpr double kWidth = 1000.0;
  static constexpr double kHeight = 707.0; ///< A4 is 1.414 : 1
  static constexpr double kFontSize = 13.0;

  enum class Align { Left, Center, Right };

  struct GridLine {
    Eigen::Vector2d from;
    Eigen::Vector2d to;
  };
  struct Frame {
    Eigen::AlignedBox2d box;
  };
  struct Label {
    Eigen::AlignedBox2d box; ///< what is too long for it sticks out
    Align align = Align::Left;
    bool isCentered = false; ///< vertically; else at the top of the box
    std::string text;
  };
  struct Curve {
    std::size_t target = 0;
    Eigen::AlignedBox2d within; ///< what lies outside is not drawn
    std::vector<Eigen::Vector2d> path;
    std::vector<Eigen::Vector2d> band; ///< a closed outline, below the path; may be empty
  };
  /// A bar in the color of a target.
  struct LegendKey {
    std::size_t target = 0;
    Eigen::AlignedBox2d box;
  };
  using Item = std::variant<GridLine, Frame, Label, Curve, LegendKey>;

  std::vector<Item> items; ///< in the order of drawing
};

FigureDrawing figureDrawing(const ExportTable& table, const FigureTexts& texts);

/// The drawing as an SVG file, dark on white, with colors that the color-blind tell apart.
std::string figureSvg(const FigureDrawing& drawing, const std::string& title);

} // namespace dewpoint::trajectory
