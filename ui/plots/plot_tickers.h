// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <qcustomplot.h>

namespace dewpoint::ui {

/// Axis ticker with ticks only at powers of ten, and a maximum number of ticks. The lowest and the
/// highest tick have priority.
class DecadeTicker : public QCPAxisTicker {
public:
  void setMaxTicks(int most) { maxTicks_ = most; }

protected:
  int getSubTickCount(double) override { return 0; }
  QVector<double> createTickVector(double, const QCPRange& range) override;

private:
  int maxTicks_ = 2;
};

/// Axis ticker whose labels have as many decimals as the tick step, for example 2.5, 5.0, 7.5.
class StepTicker : public QCPAxisTicker {
public:
  void setWholeNumbers(bool whole) { wholeNumbers_ = whole; }

protected:
  double getTickStep(const QCPRange& range) override;
  QVector<double> createTickVector(double step, const QCPRange& range) override;
  QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override;

  double step_ = 1.0; ///< current step between ticks

private:
  bool wholeNumbers_ = false;
};

/// Axis ticker for plots of small height. It draws at least two ticks and at most the number set
/// with setMaxTicks(), at multiples of 1, 2 or 5 times a power of ten.
class ValueTicker : public StepTicker {
public:
  void setMaxTicks(int most) { maxTicks_ = most; }

protected:
  int getSubTickCount(double) override { return 0; }
  QVector<double> createTickVector(double step, const QCPRange& range) override;

private:
  int maxTicks_ = 2;
};

} // namespace dewpoint::ui
