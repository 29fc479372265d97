// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/frames/color_histograms.h"

#include <QWidget>

#include <memory>
#include <vector>

namespace dewpoint::ui {

/// Compares the color histogram of a bounding box at the time it was set with the histogram of the
/// box now. Each bin has two bars in the bin's color, one hollow and one filled.
class HistogramView : public QWidget {
  Q_OBJECT
public:
  explicit HistogramView(QWidget* parent = nullptr);

  /// Sets the histograms; null shows nothing.
  void setHistograms(const std::shared_ptr<const ColorHistograms>& histograms);

  QSize sizeHint() const override { return {220, 72}; }
  QSize minimumSizeHint() const override { return {120, 56}; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  std::vector<ColorBar> bars_;
};

} // namespace dewpoint::ui
