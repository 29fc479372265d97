// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <vector>

class QCPGraph;
class QCustomPlot;

namespace dewpoint {

struct IterationRecord;

/// Spread of the particles and, where truth is known, the error of the estimate, in millimetres on
/// a logarithmic axis, over the last filter iterations of the first target.
class ConvergencePlot : public QWidget {
  Q_OBJECT
public:
  explicit ConvergencePlot(QWidget* parent = nullptr);

  void append(const std::vector<IterationRecord>& records);
  void clear();
  int shownIterations() const;
  QSize sizeHint() const override { return {700, 200}; }

protected:
  void changeEvent(QEvent* event) override;

private:
  void applyPalette();
  void fitAxes();

  QCustomPlot* plot_;
  QCPGraph* spread_;
  QCPGraph* error_;
};

} // namespace dewpoint
