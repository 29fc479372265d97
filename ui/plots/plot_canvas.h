// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <qcustomplot.h>

namespace dewpoint::ui {

/// The widget on which the plots are drawn. After a change of size, it is drawn again just before
/// it is painted: once, no matter how many layouts of the window changed its size, and not at all
/// while it is hidden.
class PlotCanvas : public QCustomPlot {
  Q_OBJECT
public:
  explicit PlotCanvas(QWidget* parent = nullptr);

protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  bool resized_ = false; ///< since it was drawn
};

} // namespace dewpoint::ui
