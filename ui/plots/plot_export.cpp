// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_export.h"

#include "ui/plots/plot_csv.h"
#include "ui/plots/plot_navigation.h"
#include "ui/plots/plot_row.h"

#include <utility>

namespace dewpoint::ui {

PlotExport::PlotExport(QCustomPlot& plot, const std::vector<std::unique_ptr<PlotRow>>& rows,
                       const PlotNavigation& navigation, PlotCursor& cursor,
                       std::function<void()> drawAgain)
    : plot_(plot), rows_(rows), navigation_(navigation), cursor_(cursor),
      drawAgain_(std::move(drawAgain)) {}

std::string PlotExport::csv() const {
  const PlotSeries* series = navigation_.series();
  return series != nullptr ? plotCsv(rows_, *series, navigation_.axis(), navigation_.shownRange())
                           : plotCsv(rows_, PlotSeries(), navigation_.axis(), {});
}

PlotImage PlotExport::image(bool asSvg) const {
  PlotImage drawn = PlotFigure(plot_, rows_, navigation_.axis(), cursor_).draw(asSvg);
  drawAgain_();
  return drawn;
}

} // namespace dewpoint::ui
