// SPDX-License-Identifier: GPL-3.0-or-later
// Results that leave the real window while it tracks: the dialog, the switch, and what arrives.
#include "core/base/text_file.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/broadcast/output_controller.h"
#include "ui/broadcast/output_dialog.h"
#include "ui/document/document.h"
#include "ui/session/session_controller.h"
#include "ui/workbench/workbench.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QUndoStack>

#include <algorithm>

namespace dewpoint::tests {

class OutputWindowTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup() { window_.reset(); }
  void resultsAreSentOnceSwitchedOn();
  void withoutOutputsTheDialogOpens();
  void aWrongAddressIsSaidInTheDialog();
  void anotherProjectSendsNothing();

private:
  OutputController& outputs() { return *window_->findChild<OutputController*>(); }
  Document& document() { return window_->workbench().document; }
  OutputDialog* dialog() { return find<OutputDialog>("outputDialog"); }
  void accept() {
    QTest::mouseClick(dialog()->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok),
                      Qt::LeftButton);
  }
  /// Chooses a CSV file in the dialog.
  void sendTo(const QString& file);
  std::string sent() const { return readTextFile(path("sent.csv")).value_or(std::string()); }
};

void OutputWindowTest::init() {
  makeWindow({.play = false});
  QVERIFY(!action("actionSendResults")->isEnabled());
  openDemo();
}

void OutputWindowTest::sendTo(const QString& file) {
  action("actionOutputs")->trigger();
  find<QLineEdit>("outputCsv")->setText(file);
  accept();
  QVERIFY(waitFor([&] { return window_->findChild<OutputDialog*>() == nullptr; }));
}

void OutputWindowTest::resultsAreSentOnceSwitchedOn() {
  const int steps = document().undoStack()->count();
  sendTo(file("sent.csv"));
  QCOMPARE(document().undoStack()->count(), steps + 1);
  QVERIFY(!outputs().isSending()); // nobody has switched it on
  QVERIFY(sent().empty());
  auto* send = action("actionSendResults");
  QSignalSpy changed(&outputs(), &OutputController::changed);
  send->trigger();
  QVERIFY(outputs().isSending() || changed.wait(kTimeoutMs));
  QVERIFY(send->isChecked());
  auto* label = find<QLabel>("outputLabel");
  QVERIFY(label->isVisible());
  QTRY_VERIFY_WITH_TIMEOUT(label->toolTip().contains(QStringLiteral("CSV lines to ")), kTimeoutMs);
  window_->setLanguage(QStringLiteral("de"));
  QTRY_VERIFY_WITH_TIMEOUT(label->toolTip().contains(QStringLiteral("CSV-Zeilen an ")), kTimeoutMs);
  window_->setLanguage(QStringLiteral("en"));
  window_->workbench().session.play();
  QVERIFY(waitFor([&] {
    const std::string text = sent();
    return text.starts_with("time_s,frame,") && std::count(text.begin(), text.end(), '\n') > 5;
  }));
  send->trigger();
  QVERIFY(!outputs().isSending());
  QVERIFY(!send->isChecked());
  QVERIFY(!find<QLabel>("outputLabel")->isVisible());
}

void OutputWindowTest::withoutOutputsTheDialogOpens() {
  action("actionSendResults")->trigger();
  QVERIFY(dialog()->isVisible());
  QVERIFY(!action("actionSendResults")->isChecked());
  QTest::keyClick(dialog(), Qt::Key_Escape);
}

void OutputWindowTest::aWrongAddressIsSaidInTheDialog() {
  const auto before = document().project();
  action("actionOutputs")->trigger();
  find<QLineEdit>("outputOsc")->setText(QStringLiteral("nowhere"));
  accept();
  auto* problem = find<QLabel>("outputProblem");
  QVERIFY(problem->isVisible());
  QVERIFY2(problem->text().contains(QStringLiteral("osc")), qPrintable(problem->text()));
  QVERIFY(document().project() == before);
  QTest::keyClick(dialog(), Qt::Key_Escape);
}

void OutputWindowTest::anotherProjectSendsNothing() {
  sendTo(file("sent2.csv"));
  QSignalSpy changed(&outputs(), &OutputController::changed);
  action("actionSendResults")->trigger();
  QVERIFY(outputs().isSending() || changed.wait(kTimeoutMs));
  open();
  QVERIFY(!outputs().isSending());
  QVERIFY(!action("actionSendResults")->isChecked());
}

DEWPOINT_WINDOW_TEST(OutputWindowTest)

} // namespace dewpoint::tests

#include "output_window_test.moc"
