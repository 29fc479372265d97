// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

class QComboBox;
class QDoubleSpinBox;
class QWidget;

namespace dewpoint::ui {

/// Bounds, step and number of decimals of a number field made by makeNumberField().
struct NumberRange {
  double low = -1e4;
  double high = 1e4;
  double step = 0.01;
  int decimals = 3;
};
/// Creates a right-aligned number field with this object name. The field reports a value only when
/// editing ends or a step is made.
QDoubleSpinBox* makeNumberField(const QString& name, const NumberRange& range, QWidget* parent);

/// Changes the unit, range and precision of a field.
void setRange(QDoubleSpinBox& field, const NumberRange& range, const QString& unit);

/// Shows a value in a field without emitting signals.
void showValue(QDoubleSpinBox& field, double value);

/// Allows a combo box to be narrower than its longest text.
void makeNarrow(QComboBox& box);

} // namespace dewpoint::ui
