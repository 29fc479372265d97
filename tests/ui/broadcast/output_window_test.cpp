// SPDX-License-Identifier: GPL-3.0-or-later
// Results that leave the real window while it tracks: the dialog, the switch, and what arrives.
#include "core/base/text_file.h"
#include "core/broadcast/transport/file_descriptor.h"
#include "tests/ui/gate.h"
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
#include <arpa/inet.h>
#include <memory>
#include <netinet/in.h>
#include <string>
#include <sys/socket.h>

namespace dewpoint::tests {
namespace {

/// Connects to a port of this computer, sends a text, and returns the connection; its number is -1
/// if that failed.
broadcast::FileDescriptor connected(const std::string& address, const std::string& text) {
  const auto colon = address.rfind(':');
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(std::stoi(address.substr(colon + 1))));
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  broadcast::FileDescriptor connection(::socket(AF_INET, SOCK_STREAM, 0));
  if (::connect(connection.number(), reinterpret_cast<const sockaddr*>(&place), sizeof place) !=
          0 ||
      ::send(connection.number(), text.data(), text.size(), 0) <= 0) {
    connection.close();
  }
  return connection;
}

/// What a browser gets from a page of this computer.
std::string loadedPage(const std::string& address) {
  const auto browser = connected(address, "GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n");
  std::string page;
  if (browser.number() >= 0) {
    char part = 0;
    while (::recv(browser.number(), &part, 1, 0) == 1) {
      page += part;
    }
  }
  return page;
}

} // namespace

class OutputWindowTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup() { window_.reset(); }
  void resultsAreSentOnceSwitchedOn();
  void withoutOutputsTheDialogOpens();
  void aWrongAddressIsSaidInTheDialog();
  void anotherProjectSendsNothing();
  void thePageHasTheLanguageOfTheWindow();
  void outputsThatHangHoldNobodyUp();

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

void OutputWindowTest::thePageHasTheLanguageOfTheWindow() {
  QVERIFY(document().edit(QStringLiteral("Set outputs"),
                          [](Project& project) { project.output.webSocketPort = 0; }));
  QSignalSpy changed(&outputs(), &OutputController::changed);
  action("actionSendResults")->trigger();
  QVERIFY(outputs().isSending() || changed.wait(kTimeoutMs));
  const std::string address = outputs().outletReports().at(0).address;
  QVERIFY(loadedPage(address).find("<html lang=\"en") != std::string::npos);
  window_->setLanguage(QStringLiteral("de"));
  QVERIFY(
      waitFor([&] { return loadedPage(address).find("<html lang=\"de") != std::string::npos; }));
  window_->setLanguage(QStringLiteral("en"));
}

// A thread of the outputs that does not return: the window neither waits for it nor opens the port
// that it still has.
void OutputWindowTest::outputsThatHangHoldNobodyUp() {
  QVERIFY(document().edit(QStringLiteral("Set outputs"), [](Project& project) {
    project.output.tcpPort = 0;
    project.output.token = "a secret of the test";
  }));
  const auto gate = std::make_shared<test::Gate>();
  outputs().setOpener([gate](broadcast::BroadcastInputs inputs) {
    inputs.receiver = [gate](const broadcast::RemoteCommand&) -> Status {
      gate->pass();
      return {};
    };
    return broadcast::Broadcaster::open(inputs);
  });
  QSignalSpy changed(&outputs(), &OutputController::changed);
  auto* send = action("actionSendResults");
  send->trigger();
  QVERIFY(outputs().isSending() || changed.wait(kTimeoutMs));
  const auto client = connected(outputs().outletReports().at(0).address,
                                "{\"token\":\"a secret of the test\",\"command\":\"start\"}\n");
  QVERIFY(client.number() >= 0);
  QVERIFY(waitFor([&] { return gate->waiting() == 1; }));
  send->trigger();
  QVERIFY(!outputs().isSending());
  QVERIFY(send->isEnabled());
  send->trigger(); // on again, which has to wait
  letTimePass(50); // nothing must happen
  QVERIFY(!outputs().isSending());
  QCOMPARE(gate->waiting(), 1);
  open(); // another project takes the place of the one whose outputs hang
  QVERIFY(send->isEnabled());
  QVERIFY(!send->isChecked());
  QVERIFY(document().edit(QStringLiteral("Set outputs"),
                          [](Project& project) { project.output.tcpPort = 0; }));
  send->trigger();
  gate->open();
  QVERIFY(waitFor([&] { return outputs().isSending(); }));
}

DEWPOINT_WINDOW_TEST(OutputWindowTest)

} // namespace dewpoint::tests

#include "output_window_test.moc"
