// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/view/target_exposures.h"

#include <QWidget>

namespace dewpoint::ui {

/// Histogram of the brightness of a target's pixels, from black to white. The bars of pixels
/// without a useful color, which are too dark or clipped (saturated), are drawn in the text color.
class ExposureBars : public QWidget {
  Q_OBJECT
public:
  explicit ExposureBars(QWidget* parent = nullptr);

  /// Sets the exposure whose histogram is shown. If it covers no pixels, only the base line is
  /// drawn.
  void setExposure(const TargetExposure& exposure);
  QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  TargetExposure exposure_;
};

} // namespace dewpoint::ui
