// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_figure.h"

#include "ui/plots/plot_cursor.h"
#include "ui/plots/plot_row.h"

#include <QBuffer>
#include <QSaveFile>
#include <QSvgGenerator>

#include <algorithm>

namespace dewpoint::ui {

namespace {

constexpr int kSvgResolution = 96;    ///< pixels per inch, as the web counts them
constexpr double kPngScale = 2.0;     ///< pixels per point of the window
constexpr int kFigureAxisHeight = 36; ///< of numbers and name of the shared axis
constexpr int kFigureRowHeight = 96;  ///< at least, however low the plots are in the window

} // namespace

PlotFigure::PlotFigure(QCustomPlot& plot, const std::vector<std::unique_ptr<PlotRow>>& rows,
                       PlotAxis axis, PlotCursor& cursor)
    : plot_(plot), rows_(rows), axis_(axis), cursor_(cursor) {
  setPaintedForFigure(true);
}

PlotFigure::~PlotFigure() {
  setPaintedForFigure(false);
}

void PlotFigure::setPaintedForFigure(bool figure) {
  // On paper there is time for smooth lines and need for the name of the axis.
  for (const auto& row : rows_) {
    row->setDrawnForFigure(figure);
    row->yAxis()->setLabel(figure ? axisUnit(row->declaration().quantity) : QString());
    if (row == rows_.back()) {
      row->xAxis()->setTickLabels(figure);
      row->xAxis()->setLabel(!figure                   ? QString()
                             : axis_ == PlotAxis::Time ? tr("time, s")
                                                       : tr("filter iteration"));
      QMargins margins = row->rect()->margins();
      margins.setBottom(margins.bottom() + (figure ? kFigureAxisHeight : -kFigureAxisHeight));
      row->rect()->setMargins(margins);
    }
  }
  cursor_.setVisible(!figure || cursor_.selectedRange.has_value() ||
                     cursor_.currentPosition.has_value());
}

PlotImage PlotFigure::draw(bool asSvg) {
  PlotImage picture;
  const int rows = static_cast<int>(rows_.size());
  const QSize size(plot_.width(),
                   std::max(plot_.height(), rows * kFigureRowHeight) + kFigureAxisHeight);
  if (!asSvg) {
    picture.pixels = plot_.toPixmap(size.width(), size.height(), kPngScale).toImage();
    return picture;
  }
  QBuffer buffer(&picture.svg);
  buffer.open(QIODevice::WriteOnly);
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setResolution(kSvgResolution);
  generator.setSize(size);
  generator.setViewBox(QRect(QPoint(), size));
  generator.setTitle(tr("Dewpoint plots"));
  QCPPainter painter;
  if (painter.begin(&generator)) {
    painter.setMode(QCPPainter::pmVectorized);
    painter.fillRect(QRect(QPoint(), size), plot_.palette().color(QPalette::Base));
    plot_.toPainter(&painter, size.width(), size.height());
    painter.end();
  }
  return picture;
}

bool PlotImage::save(const QString& file) const {
  QSaveFile out(file);
  if (!out.open(QIODevice::WriteOnly)) {
    return false;
  }
  const bool written = svg.isEmpty() ? pixels.save(&out, "PNG") : out.write(svg) == svg.size();
  return written && out.commit();
}

} // namespace dewpoint::ui
