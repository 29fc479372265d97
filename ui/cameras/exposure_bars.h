// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/target_exposures.h"

#include <QWidget>

namespace dewpoint::ui {

/// Histogram of the brightness of a target's pixels, from black to white. Pixels without a useful
/// color, too dark or clipped, have bars in the color of text.
class ExposureBars : public QWidget {
  Q_OBJECT
public:
  explicit ExposureBars(QWidget* parent = nullptr);

  /// Sets the histogram. Without pixels, only the base line is drawn.
  void setExposure(const TargetExposure& exposure);
  QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  TargetExposure exposure_;
};

} // namespace dewpoint::ui
