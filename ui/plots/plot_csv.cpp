// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_csv.h"

#include "core/base/units.h"
#include "core/trajectory/csv_line.h"
#include "ui/plots/plot_row.h"

namespace dewpoint::ui {

namespace {

bool isTruthKnown(const PlotSeries& series, const CurveDeclaration& curve) {
  return curve.truth && *curve.truth < series.columnCount() &&
         series.hasValuesInColumn(*curve.truth);
}

double written(double value, PlotQuantity quantity) {
  return quantity == PlotQuantity::Length ? inMillimeters(value) : value;
}

} // namespace

std::string plotCsv(const std::vector<std::unique_ptr<PlotRow>>& rows, const PlotSeries& series,
                    PlotAxis axis, const std::pair<double, double>& range) {
  std::string text = "iteration,frame,time_s";
  for (const auto& row : rows) {
    for (const CurveDeclaration& curve : row->declaration().curves) {
      text.append(",").append(curve.csvName.toStdString());
    }
    for (const CurveDeclaration& curve : row->declaration().curves) {
      if (isTruthKnown(series, curve)) {
        text.append(",").append(curve.truthCsvName.toStdString());
      }
    }
  }
  text += '\n';
  const auto [first, last] = series.rowsWithin(axis, range.first, range.second);
  for (std::size_t index = first; index < last; ++index) {
    if (!series.isRowDrawn(index, axis)) {
      continue;
    }
    const PlotSeries::Row& at = series.row(index);
    CsvLine line(text);
    line.put(at.iteration).put(at.frame).put(at.seconds);
    for (const auto& row : rows) {
      for (const CurveDeclaration& curve : row->declaration().curves) {
        line.put(written(series.value(index, curve.column), row->declaration().quantity));
      }
      for (const CurveDeclaration& curve : row->declaration().curves) {
        if (isTruthKnown(series, curve)) {
          line.put(written(series.value(index, *curve.truth), row->declaration().quantity));
        }
      }
    }
  }
  return text;
}

} // namespace dewpoint::ui
