// SPDX-License-Identifier: GPL-3.0-or-later
// Messages that come and go while the user types: nothing moves.
#include "tests/ui/calibration/calibration_window.h"
#include "tests/ui/window_test.h"
#include "ui/widgets/message_bar.h"
#include "ui/widgets/message_row.h"

#include <QApplication>
#include <QDoubleSpinBox>
#include <QWheelEvent>

#include <cstdlib>

namespace dewpoint::tests {

class MessageRoomTest : public QObject, private test::CalibrationWindow {
  Q_OBJECT

private Q_SLOTS:
  void init() { openCalibration(); }
  void cleanup() { window_.reset(); }
  void aMessageThatGoesLeavesItsRoom();
  void theWheelOverAnImageEndsTheRoom();
  void aFieldThatIsLeftMayEndTheMessage();
  void aMessageThatComesLiesOverTheViews();

private:
  static constexpr int kStill = 12; ///< pixels that nobody minds
  MessageBar* messages() { return window_->findChild<MessageBar*>(); }
  int roomHeight() { return window_->findChild<MessageRow*>()->height(); }
  /// Where the image of the first camera begins in the window.
  int top() { return layer(0)->mapTo(window_.get(), QPoint(0, 0)).y(); }
  QDoubleSpinBox* typeInTheForm();
};

QDoubleSpinBox* MessageRoomTest::typeInTheForm() {
  auto* field = find<QDoubleSpinBox>("handPositionX");
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, QStringLiteral("1"));
  return field;
}

void MessageRoomTest::aMessageThatGoesLeavesItsRoom() {
  messages()->showError(QStringLiteral("something is wrong"));
  QVERIFY(waitFor([this] { return roomHeight() > kStill; }));
  QVERIFY(draws(*window_));
  const int before = top();
  QVERIFY(typeInTheForm()->hasFocus());
  messages()->dismiss();
  letTimePass(1000); // it would have moved
  QVERIFY(!messages()->isVisible());
  QVERIFY2(std::abs(top() - before) <= kStill, qPrintable(QString::number(top() - before)));
  layer(0)->setFocus();
  QVERIFY(waitFor([this] { return roomHeight() == 0; }));
  QVERIFY(waitFor([&] { return top() < before - kStill; }));
}

// Not only the press on the image, when a drag begins.
void MessageRoomTest::theWheelOverAnImageEndsTheRoom() {
  messages()->showError(QStringLiteral("something is wrong"));
  QVERIFY(waitFor([this] { return roomHeight() > kStill; }));
  auto* field = typeInTheForm();
  messages()->dismiss();
  const auto turn = [](QWidget* under) {
    const QPointF at(under->rect().center());
    QWheelEvent event(at, under->mapToGlobal(at), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(under, &event);
  };
  turn(find<QWidget>("handPage")); // scrolls the form
  letTimePass(1000);
  QVERIFY(roomHeight() > kStill);
  turn(layer(0));
  QVERIFY(waitFor([this] { return roomHeight() == 0; }));
  QVERIFY(field->hasFocus());
}

void MessageRoomTest::aFieldThatIsLeftMayEndTheMessage() {
  messages()->showError(QStringLiteral("something is wrong"));
  QVERIFY(waitFor([this] { return roomHeight() > kStill; }));
  QVERIFY(draws(*window_));
  const int before = top();
  auto* field = typeInTheForm();
  connect(field, &QDoubleSpinBox::editingFinished, messages(), &MessageBar::dismiss);
  QTest::keyClick(field, Qt::Key_Tab);
  QVERIFY(!field->hasFocus());
  letTimePass(1000);
  QVERIFY(!messages()->isVisible());
  QVERIFY2(std::abs(top() - before) <= kStill, qPrintable(QString::number(top() - before)));
}

void MessageRoomTest::aMessageThatComesLiesOverTheViews() {
  QVERIFY(waitFor([this] { return roomHeight() == 0; }));
  QVERIFY(draws(*window_));
  const int before = top();
  QVERIFY(typeInTheForm()->hasFocus());
  messages()->showError(QStringLiteral("something is wrong"));
  letTimePass(1000);
  QVERIFY(messages()->isVisible());
  QVERIFY(messages()->height() > kStill);
  QVERIFY(std::abs(top() - before) <= kStill);
  // It can be seen, and used.
  const QPoint middle = messages()->geometry().center();
  const QRect at = messages()->geometry();
  QVERIFY2(
      window_->rect().contains(at),
      qPrintable(
          QStringLiteral("%1 %2 %3 %4").arg(at.x()).arg(at.y()).arg(at.width()).arg(at.height())));
  const QWidget* there = window_->childAt(middle);
  QVERIFY2(there == messages() || messages()->isAncestorOf(there),
           there == nullptr ? "none" : there->metaObject()->className());
  layer(0)->setFocus();
  QVERIFY(waitFor([this] { return roomHeight() >= messages()->height(); }));
  QVERIFY(waitFor([&] { return top() > before + kStill; }));
}

DEWPOINT_WINDOW_TEST(MessageRoomTest)

} // namespace dewpoint::tests

#include "message_room_test.moc"
