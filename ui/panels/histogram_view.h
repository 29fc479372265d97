// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/frames/color_histograms.h"

#include <QWidget>

#include <memory>
#include <vector>

namespace dewpoint::ui {

/// The color histogram of a box as it was given, beside that of the box as it is now: a pair of
/// bars per bin in the bin's color, hollow and filled.
class HistogramView : public QWidget {
  Q_OBJECT
public:
  explicit HistogramView(QWidget* parent = nullptr);

  /// Null: nothing is shown.
  void setHistograms(const std::shared_ptr<const ColorHistograms>& histograms);

  QSize sizeHint() const override { return {220, 72}; }
  QSize minimumSizeHint() const override { return {120, 56}; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  std::vector<ColorBar> bars_;
};

} // namespace dewpoint::ui
