// SPDX-License-Identifier: GPL-3.0-or-later
// What helps to find a fault: the check of the project, the self-test, and the report of a crash.
#include "core/base/text_file.h"
#include "core/setup/doctor/finding.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/document/document.h"
#include "ui/help/crash_reports.h"
#include "ui/help/problem_report.h"
#include "ui/help/project_check_dialog.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/workbench.h"

#include <QCheckBox>
#include <QClipboard>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTextBrowser>

#include <algorithm>
#include <filesystem>

namespace dewpoint::tests {

class FindingFaultsTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init() { makeWindow({.play = false}); }
  void cleanup() { window_.reset(); }
  void aGoodProjectHasNoProblems();
  void problemsComeFirstWithWhatToDo();
  void theSelfTestGoesIntoTheReport();
  void theSelfTestCanBeCanceled();
  void aCrashIsReportedOnce();
  void otherQuestionsAreAskedAgainAfterwards();

private:
  ProjectCheckDialog* check();
  static void click(QPushButton* button) { QTest::mouseClick(button, Qt::LeftButton); }
};

ProjectCheckDialog* FindingFaultsTest::check() {
  action("actionCheckProject")->trigger();
  auto* dialog = find<ProjectCheckDialog>("projectCheck");
  return waitFor([&] { return !dialog->isRunning(); }) ? dialog : nullptr;
}

void FindingFaultsTest::aGoodProjectHasNoProblems() {
  QVERIFY(!action("actionCheckProject")->isEnabled()); // there is nothing to check yet
  openDemo();
  auto* dialog = check();
  QVERIFY(dialog != nullptr);
  QVERIFY(!dialog->findings().empty());
  QVERIFY(worstLevelOf(dialog->findings()) != FindingLevel::Problem);
  QVERIFY(find<QLabel>("checkSummary")->text().startsWith(QStringLiteral("No problems")));
  click(find<QPushButton>("checkCopy"));
  QVERIFY(QApplication::clipboard()->text().startsWith(
      QLatin1String(levelName(dialog->findings().front().level()))));
  QSignalSpy checked(dialog, &ProjectCheckDialog::checkEnded);
  find<QCheckBox>("checkEveryFrame")->setChecked(true);
  click(find<QPushButton>("checkAgain"));
  QVERIFY(dialog->isRunning());
  click(find<QPushButton>("checkCancel"));
  QVERIFY(checked.wait(kTimeoutMs));
  QVERIFY(!dialog->isRunning());
}

void FindingFaultsTest::problemsComeFirstWithWhatToDo() {
  openDemo();
  QVERIFY(window_->workbench()
              .document
              .edit(QStringLiteral("Change the radius"),
                    [](Project& project) {
                      project.targets.front().radius = 12.0; // millimeters, probably
                    })
              .has_value());
  auto* dialog = check();
  QVERIFY(dialog != nullptr);
  QCOMPARE(dialog->findings().front().level(), FindingLevel::Problem);
  QVERIFY(std::ranges::is_sorted(dialog->findings(), std::ranges::greater(), &Finding::level));
  QVERIFY(find<QLabel>("checkSummary")->text().contains(QLatin1Char('1')));
  const QString list = find<QTextBrowser>("checkList")->toPlainText();
  QVERIFY2(list.startsWith(QStringLiteral("▲")), qPrintable(list));
  QVERIFY2(list.contains(QStringLiteral("→")), qPrintable(list));
}

void FindingFaultsTest::theSelfTestGoesIntoTheReport() {
  action("actionReportProblem")->trigger();
  auto* report = find<ProblemReport>("problemReport");
  QVERIFY(report->text().contains(QStringLiteral("Self-test:\n(not run)")));
  QSignalSpy tested(report, &ProblemReport::selfTestEnded);
  click(find<QPushButton>("problemTest"));
  QVERIFY(!find<QPushButton>("problemCopy")->isEnabled());
  QVERIFY(tested.wait(kTimeoutMs));
  for (const char* part : {"graphics", "codec", "languages", "tracking"}) {
    QVERIFY2(report->text().contains(QLatin1String(part)), qPrintable(report->text()));
  }
  click(find<QPushButton>("problemCopy"));
  QCOMPARE(QApplication::clipboard()->text(), report->text());
}

void FindingFaultsTest::theSelfTestCanBeCanceled() {
  action("actionReportProblem")->trigger();
  auto* report = find<ProblemReport>("problemReport");
  QSignalSpy tested(report, &ProblemReport::selfTestEnded);
  auto* button = find<QPushButton>("problemTest");
  const QString before = button->text();
  click(button);
  QVERIFY(button->text() != before);
  click(button);
  QVERIFY(tested.wait(kTimeoutMs));
  QCOMPARE(button->text(), before);
  QVERIFY(report->text().contains(QStringLiteral("(canceled)")));
}

void FindingFaultsTest::aCrashIsReportedOnce() {
  const auto folder = path("crashes");
  std::filesystem::create_directories(folder);
  for (int k = 0; k < 8; ++k) {
    QVERIFY(writeTextFile(folder / ("crash-" + std::to_string(k) + ".txt"),
                          "SIGSEGV of window " + std::to_string(k)));
  }
  CrashReports reports(window_->workbench(), folder);
  QSignalSpy searchEnded(&reports, &CrashReports::searchEnded);
  QVERIFY(searchEnded.wait(kTimeoutMs));
  QVERIFY(searchEnded.first().first().toBool());
  QVERIFY(waitFor([&] { return messageText().contains(QStringLiteral("unexpectedly")); }));
  click(find<QPushButton>("messageAnswer0"));
  QVERIFY(
      find<ProblemReport>("problemReport")->text().contains(QStringLiteral("SIGSEGV of window")));
  // They are kept, but not all, and not offered again.
  const auto left = std::filesystem::directory_iterator(folder);
  QCOMPARE(std::distance(begin(left), end(left)), 5);
  CrashReports later(window_->workbench(), folder);
  QSignalSpy again(&later, &CrashReports::searchEnded);
  QVERIFY(again.wait(kTimeoutMs));
  QVERIFY(!again.first().first().toBool());
}

void FindingFaultsTest::otherQuestionsAreAskedAgainAfterwards() {
  const auto folder = path("others");
  std::filesystem::create_directories(folder);
  QVERIFY(writeTextFile(folder / "crash-1.txt", "SIGSEGV"));
  MessageBar& messages = window_->workbench().messages;
  messages.showLastingQuestion(QStringLiteral("Recover?"), {{QStringLiteral("Yes"), [] {}}});
  CrashReports reports(window_->workbench(), folder);
  QSignalSpy searchEnded(&reports, &CrashReports::searchEnded);
  QVERIFY(searchEnded.wait(kTimeoutMs));
  QVERIFY(messageText().contains(QStringLiteral("unexpectedly")));
  messages.showLastingQuestion(QStringLiteral("Calibrate?"), {{QStringLiteral("Yes"), [] {}}});
  messages.dismiss();
  QVERIFY(messageText().contains(QStringLiteral("unexpectedly"))); // the newest first
  messages.withdrawQuestion(QStringLiteral("Recover?"));
  messages.dismiss();
  QVERIFY(!messages.isVisible());
}

DEWPOINT_WINDOW_TEST(FindingFaultsTest)

} // namespace dewpoint::tests

#include "finding_faults_test.moc"
