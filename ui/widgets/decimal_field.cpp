// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/decimal_field.h"

#include "ui/widgets/named.h"

#include <QFocusEvent>
#include <QLineEdit>
#include <QLocale>
#include <QMouseEvent>
#include <QSignalBlocker>

namespace dewpoint::ui {

DecimalField::DecimalField(QWidget* parent) : QDoubleSpinBox(parent) {
  lineEdit()->installEventFilter(this);
}

QString DecimalField::localized(const QString& typed) const {
  // Printed texts have the real minus sign; without this, a pasted "−5" would become 5.
  QString text = typed;
  text.replace(QChar(0x2212), locale().negativeSign());
  const QString point = locale().decimalPoint();
  QString number = text;
  const bool hasUnit = !suffix().isEmpty() && number.endsWith(suffix());
  if (hasUnit) {
    number.chop(suffix().size());
  }
  if (text == specialValueText() || number.contains(point)) {
    return text; // words, or clear already
  }
  const QChar other = point == QStringLiteral(",") ? QLatin1Char('.') : QLatin1Char(',');
  if (const auto place = number.indexOf(other, prefix().size()); place >= 0) {
    number.replace(place, 1, point);
  }
  return hasUnit ? number + suffix() : number;
}

void DecimalField::changeEvent(QEvent* event) {
  QDoubleSpinBox::changeEvent(event);
  if (event->type() == QEvent::LocaleChange) {
    const QSignalBlocker quiet(this);
    setValue(value()); // writes it anew
  }
}

void DecimalField::focusInEvent(QFocusEvent* event) {
  QDoubleSpinBox::focusInEvent(event);
  selectsOnRelease_ = event->reason() == Qt::MouseFocusReason;
}

void DecimalField::mousePressEvent(QMouseEvent* event) {
  selectsOnRelease_ = false; // on the arrows, not in the text
  QDoubleSpinBox::mousePressEvent(event);
}

bool DecimalField::eventFilter(QObject* watched, QEvent* event) {
  // Not earlier: the press sets the caret. A text that was dragged over stays selected.
  if (watched == lineEdit() && event->type() == QEvent::MouseButtonRelease && selectsOnRelease_) {
    selectsOnRelease_ = false;
    if (!lineEdit()->hasSelectedText()) {
      selectAll();
    }
  }
  return QDoubleSpinBox::eventFilter(watched, event);
}

QValidator::State DecimalField::validate(QString& text, int& position) const {
  text = localized(text);
  return QDoubleSpinBox::validate(text, position);
}

double DecimalField::valueFromText(const QString& text) const {
  return QDoubleSpinBox::valueFromText(localized(text));
}

DecimalField* makeDecimalField(const char* name, double low, double high, int decimals,
                               QWidget* parent) {
  auto* field = named(new DecimalField(parent), name);
  field->setRange(low, high);
  field->setDecimals(decimals);
  field->setKeyboardTracking(false);
  return field;
}

} // namespace dewpoint::ui
