// SPDX-License-Identifier: GPL-3.0-or-later
// Getting about: the Tab key, the palette, messages, and views that are raised.
#include "core/project/project_save.h"
#include "core/session/run/tracking_run.h"
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/recorded_demo.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/actions/action_registry.h"
#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/image_pick_overlay.h"
#include "ui/document/document.h"
#include "ui/selection/selection.h"
#include "ui/widgets/hue_ring.h"
#include "ui/widgets/message_bar.h"
#include "ui/widgets/range_bar.h"

#include <QDockWidget>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>
#include <QTreeWidget>

#include <map>

namespace dewpoint::tests {

class KeyboardFocusTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init() { makeWindow(); }
  void cleanup() { window_.reset(); }
  void tabStaysOutOfWhatLiesBehindAnotherTab();
  void thePaletteFindsViewsAndLanguages();
  void languagesBeginWithTheirName();
  void aNoticeGoesByItself();
  void anotherProjectOpensWhileARangeIsSelected();
  void aRaisedViewComesToTheFrontWhileThereIsAMessage();
};

void KeyboardFocusTest::tabStaysOutOfWhatLiesBehindAnotherTab() {
  openDemo();
  auto* front = find<QDockWidget>("parameterDock");
  front->raise();
  const std::vector<QDockWidget*> behind{find<QDockWidget>("targetDock"),
                                         find<QDockWidget>("colorDock"),
                                         find<QDockWidget>("cameraListDock")};
  QVERIFY(waitFor([front] { return !front->visibleRegion().isEmpty(); }));
  bool wasInFront = false;
  constexpr int kMoreThanThereAre = 150;
  for (int key = 0; key < kMoreThanThereAre; ++key) {
    QTest::keyClick(QApplication::focusWidget() != nullptr ? QApplication::focusWidget()
                                                           : static_cast<QWidget*>(window_.get()),
                    Qt::Key_Tab);
    const QWidget* now = QApplication::focusWidget();
    wasInFront = wasInFront || (now != nullptr && front->isAncestorOf(now));
    for (const QDockWidget* dock : behind) {
      QVERIFY2(now == nullptr || !dock->isAncestorOf(now), qPrintable(dock->objectName()));
    }
  }
  QVERIFY(wasInFront);
}

void KeyboardFocusTest::aRaisedViewComesToTheFrontWhileThereIsAMessage() {
  openDemo();
  auto* messages = window_->findChild<MessageBar*>();
  messages->showNotice(QStringLiteral("something to say"));
  for (const char* name : {"colorDock", "trajectoryDock", "parameterDock", "plotDock"}) {
    auto* dock = find<QDockWidget>(name);
    dock->raise();
    QVERIFY2(waitFor([dock] { return !dock->visibleRegion().isEmpty(); }), name);
    QVERIFY(messages->isVisible());
  }
}

/// The table asked the run that was gone already for the selected span.
void KeyboardFocusTest::anotherProjectOpensWhileARangeIsSelected() {
  openDemo();
  QVERIFY(waitFor([this] { return window_->shown()->frame >= 10; }));
  window_->selection().selectRange(SelectedRange{2, 5});
  open();
  QVERIFY(!window_->selection().selectedRange());
  QVERIFY(isOpen(2));
}

void KeyboardFocusTest::thePaletteFindsViewsAndLanguages() {
  openDemo();
  auto* history = find<QDockWidget>("historyDock");
  QVERIFY(!history->isVisible());
  action("actionPalette")->trigger();
  auto* search = find<QLineEdit>("paletteSearch");
  QTest::keyClicks(search, QStringLiteral("history"));
  QTest::keyClick(search, Qt::Key_Return);
  QVERIFY(waitFor([&] { return history->isVisible(); }));
  action("actionPalette")->trigger();
  QTest::keyClicks(search, QStringLiteral("zzzz"));
  auto* list = find<QListWidget>("paletteList");
  QCOMPARE(list->count(), 1);
  QVERIFY(list->item(0)->text().contains(QStringLiteral("zzzz")));
  QTest::keyClick(search, Qt::Key_Return); // nothing to run: ready for another word
  QVERIFY(search->isVisible());
  QTest::keyClicks(search, QStringLiteral("deutsch"));
  QTest::keyClick(search, Qt::Key_Return);
  QVERIFY(waitFor([this] { return !action("actionPlay")->text().contains("Play"); }));
  window_->setLanguage(QStringLiteral("en"));
}

void KeyboardFocusTest::languagesBeginWithTheirName() {
  QStringList names;
  for (const QAction* one : window_->findChildren<QAction*>()) {
    if (one->objectName().startsWith(QLatin1String("qt_language_"))) {
      names << one->text();
    }
  }
  for (const auto* name : {"Deutsch", "English (US)", "Español (España)", "日本語"}) {
    QVERIFY2(names.contains(QString::fromUtf8(name)), qPrintable(names.join(QLatin1Char('/'))));
  }
}

void KeyboardFocusTest::aNoticeGoesByItself() {
  openDemo();
  Project project = window_->document().project();
  QVERIFY(saveProject(project, file("kept.toml").toStdString()));
  window_->openProject(file("kept.toml").toStdString());
  QVERIFY(waitFor([this] { return !window_->document().project().file.empty(); }));
  QVERIFY(isOpen(2));
  QVERIFY(draws(*window_));
  const QRect before = find<QDockWidget>("birdsEyeDock")->geometry();
  action("actionSave")->trigger();
  auto* message = find<QLabel>("messageText");
  QVERIFY(waitFor([&] { return message->isVisible(); }));
  QVERIFY(message->text().contains(QStringLiteral("kept.toml")));
  QVERIFY(QTest::qWaitFor([&] { return !message->isVisible(); }, 10 * kTimeoutMs));
  // What it pushed down is where it was.
  QVERIFY(waitFor([&] { return find<QDockWidget>("birdsEyeDock")->geometry() == before; }));
}

DEWPOINT_WINDOW_TEST(KeyboardFocusTest)

} // namespace dewpoint::tests

#include "keyboard_focus_test.moc"
