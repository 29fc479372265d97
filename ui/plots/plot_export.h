// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_figure.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace dewpoint::ui {

class PlotNavigation;

/// Plots as they are shown now, for other programs. To be used at once: it holds nothing itself.
class PlotExport {
public:
  /// `drawAgain`: gives the plots the looks of the window again.
  PlotExport(QCustomPlot& plot, const std::vector<std::unique_ptr<PlotRow>>& rows,
             const PlotNavigation& navigation, PlotCursor& cursor, std::function<void()> drawAgain);

  /// The curves within the part shown, not thinned out for drawing: one line per row.
  std::string csv() const;
  /// A figure for paper: a drawing (SVG), or pixels.
  PlotPicture picture(bool asDrawing) const;

private:
  QCustomPlot& plot_;
  const std::vector<std::unique_ptr<PlotRow>>& rows_;
  const PlotNavigation& navigation_;
  PlotCursor& cursor_;
  std::function<void()> drawAgain_;
};

} // namespace dewpoint::ui
