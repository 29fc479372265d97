// SPDX-License-Identifier: GPL-3.0-or-later
// The menu Help: each view has a page of the manual, pages and pictures are found, and what helps
// with a report can be copied.
#include "core/tracking/catalog/method_catalog.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/document/document.h"
#include "ui/help/help_installer.h"
#include "ui/help/manual_browser.h"
#include "ui/help/manual_pages.h"
#include "ui/help/manual_window.h"
#include "ui/help/message_history.h"
#include "ui/help/problem_report.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/dock_manager.h"
#include "ui/workbench/workbench.h"

#include <QClipboard>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextBlock>
#include <QToolButton>

namespace dewpoint::tests {

class HelpTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init() { makeWindow({.play = false}); }
  void cleanup() { window_.reset(); }
  void menusStandInTheUsualOrder();
  void everyViewHasAPageThatIsThere();
  void f1OpensThePageOfTheViewInUse();
  void linksAndPicturesOfThePagesWork();
  void aMissingManualIsSaidWithItsFolder();
  void everyHelpOpensAndCloses_data();
  void everyHelpOpensAndCloses();
  void theReportNamesVersionsAndTheLastMessages();
  void messagesCanBeReadAgainAndCopied();
  void theLicenseCanBeRead();
};

void HelpTest::menusStandInTheUsualOrder() {
  QStringList names;
  for (const QAction* one : find<QMenuBar>("menuBar")->actions()) {
    names.append(one->menu()->objectName());
  }
  QCOMPARE(names, QStringList({"menuFile", "menuEdit", "menuView", "menuCalibration", "menuRun",
                               "menuHelp"}));
}

void HelpTest::everyViewHasAPageThatIsThere() {
  openDemo();
  const QString folder = findManual(manualFolders());
  QVERIFY(!folder.isEmpty());
  for (const QString& page : manualPages()) {
    QVERIFY2(QDir(folder).exists(page), qPrintable(page));
  }
  std::vector<std::string> methods = methodNames();
  methods.emplace_back("another");
  for (const ViewDock* dock : window_->workbench().docks.docks()) {
    for (const std::string& method : methods) {
      const QString page = manualPageOf(dock->objectName(), QString::fromStdString(method));
      QVERIFY2(QDir(folder).exists(page) && manualPages().contains(page), qPrintable(page));
    }
  }
  QCOMPARE(manualPageOf(QStringLiteral("parameterDock"), QStringLiteral("sugandi")),
           QStringLiteral("method-sugandi.md"));
}

void HelpTest::f1OpensThePageOfTheViewInUse() {
  QVERIFY(QTest::qWaitForWindowActive(window_.get()));
  QCOMPARE(manualPageForFocusedView(window_->workbench()), QStringLiteral("quick-start.md"));
  openDemo();
  find<QWidget>("plotStack")->setFocus();
  QTest::keyClick(window_.get(), Qt::Key_F1);
  auto* manual = find<ManualWindow>("manualWindow");
  QVERIFY(waitFor([&] { return manual->isVisible(); }));
  QCOMPARE(manual->shownPage(), QStringLiteral("plots.md"));
  // The same window shows the page of another view.
  window_->activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(window_.get()));
  find<QWidget>("methodChoice")->setFocus();
  action("actionManual")->trigger();
  QCOMPARE(manual->shownPage(), QStringLiteral("method-dewpoint.md"));
  QCOMPARE(window_->findChildren<ManualWindow*>().size(), 1);
}

void HelpTest::linksAndPicturesOfThePagesWork() {
  action("actionManual")->trigger();
  auto* manual = find<ManualWindow>("manualWindow");
  auto* text = find<ManualBrowser>("manualText");
  manual->showPage(QStringLiteral("window.md"));
  const auto picture = [text] {
    const QUrl name(QStringLiteral("images/window-dark.png"));
    return text->document()->resource(QTextDocument::ImageResource, name).value<QImage>();
  };
  QVERIFY(picture().width() > 300 && picture().width() < text->width());
  // Room for it is there at once, and the picture soon.
  QVERIFY(waitFor([&] { return picture().pixelColor(picture().rect().center()).alpha() == 255; }));
  QVERIFY(waitFor([&] { return text->hasLoadedImages(); }));
  // From page to page, to a heading in it, and back.
  text->setSource(
      text->source().resolved(QUrl(QStringLiteral("method-dewpoint.md#12-targets-of-any-shape"))));
  QCOMPARE(manual->shownPage(), QStringLiteral("method-dewpoint.md"));
  QCOMPARE(text->textCursor().block().text(), QStringLiteral("12. Targets of any shape"));
  QVERIFY(text->verticalScrollBar()->value() > 0);
  auto* list = find<QListWidget>("manualList");
  QCOMPARE(list->currentItem()->data(Qt::UserRole).toString(),
           QStringLiteral("method-dewpoint.md"));
  QTest::mouseClick(find<QToolButton>("manualBack"), Qt::LeftButton);
  QCOMPARE(manual->shownPage(), QStringLiteral("window.md"));
  // What is no page changes nothing.
  text->setSource(text->source().resolved(QUrl(QStringLiteral("examples"))));
  QVERIFY(text->toPlainText().startsWith(QStringLiteral("The window"))); // its heading
}

void HelpTest::aMissingManualIsSaidWithItsFolder() {
  QCOMPARE(findManual({file("nowhere"), file("neither")}), QString());
  ManualWindow manual({}, file("nowhere"), window_.get());
  manual.showPage(QStringLiteral("window.md"));
  const auto* missing = manual.findChild<QLabel*>(QStringLiteral("manualMissing"));
  QVERIFY(!missing->isHidden());
  QVERIFY(missing->text().contains(file("nowhere")));
}

