// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

class QComboBox;
class QDoubleSpinBox;
class QWidget;

namespace dewpoint::ui {

/// A field for a number with a unit: tabular, right-aligned, reported only when it is finished or
/// stepped.
struct NumberRange {
  double low = -1e4;
  double high = 1e4;
  double step = 0.01;
  int decimals = 3;
};
QDoubleSpinBox* makeNumberField(const QString& name, const NumberRange& range, QWidget* parent);

/// Another unit, range and precision for what the field shows next.
void setRange(QDoubleSpinBox& field, const NumberRange& range, const QString& unit);

/// Shows a value without telling anyone.
void showValue(QDoubleSpinBox& field, double value);

/// Lets a choice be narrower than its longest text.
void makeNarrow(QComboBox& box);

} // namespace dewpoint::ui
