// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QDoubleSpinBox>

namespace dewpoint::ui {

/// Number field in the format of the selected language. It accepts a point or a comma as decimal
/// separator and immediately shows how the input is interpreted. It does not use thousands
/// separators. The click that gives the field the focus selects the number, as the Tab key does, so
/// that typing replaces the number; the next click sets the caret.
class DecimalField : public QDoubleSpinBox {
public:
  explicit DecimalField(QWidget* parent = nullptr);

  QValidator::State validate(QString& text, int& position) const override;
  double valueFromText(const QString& text) const override;

protected:
  void changeEvent(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QString localized(const QString& typed) const;

  bool selectsOnRelease_ = false; ///< the click in progress has given the focus
};

/// Creates a field with this object name, range and number of decimals. It reports a number when
/// typing is finished, not after each key.
DecimalField* makeDecimalField(const char* name, double low, double high, int decimals,
                               QWidget* parent);

} // namespace dewpoint::ui
