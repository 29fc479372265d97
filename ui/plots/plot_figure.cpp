// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_figure.h"

#include "ui/plots/plot_cursor.h"
#include "ui/plots/plot_row.h"
#include "ui/plots/plot_stack.h"

#include <QBuffer>
#include <QSaveFile>
#include <QSvgGenerator>

namespace dewpoint::ui {

namespace {

constexpr int kSvgResolution = 96; ///< pixels per inch, as the web counts them
constexpr double kPngScale = 2.0;  ///< pixels per point of the window

} // namespace

PlotFigure::PlotFigure(QCustomPlot& plot, const std::vector<std::unique_ptr<PlotRow>>& rows,
                       PlotAxis axis, PlotCursor& cursor)
    : plot_(plot), rows_(rows), axis_(axis), cursor_(cursor) {
  paintFor(true);
}

PlotFigure::~PlotFigure() {
  paintFor(false);
}

void PlotFigure::paintFor(bool figure) {
  // On paper there is time for smooth lines and need for the name of the axis.
  for (const auto& row : rows_) {
    for (QCPGraph* graph : row->xAxis()->graphs()) {
      QPen pen = graph->pen();
      pen.setWidthF(figure ? 1.4 : 0.0);
      graph->setPen(pen);
      graph->setAntialiased(figure);
    }
    row->yAxis()->setLabel(figure ? axisUnit(row->declaration().quantity) : QString());
    const bool last = row == rows_.back();
    if (last) {
      row->xAxis()->setLabel(!figure                   ? QString()
                             : axis_ == PlotAxis::Time ? tr("time, s")
                                                       : tr("filter iteration"));
      row->rect()->setMargins(
          QMargins(0, 4, 4, figure ? 2 * PlotStack::kTickHeight : PlotStack::kTickHeight));
    }
  }
  cursor_.setVisible(!figure || cursor_.selectedRange.has_value() ||
                     cursor_.currentFrame.has_value());
}

PlotPicture PlotFigure::draw(bool asDrawing) {
  PlotPicture picture;
  if (!asDrawing) {
    picture.pixels = plot_.toPixmap(plot_.width(), plot_.height(), kPngScale).toImage();
    return picture;
  }
  QBuffer buffer(&picture.drawing);
  buffer.open(QIODevice::WriteOnly);
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setResolution(kSvgResolution);
  generator.setSize(plot_.size());
  generator.setViewBox(QRect(QPoint(), plot_.size()));
  generator.setTitle(tr("Dewpoint plots"));
  QCPPainter painter;
  if (painter.begin(&generator)) {
    painter.setMode(QCPPainter::pmVectorized);
    painter.fillRect(plot_.rect(), plot_.palette().color(QPalette::Base));
    plot_.toPainter(&painter, plot_.width(), plot_.height());
    painter.end();
  }
  return picture;
}

bool PlotPicture::save(const QString& file) const {
  QSaveFile out(file);
  if (!out.open(QIODevice::WriteOnly)) {
    return false;
  }
  const bool written =
      drawing.isEmpty() ? pixels.save(&out, "PNG") : out.write(drawing) == drawing.size();
  return written && out.commit();
}

} // namespace dewpoint::ui
