// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/frames/color_histograms.h"

#include <QWidget>

#include <memory>
#include <vector>

namespace dewpoint::ui {

/// View that compares the color histogram of a bounding box when it was set with the histogram of
/// the current box. Each color bin has two bars in its color: a hollow one for the box when it was
/// set, and a filled one for the current box.
class HistogramView : public QWidget {
  Q_OBJECT
public:
  explicit HistogramView(QWidget* parent = nullptr);

  /// Sets the histograms to compare; for null, the view is empty.
  void setHistograms(const std::shared_ptr<const ColorHistograms>& histograms);

  QSize sizeHint() const override { return {220, 72}; }
  QSize minimumSizeHint() const override { return {120, 56}; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  std::vector<ColorBar> bars_;
};

} // namespace dewpoint::ui
