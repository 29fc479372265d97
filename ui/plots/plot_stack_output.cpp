// SPDX-License-Identifier: GPL-3.0-or-later
// What a stack of plots gives away: tables, pictures, words.
#include "ui/plots/csv_line.h"
#include "ui/plots/plot_cursor.h"
#include "ui/plots/plot_row.h"
#include "ui/plots/plot_stack.h"

#include <QFile>
#include <QSaveFile>
#include <QSvgGenerator>

namespace dewpoint::ui {

namespace {

constexpr int kSvgResolution = 96; ///< pixels per inch, as the web counts them
constexpr double kPngScale = 2.0;  ///< pixels per point of the window

} // namespace

QByteArray PlotStack::csv() const {
  QByteArray text("iteration,frame,time_s");
  for (const auto& row : rows_) {
    for (const CurveDeclaration& curve : row->declaration().curves) {
      text.append(',').append(curve.csvName.toUtf8());
    }
  }
  text.append('\n');
  if (series_ == nullptr) {
    return text;
  }
  const auto [lower, upper] = shownRange();
  const auto [first, last] = series_->within(axis_, lower, upper);
  for (std::size_t index = first; index < last; ++index) {
    if (!series_->isDrawn(index, axis_)) {
      continue;
    }
    const PlotSeries::Row& at = series_->row(index);
    CsvLine line(text);
    line.put(at.iteration).put(at.frame).put(at.time);
    for (const auto& row : rows_) {
      const bool inMm = row->declaration().quantity == PlotQuantity::Length;
      for (const CurveDeclaration& curve : row->declaration().curves) {
        line.put(series_->value(index, curve.column) * (inMm ? 1000.0 : 1.0));
      }
    }
  }
  return text;
}

QString PlotStack::placeInWords() const {
  const auto row = cursorRow();
  if (!row) {
    return {};
  }
  const PlotSeries::Row& at = series_->row(*row);
  return tr("frame %1, iteration %2, %3 s") // people count frames from 1
      .arg(at.frame + 1)
      .arg(at.iteration)
      .arg(QLocale().toString(at.time, 'f', 2));
}

QString PlotStack::valuesInWords() const {
  QStringList parts;
  if (const QString place = placeInWords(); !place.isEmpty()) {
    parts << place;
  }
  for (const auto& row : rows_) {
    parts << QStringLiteral("%1: %2").arg(row->declaration().title, row->readout()->inWords());
  }
  return parts.join(QStringLiteral("; "));
}

void PlotStack::paintFor(bool figure) {
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
      row->rect()->setMargins(QMargins(0, 4, 4, figure ? 2 * kTickHeight : kTickHeight));
    }
  }
  cursor_->setVisible(!figure || span_.has_value() || moment_.has_value());
}

bool PlotStack::savePicture(const QString& file) {
  QSaveFile out(file);
  if (!out.open(QIODevice::WriteOnly)) {
    return false;
  }
  paintFor(true);
  bool written = true;
  if (file.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive)) {
    QSvgGenerator generator;
    generator.setOutputDevice(&out);
    generator.setResolution(kSvgResolution);
    generator.setSize(plot_->size());
    generator.setViewBox(QRect(QPoint(), plot_->size()));
    generator.setTitle(tr("Dewpoint plots"));
    QCPPainter painter;
    written = painter.begin(&generator);
    if (written) {
      painter.setMode(QCPPainter::pmVectorized);
      painter.fillRect(plot_->rect(), palette().color(QPalette::Base));
      plot_->toPainter(&painter, plot_->width(), plot_->height());
      painter.end();
    }
  } else {
    written = plot_->toPixmap(plot_->width(), plot_->height(), kPngScale).save(&out, "PNG");
  }
  paintFor(false);
  draw();
  return written && out.commit();
}

} // namespace dewpoint::ui
