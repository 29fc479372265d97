// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/number_field.h"

#include "ui/widgets/decimal_field.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSignalBlocker>

namespace dewpoint::ui {

QDoubleSpinBox* makeNumberField(const QString& name, const NumberRange& range, QWidget* parent) {
  auto* field = new DecimalField(parent);
  field->setObjectName(name);
  field->setKeyboardTracking(false);
  field->setAlignment(Qt::AlignRight);
  field->setButtonSymbols(QAbstractSpinBox::NoButtons); // arrow keys and the wheel step as well
  field->setMinimumWidth(72);
  field->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // columns share the room
  setRange(*field, range, {});
  return field;
}

void setRange(QDoubleSpinBox& field, const NumberRange& range, const QString& unit) {
  const QSignalBlocker quiet(field);
  field.setDecimals(range.decimals);
  field.setRange(range.low, range.high);
  field.setSingleStep(range.step);
  field.setSuffix(unit);
}

void showValue(QDoubleSpinBox& field, double value) {
  const QSignalBlocker quiet(field);
  field.setValue(value);
}

void makeNarrow(QComboBox& box) {
  box.setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box.setMinimumContentsLength(8);
}

} // namespace dewpoint::ui