void HelpTest::everyHelpOpensAndCloses_data() {
  QTest::addColumn<QString>("id");
  QTest::addColumn<QString>("dialog");
  QTest::newRow("manual") << "actionManual"
                          << "manualWindow";
  QTest::newRow("methods") << "actionMethods"
                           << "manualWindow";
  QTest::newRow("quick start") << "actionQuickStart"
                               << "quickStart";
  QTest::newRow("legend") << "actionLegend"
                          << "overlayLegend";
  QTest::newRow("messages") << "actionMessages"
                            << "messageHistory";
  QTest::newRow("report") << "actionReportProblem"
                          << "problemReport";
  QTest::newRow("about") << "actionAbout"
                         << "aboutDialog";
}

void HelpTest::everyHelpOpensAndCloses() {
  QFETCH(QString, id);
  QFETCH(QString, dialog);
  openDemo();
  QVERIFY(find<QMenu>("menuHelp")->actions().contains(find<QAction>(id)));
  find<QAction>(id)->trigger();
  auto* opened = find<QDialog>(dialog);
  QVERIFY(waitFor([&] { return opened->isVisible(); }));
  QVERIFY(!opened->isModal());
  QVERIFY(opened->height() <= 740); // fits a small screen
  QVERIFY(dialog != QLatin1String("overlayLegend") || opened->width() <= 1000);
  for (const QLabel* label : opened->findChildren<QLabel*>()) {
    if (label->isVisible() && label->wordWrap()) { // nothing is cut off
      QVERIFY2(label->height() >= label->heightForWidth(label->width()), qPrintable(label->text()));
    }
  }
  QTest::keyClick(opened, Qt::Key_Escape);
  QVERIFY(waitFor([&] { return window_->findChild<QDialog*>(dialog) == nullptr; }));
}

void HelpTest::theReportNamesVersionsAndTheLastMessages() {
  window_->workbench().messages.showError(QStringLiteral("the lens fell off"));
  action("actionReportProblem")->trigger();
  const QString report = find<ProblemReport>("problemReport")->text();
  for (const char* part : {"Dewpoint " DEWPOINT_VERSION, "Qt 6", "OpenCV 4", "VTK 9",
                           "OpenGL: ", "System: ", "Language: ", "the lens fell off"}) {
    QVERIFY2(report.contains(QLatin1String(part)), part);
  }
  QTest::mouseClick(find<QPushButton>("problemCopy"), Qt::LeftButton);
  QCOMPARE(QApplication::clipboard()->text(), report);
}

void HelpTest::messagesCanBeReadAgainAndCopied() {
  MessageBar& messages = window_->workbench().messages;
  for (int k = 1; k <= 40; ++k) { // more than a report has
    messages.showNotice(QStringLiteral("notice %1.").arg(k));
  }
  messages.showError(QStringLiteral("room.toml: cameras: there is none"));
  messages.dismiss();
  action("actionMessages")->trigger();
  auto* history = find<MessageHistory>("messageHistory");
  QVERIFY(waitFor([&] { return history->isVisible(); }));
  const QStringList lines = history->text().split(QLatin1Char('\n'));
  QVERIFY(lines.size() >= 41);
  const QRegularExpression form(QStringLiteral("^\\d\\d:\\d\\d:\\d\\d  [●◆▲]  "));
  QVERIFY2(form.match(lines.last()).hasMatch(), qPrintable(lines.last()));
  QVERIFY(lines.last().contains(QStringLiteral("▲")));
  QVERIFY(lines.last().endsWith(QStringLiteral("room.toml: cameras: there is none")));
  QVERIFY(lines.at(lines.size() - 41).endsWith(QStringLiteral("notice 1.")));
  // What comes while it is open is added; the same window is shown again.
  messages.record(QStringLiteral("camera 1 is silent"), Severity::Warning);
  action("actionMessages")->trigger();
  QCOMPARE(window_->findChildren<MessageHistory*>().size(), 1);
  QVERIFY(history->text().endsWith(QStringLiteral("camera 1 is silent")));
  QTest::mouseClick(find<QPushButton>("messageHistoryCopy"), Qt::LeftButton);
  QCOMPARE(QGuiApplication::clipboard()->text(), history->text());
  // The search for actions finds it first.
  history->close();
  action("actionPalette")->trigger();
  auto* search = find<QLineEdit>("paletteSearch");
  search->setText(QStringLiteral("messages"));
  const QListWidgetItem* found = find<QListWidget>("paletteList")->currentItem();
  QVERIFY(found != nullptr);
  QCOMPARE(found->text(), QStringLiteral("Help › Messages"));
  search->window()->close();
}

void HelpTest::theLicenseCanBeRead() {
  action("actionAbout")->trigger();
  QVERIFY(find<QLabel>("aboutName")->text().contains(QStringLiteral(DEWPOINT_VERSION)));
  QVERIFY(find<QLabel>("aboutCitation")->text().contains(QStringLiteral(DEWPOINT_VERSION)));
  QTest::mouseClick(find<QPushButton>("aboutShowLicense"), Qt::LeftButton);
  auto* license = find<QPlainTextEdit>("aboutLicenseText");
  QVERIFY(license->isVisible());
  QVERIFY(license->toPlainText().contains(QStringLiteral("GNU GENERAL PUBLIC LICENSE")));
}

DEWPOINT_WINDOW_TEST(HelpTest)

} // namespace dewpoint::tests

#include "help_test.moc"
