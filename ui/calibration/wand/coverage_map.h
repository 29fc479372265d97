// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/wand_collector.h"

#include <QWidget>

namespace dewpoint::ui {

/// Small map of a camera image that shows how often the wand was seen in each region.
class CoverageMap : public QWidget {
  Q_OBJECT
public:
  explicit CoverageMap(QWidget* parent = nullptr);

  /// Shows where a camera has seen the wand. `shape` is the image width divided by the image
  /// height.
  void setCamera(const QString& camera, const CameraSightings& seen, double shape);
  QSize sizeHint() const override { return {112, 84}; }
  QSize minimumSizeHint() const override { return {72, 54}; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  CameraSightings seen_;
  double aspectRatio_ = 4.0 / 3.0;
};

} // namespace dewpoint::ui
