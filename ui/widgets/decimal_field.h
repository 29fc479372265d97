// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QDoubleSpinBox>

namespace dewpoint::ui {

/// Number field in the format of the selected language. It accepts a point or a comma as decimal
/// separator and immediately shows how the input is interpreted. It does not use thousands
/// separators.
class DecimalField : public QDoubleSpinBox {
public:
  using QDoubleSpinBox::QDoubleSpinBox;

  QValidator::State validate(QString& text, int& position) const override;
  double valueFromText(const QString& text) const override;

protected:
  void changeEvent(QEvent* event) override;

private:
  QString localized(const QString& typed) const;
};

} // namespace dewpoint::ui
