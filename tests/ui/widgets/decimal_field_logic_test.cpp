// SPDX-License-Identifier: GPL-3.0-or-later
// What a person may type into a field for a number, and how it is taken.
#include "ui/widgets/decimal_field.h"

#include <QApplication>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>
#include <QMouseEvent>
#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

const QLocale kEnglish(QLocale::English, QLocale::UnitedStates);
const QLocale kGerman(QLocale::German, QLocale::Germany);

/// What a field makes of a text.
struct Checked {
  QValidator::State state = QValidator::Invalid;
  QString text; ///< as it is shown from then on
};

Checked checked(const DecimalField& field, const QString& typed) {
  Checked result;
  result.text = typed;
  int position = static_cast<int>(typed.size());
  result.state = field.validate(result.text, position);
  return result;
}

/// A field for 1 to 10, with two decimals.
class DecimalFieldTest : public testing::Test {
protected:
  DecimalFieldTest() {
    field_.setLocale(kEnglish);
    field_.setDecimals(2);
    field_.setRange(1.0, 10.0);
  }
  QValidator::State stateOf(const char* typed) const {
    return checked(field_, QString::fromLatin1(typed)).state;
  }
  QString shownFor(const char* typed) const {
    return checked(field_, QString::fromLatin1(typed)).text;
  }

  DecimalField field_;
};

TEST_F(DecimalFieldTest, NumbersWithinTheLimitsAreAcceptable) {
  for (const char* typed : {"1", "10", "2.5", "2.55", "9.99", "10.00"}) {
    EXPECT_EQ(stateOf(typed), QValidator::Acceptable) << typed;
  }
}

TEST_F(DecimalFieldTest, ARealMinusSignIsAMinus) {
  field_.setRange(-10.0, 10.0);
  const Checked pasted = checked(field_, QStringLiteral("−5.7"));
  EXPECT_EQ(pasted.state, QValidator::Acceptable);
  EXPECT_EQ(pasted.text, QStringLiteral("-5.7"));
  EXPECT_EQ(field_.valueFromText(QStringLiteral("−5.7")), -5.7);
}

TEST_F(DecimalFieldTest, WhatMayBecomeANumberIsIntermediate) {
  for (const char* typed : {"", ".", ",", "+", "0", "0.5"}) { // 0.5 is below 1, but 0.5 may go
    EXPECT_EQ(stateOf(typed), QValidator::Intermediate) << typed;
  }
}

TEST_F(DecimalFieldTest, WhatCannotBecomeANumberIsInvalid) {
  for (const char* typed : {"x", "2x", "2.5.1", "2,5,1", "2.555", "-", "-2"}) {
    EXPECT_EQ(stateOf(typed), QValidator::Invalid) << typed;
  }
}

TEST_F(DecimalFieldTest, BeyondTheLimitsNothingCanBeTyped) {
  EXPECT_EQ(stateOf("10.01"), QValidator::Invalid);
  EXPECT_EQ(stateOf("10,01"), QValidator::Invalid);
  EXPECT_EQ(stateOf("11"), QValidator::Invalid);
  field_.setRange(-10.0, 10.0);
  EXPECT_EQ(stateOf("-"), QValidator::Intermediate);
  EXPECT_EQ(stateOf("-,"), QValidator::Intermediate);
  EXPECT_EQ(stateOf("-0,5"), QValidator::Acceptable);
  EXPECT_EQ(stateOf("-10.01"), QValidator::Invalid);
}

TEST_F(DecimalFieldTest, PointAndCommaAreBothTheDecimalSign) {
  EXPECT_EQ(stateOf("2,5"), QValidator::Acceptable);
  EXPECT_EQ(shownFor("2,5"), QStringLiteral("2.5"));
  EXPECT_EQ(shownFor("2.5"), QStringLiteral("2.5"));
  EXPECT_EQ(field_.valueFromText(QStringLiteral("2,5")), 2.5);
  field_.setLocale(kGerman);
  EXPECT_EQ(stateOf("2.5"), QValidator::Acceptable);
  EXPECT_EQ(shownFor("2.5"), QStringLiteral("2,5"));
  EXPECT_EQ(shownFor("2,5"), QStringLiteral("2,5"));
  EXPECT_EQ(field_.valueFromText(QStringLiteral("2.5")), 2.5);
  EXPECT_EQ(stateOf("."), QValidator::Intermediate);
  EXPECT_EQ(stateOf("2.555"), QValidator::Invalid); // three decimals, no thousands
}

TEST_F(DecimalFieldTest, TheFirstSignOfAThousandIsTheDecimalSign) {
  field_.setDecimals(3);
  field_.setRange(0.0, 10000.0);
  EXPECT_EQ(shownFor("1,234"), QStringLiteral("1.234"));
  EXPECT_EQ(field_.valueFromText(QStringLiteral("1,234")), 1.234);
  // With both signs it is clear which one is which.
  EXPECT_EQ(stateOf("1,234.5"), QValidator::Acceptable);
  EXPECT_EQ(field_.valueFromText(QStringLiteral("1,234.5")), 1234.5);
}

TEST_F(DecimalFieldTest, SignsInTheUnitDoNotCount) {
  field_.setSuffix(QStringLiteral(" p.c."));
  EXPECT_EQ(stateOf("2,5 p.c."), QValidator::Acceptable);
  EXPECT_EQ(shownFor("2,5 p.c."), QStringLiteral("2.5 p.c."));
  EXPECT_EQ(field_.valueFromText(QStringLiteral("2,5 p.c.")), 2.5);
}

/// A click into the text of a field, with or without the focus that it brings.
void clickInto(DecimalField& field, bool bringsFocus) {
  if (bringsFocus) {
    QFocusEvent focus(QEvent::FocusIn, Qt::MouseFocusReason);
    QApplication::sendEvent(&field, &focus);
  }
  auto* text = field.findChild<QLineEdit*>();
  const QPointF place(text->rect().center());
  for (const auto type : {QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
    QMouseEvent event(type, place, text->mapToGlobal(place), Qt::LeftButton,
                      type == QEvent::MouseButtonPress ? Qt::LeftButton : Qt::NoButton, {});
    QApplication::sendEvent(text, &event);
  }
}

TEST_F(DecimalFieldTest, TheFirstClickSelectsTheNumberAndTheNextSetsTheCaret) {
  field_.setSuffix(QStringLiteral(" m"));
  field_.setValue(2.55);
  field_.resize(120, 30);
  const auto* text = field_.findChild<QLineEdit*>();
  clickInto(field_, true);
  EXPECT_EQ(text->selectedText(), QStringLiteral("2.55"));
  QKeyEvent seven(QEvent::KeyPress, Qt::Key_7, {}, QStringLiteral("7"));
  QApplication::sendEvent(&field_, &seven);
  EXPECT_EQ(field_.text(), QStringLiteral("7 m"));
  clickInto(field_, false);
  EXPECT_FALSE(text->hasSelectedText());
}

TEST_F(DecimalFieldTest, AnotherLanguageWritesTheNumberAnew) {
  field_.setValue(2.5);
  EXPECT_EQ(field_.text(), QStringLiteral("2.50"));
  int changes = 0;
  QObject::connect(&field_, &QDoubleSpinBox::valueChanged, &field_, [&] { ++changes; });
  field_.setLocale(kGerman);
  EXPECT_EQ(field_.text(), QStringLiteral("2,50"));
  EXPECT_EQ(field_.value(), 2.5);
  EXPECT_EQ(changes, 0);
}

} // namespace
} // namespace dewpoint::tests
