// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/wand/coverage_map.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {

CoverageMap::CoverageMap(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void CoverageMap::setCamera(const QString& camera, const CameraSightings& seen, double shape) {
  seen_ = seen;
  aspectRatio_ = shape;
  const auto& regions = seen.imageCoverage.cornerCounts;
  const auto covered = std::ranges::count_if(regions, [](int count) { return count > 0; });
  const QString text = tr("%1: %2 detections, in %3 of %4 regions of the image")
                           .arg(camera)
                           .arg(static_cast<qulonglong>(seen.detectionCount))
                           .arg(covered)
                           .arg(static_cast<qulonglong>(regions.size()));
  setToolTip(text);
  setAccessibleName(text);
  update();
}

void CoverageMap::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const double width = std::min<double>(this->width() - 1, aspectRatio_ * (height() - 1));
  const QRectF image(0.5 * (this->width() - 1 - width) + 0.5, 0.5, width, width / aspectRatio_);
  const auto& regions = seen_.imageCoverage.cornerCounts;
  const double most = std::max(1, *std::ranges::max_element(regions));
  const double cellWidth = image.width() / BoardCoverage::kColumns;
  const double cellHeight = image.height() / BoardCoverage::kRows;
  for (int k = 0; k < static_cast<int>(regions.size()); ++k) {
    const int count = regions[static_cast<std::size_t>(k)];
    const QRectF cell(image.x() + k % BoardCoverage::kColumns * cellWidth,
                      image.y() + k / BoardCoverage::kColumns * cellHeight, // NOLINT: whole rows
                      cellWidth, cellHeight);
    if (count > 0) {
      QColor color = palette().color(QPalette::Highlight);
      color.setAlphaF(static_cast<float>(0.25 + 0.75 * std::sqrt(count / most)));
      painter.fillRect(cell.adjusted(0.5, 0.5, -0.5, -0.5), color);
    }
  }
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawRect(image);
}

} // namespace dewpoint::ui
