// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plots/plot_figure.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace dewpoint::ui {

class PlotNavigation;

/// Exports plots as currently shown, for use in other programs. Do not keep this object: it stores
/// only references.
class PlotExport {
public:
  /// Creates an export of these plots. `drawAgain` must restore the appearance of the plots in the
  /// window.
  PlotExport(QCustomPlot& plot, const std::vector<std::unique_ptr<PlotRow>>& rows,
             const PlotNavigation& navigation, PlotCursor& cursor, std::function<void()> drawAgain);

  /// Returns the curves within the range shown as CSV, one line per row. All data points are
  /// included.
  std::string csv() const;
  /// Returns the plots as a figure for publication: as SVG if `asSvg` is true, otherwise as
  /// pixels.
  PlotImage image(bool asSvg) const;

private:
  QCustomPlot& plot_;
  const std::vector<std::unique_ptr<PlotRow>>& rows_;
  const PlotNavigation& navigation_;
  PlotCursor& cursor_;
  std::function<void()> drawAgain_;
};

} // namespace dewpoint::ui
