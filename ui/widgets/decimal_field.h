// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QDoubleSpinBox>

namespace dewpoint::ui {

/// A number as the chosen language writes it. Point and comma are both understood as the decimal
/// sign; what was typed shows at once how it was taken. Thousands are not grouped.
class DecimalField : public QDoubleSpinBox {
public:
  using QDoubleSpinBox::QDoubleSpinBox;

  QValidator::State validate(QString& text, int& position) const override;
  double valueFromText(const QString& text) const override;

protected:
  void changeEvent(QEvent* event) override;

private:
  QString localized(const QString& text) const;
};

} // namespace dewpoint::ui
