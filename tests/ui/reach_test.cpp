// SPDX-License-Identifier: GPL-3.0-or-later
// Beginning, finding one's way and coming back: start page, new projects, actions, recovery.
#include "app/wiring/open_project.h"
#include "core/session/run/snapshot.h"
#include "core/session/run/tracking_run.h"
#include "tests/ui/recorded_demo.h"
#include "ui/actions/action_registry.h"
#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/image_pick_overlay.h"
#include "ui/document/document.h"
#include "ui/mainwindow/main_window.h"
#include "ui/selection/selection.h"
#include "ui/view3d/birds_eye_view.h"
#include "ui/widgets/hue_ring.h"
#include "ui/widgets/message_bar.h"
#include "ui/widgets/range_bar.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QDropEvent>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>
#include <QUrl>

#include <map>
#include <memory>

namespace dewpoint::tests {

namespace {

constexpr int kPatienceMs =
    DEWPOINT_PATIENCE_MS; ///< software OpenGL, a loaded machine, a sanitizer

} // namespace

class ReachTest : public QObject {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup();
  void tabStaysOutOfWhatLiesBehindAnotherTab();
  void thePaletteFindsViewsAndLanguages();
  void aNoticeMovesNothingAndGoes();
  void anotherProjectOpensWhileASpanIsSelected();
  void aRaisedViewComesToTheFrontBelowTheMessage();

private:
  template <class T> T* find(const char* name) {
    T* found = window_->findChild<T*>(QLatin1String(name));
    if (found == nullptr) {
      qFatal("no child named %s", name);
    }
    return found;
  }
  QAction* action(const char* name) { return find<QAction>(name); }
  QString file(const char* name) const { return folder_.filePath(QLatin1String(name)); }
  bool waitFor(const std::function<bool()>& holds) { return QTest::qWaitFor(holds, kPatienceMs); }
  bool isOpen(std::size_t cameras) {
    return waitFor([&] {
      return window_->shown() && window_->shown()->frame >= 0 &&
             window_->shown()->rig->size() == cameras && find<QWidget>("start")->isHidden();
    });
  }
  void openDemo() {
    QTest::mouseClick(find<QToolButton>("startDemo"), Qt::LeftButton);
    QVERIFY(isOpen(2));
  }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

void ReachTest::init() {
  QSettings().clear();
  window_ = std::make_unique<MainWindow>(&openProject);
  window_->show();
  window_->activateWindow();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
}

void ReachTest::cleanup() {
  window_.reset();
}

void ReachTest::tabStaysOutOfWhatLiesBehindAnotherTab() {
  openDemo();
  auto* front = find<QDockWidget>("parameterDock");
  front->raise();
  const std::vector<QDockWidget*> behind{find<QDockWidget>("targetDock"),
                                         find<QDockWidget>("colorDock"),
                                         find<QDockWidget>("cameraListDock")};
  QTest::qWait(50);
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

void ReachTest::aRaisedViewComesToTheFrontBelowTheMessage() {
  openDemo();
  auto* messages = window_->findChild<MessageBar*>();
  messages->showNotice(QStringLiteral("something to say"));
  for (const char* name : {"colorDock", "trajectoryDock", "parameterDock", "plotDock"}) {
    auto* dock = find<QDockWidget>(name);
    dock->raise();
    QVERIFY2(waitFor([dock] { return !dock->visibleRegion().isEmpty(); }), name);
    QVERIFY(waitFor([&] { return window_->children().last() == messages; }));
  }
}

/// The table asked the run that was gone already for the selected span.
void ReachTest::anotherProjectOpensWhileASpanIsSelected() {
  openDemo();
  QVERIFY(waitFor([this] { return window_->shown()->frame >= 10; }));
  window_->selection().selectSpan(FrameSpan{2, 5});
  QSignalSpy opened(window_.get(), &MainWindow::projectOpened);
  window_->openProject({});
  QVERIFY(opened.wait(kPatienceMs));
  QVERIFY(!window_->selection().span());
  QVERIFY(isOpen(2));
}

void ReachTest::thePaletteFindsViewsAndLanguages() {
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

void ReachTest::aNoticeMovesNothingAndGoes() {
  openDemo();
  const QRect before = find<QDockWidget>("birdsEyeDock")->geometry();
  Project project = window_->document().project();
  QVERIFY(saveProject(project, file("kept.toml").toStdString()));
  window_->openProject(file("kept.toml").toStdString());
  QVERIFY(waitFor([this] { return !window_->document().project().file.empty(); }));
  QVERIFY(isOpen(2));
  action("actionSave")->trigger();
  auto* message = find<QLabel>("messageText");
  QVERIFY(waitFor([&] { return message->isVisible(); }));
  QVERIFY(message->text().contains(QStringLiteral("kept.toml")));
  QCOMPARE(find<QDockWidget>("birdsEyeDock")->geometry(), before);
  find<QDockWidget>("birdsEyeDock")->raise(); // what is raised does not cover it
  QVERIFY(waitFor([&] { return window_->children().last() == message->parentWidget(); }));
  QVERIFY(QTest::qWaitFor([&] { return !message->isVisible(); }, 10 * kPatienceMs));
}

} // namespace dewpoint::tests

int main(int argc, char** argv) {
  dewpoint::ui::BirdsEyeView::prepareSurfaceFormat();
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("dewpoint-test"));
  QApplication::setApplicationName(QStringLiteral("reach"));
  dewpoint::tests::ReachTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "reach_test.moc"
