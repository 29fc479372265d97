// SPDX-License-Identifier: GPL-3.0-or-later
// What a person expects of every window of the desktop: it is where it was, has the system's
// colors, and no slip of a key does harm.
#include "core/project/project.h"
#include "core/project/project_load.h"
#include "core/project/project_save.h"
#include "core/session/session.h"
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/recorded_demo.h"
#include "tests/ui/saved_run.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/actions/action_id.h"
#include "ui/actions/action_registry.h"
#include "ui/document/document.h"
#include "ui/preferences/preferences.h"
#include "ui/session/session_controller.h"
#include "ui/style/theme.h"
#include "ui/text/language.h"
#include "ui/view3d/birds_eye_view.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QThread>
#include <QToolButton>
#include <QTreeWidget>
#include <QUndoStack>
#include <QWindow>

#include <algorithm>
#include <functional>
#include <memory>
#include <set>
#include <utility>

namespace dewpoint::tests {

class DesktopHabitsTest : public QObject, private test::WindowFixture {
  Q_OBJECT
private Q_SLOTS:
  void initTestCase() { useLanguage(QStringLiteral("en")); }
  void init() { makeWindow(kUnseen); }
  void cleanup() { window_.reset(); }
  void assertionsAreOn();
  void everyNamedActionIsDeclared();
  void theWindowIsWhereItWas();
  void theSystemsColorsAreFollowedWhileItRuns();
  void aChosenThemeIsKeptWhateverTheSystemDoes();
  void undoAndRedoAreThoseOfTheHistory();
  void theShortcutEditorNamesActionsAsDeclared();
  void keysChooseTheDirectionOfView();
  void theKeyThatRestartsAsks();
  void theKeyThatPlaysAsksAtTheEnd();
  void dialogsHaveTheirButtonsWhereThePlatformPutsThem();
  void theFilterUsesAsManyThreadsAsChosen();

private:
  /// The test shows the window, where and when it wants to.
  static inline const test::WindowSetup kUnseen{.play = false, .show = false};

  void openDemo();
  static bool looksDark() { return isDarkPalette(QApplication::palette()); }
};

void DesktopHabitsTest::openDemo() {
  window_->show();
  window_->activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(window_.get()));
  open();
  QVERIFY(waitFor([this] { return window_->shown() && action("actionPlay")->isEnabled(); }));
}

void DesktopHabitsTest::assertionsAreOn() {
  bool looked = false;
  Q_ASSERT((looked = true));
  QVERIFY(looked);
}

void DesktopHabitsTest::everyNamedActionIsDeclared() {
  std::set<QString> declared;
  for (const QAction* one : window_->findChild<ActionRegistry*>()->allActions()) {
    declared.insert(one->objectName());
  }
  for (const std::string_view name : kActionNames) {
    const QString text = QString::fromLatin1(name.data(), qsizetype(name.size()));
    QVERIFY2(declared.erase(text) == 1, qPrintable(text));
  }
  QVERIFY(declared.empty());
}

void DesktopHabitsTest::theWindowIsWhereItWas() {
  window_->restoreAndSaveGeometry(); // nothing is kept yet
  window_->setGeometry(140, 120, 1010, 730);
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  const QRect before = window_->geometry();
  QVERIFY(window_->close());
  makeAnotherWindow(kUnseen);
  QVERIFY(window_->size() != before.size());
  window_->restoreAndSaveGeometry();
  QCOMPARE(window_->geometry(), before);
  // Windows that nobody sees, for a picture or a run, change nothing of that.
  makeAnotherWindow(kUnseen);
  window_->resize(900, 600);
  window_->show();
  QVERIFY(window_->close());
  makeAnotherWindow(kUnseen);
  window_->restoreAndSaveGeometry();
  QCOMPARE(window_->geometry(), before);
}

void DesktopHabitsTest::theSystemsColorsAreFollowedWhileItRuns() {
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  QCOMPARE(window_->theme(), Theme::System);
  QVERIFY(!looksDark());
  // As a desktop does when a person chooses dark colors there.
  QApplication::setPalette(QPalette(QColor("#303030"), QColor("#202020")));
  QVERIFY(waitFor([] { return isThemeApplied() && looksDark(); }));
  QCOMPARE(window_->palette().color(QPalette::Window), themePalette(true).color(QPalette::Window));
  QApplication::setPalette(QPalette(QColor("#e0e0e0"), QColor("#f0f0f0")));
  QVERIFY(waitFor([] { return isThemeApplied() && !looksDark(); }));
  // The platform says that its theme is another one: it is asked, and is light as before.
  QEvent change(QEvent::ThemeChange);
  QApplication::sendEvent(window_->windowHandle(), &change);
  QCoreApplication::processEvents();
  QVERIFY(isThemeApplied());
  QVERIFY(!looksDark());
}

void DesktopHabitsTest::aChosenThemeIsKeptWhateverTheSystemDoes() {
  window_->setTheme(Theme::Light);
  QApplication::setPalette(QPalette(QColor("#303030"), QColor("#202020")));
  QVERIFY(waitFor([] { return isThemeApplied(); }));
  QVERIFY(!looksDark());
  window_->setTheme(Theme::System); // which is dark by now
  QVERIFY(looksDark());
  QApplication::setPalette({}); // as it was at first
  QVERIFY(waitFor([] { return isThemeApplied() && !looksDark(); }));
}

void DesktopHabitsTest::undoAndRedoAreThoseOfTheHistory() {
  openDemo();
  QVERIFY(!action("actionUndo")->isEnabled());
  QVERIFY(!action("actionRedo")->isEnabled());
  QVERIFY(window_->document().setParameter("particles", 777));
  const QString step = window_->document().undoStack()->undoText();
  QVERIFY(action("actionUndo")->isEnabled());
  QVERIFY(action("actionUndo")->text().contains(step));
  useLanguage(QStringLiteral("de"));
  QVERIFY(waitFor(
      [this] { return action("actionUndo")->text().startsWith(QStringLiteral("Rückgängig")); }));
  QVERIFY(action("actionUndo")->text().contains(step)); // named when it was made
  useLanguage(QStringLiteral("en"));
  action("actionUndo")->trigger();
  QVERIFY(!action("actionUndo")->isEnabled());
  QVERIFY(action("actionRedo")->text().contains(step));
  action("actionRedo")->trigger();
  QCOMPARE(window_->document().project().parameters.at("particles"), 777.0);
}

void DesktopHabitsTest::theShortcutEditorNamesActionsAsDeclared() {
  openDemo();
  auto* registry = window_->findChild<ActionRegistry*>();
  QVERIFY(window_->document().setParameter("particles", 777));
  const QString undo = action("actionUndo")->text();
  QVERIFY(undo.startsWith(QStringLiteral("Undo: ")));
  action("actionShortcuts")->trigger();
  const auto* tree = find<QTreeWidget>("shortcutTree");
  const auto listed = [&](const char* id) -> QTreeWidgetItem* {
    for (int i = 0; i < tree->topLevelItemCount(); ++i) {
      QTreeWidgetItem* item = tree->topLevelItem(i);
      if (item->data(0, Qt::UserRole).value<QObject*>() == action(id)) {
        return item;
      }
    }
    return nullptr;
  };
  for (const auto& [id, name] : {std::pair("actionUndo", "Undo"), std::pair("actionRedo", "Redo"),
                                 std::pair("actionPlay", "Play")}) {
    const QTreeWidgetItem* item = listed(id);
    QVERIFY2(item != nullptr, id);
    QVERIFY2(item->text(0).endsWith(QStringLiteral("› ") + QLatin1String(name)), id);
    QCOMPARE(item->toolTip(0), registry->hintOf(action(id)));
  }
  // A new shortcut leaves in the menu what would be undone.
  registry->setShortcut(action("actionUndo"), Qt::CTRL | Qt::ALT | Qt::Key_U);
  QCOMPARE(action("actionUndo")->text(), undo);
  QVERIFY(action("actionUndo")->toolTip().contains(QStringLiteral("Ctrl+Alt+U")));
  registry->resetShortcuts();
  QCOMPARE(action("actionUndo")->text(), undo);
}

void DesktopHabitsTest::keysChooseTheDirectionOfView() {
  openDemo();
  const auto* view = window_->findChild<BirdsEyeView*>();
  QVERIFY(view != nullptr);
  for (const auto& choice :
       {std::pair(Qt::Key_A, Scene3d::View::Above), std::pair(Qt::Key_F, Scene3d::View::Front),
        std::pair(Qt::Key_Y, Scene3d::View::Side), std::pair(Qt::Key_V, Scene3d::View::Free)}) {
    QTest::keyClick(window_.get(), choice.first);
    QVERIFY(waitFor([&] { return view->currentView() == choice.second; }));
  }
}

void DesktopHabitsTest::theKeyThatRestartsAsks() {
  openDemo();
  const auto frame = [this] { return shown().history.newestTrackedFrame; };
  const auto reach = [&](std::int64_t wanted) {
    while (frame() < wanted) {
      const auto before = frame();
      action("actionNextFrame")->trigger();
      if (!waitFor([&] { return frame() > before; })) {
        return false;
      }
    }
    return true;
  };
  for (const auto modifier : {Qt::NoModifier, Qt::ShiftModifier}) {
    QVERIFY(reach(3));
    QTest::keyClick(window_.get(), Qt::Key_R, modifier);
    QVERIFY(messageText().contains(QStringLiteral("Restart")));
    QTest::keyClick(window_.get(), Qt::Key_R, modifier); // is no answer
    const auto head = frame();
    QVERIFY(head >= 3);
    QVERIFY(reach(head + 1)); // the run goes on
    QTest::mouseClick(find<QPushButton>("messageAnswer0"), Qt::LeftButton);
    QVERIFY(waitFor([&] { return frame() < head; }));
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // the answers
  }
  // The button is pressed on purpose.
  QVERIFY(reach(3));
  QTest::mouseClick(find<QToolButton>("actionRestartButton"), Qt::LeftButton);
  QVERIFY(waitFor([&] { return frame() < 3; }));
}

void DesktopHabitsTest::theKeyThatPlaysAsksAtTheEnd() {
  openDemo();
  QVERIFY(recordDesk(folder_.path().toStdString())); // it is over soon
  auto desk = loadProject(path("desk.toml"));
  QVERIFY(desk);
  desk->targets = window_->document().project().targets;
  QVERIFY(saveProject(*desk, path("desk.toml")));
  open(path("desk.toml"));
  QVERIFY(waitFor([this] {
    return shown().frameCount == std::int64_t{8} && shown().history.newestTrackedFrame == 0;
  }));
  QSignalSpy restarts(window_->findChild<SessionController*>(),
                      &SessionController::runAboutToRestart);
  const auto isAsked = [this] {
    return messageText().contains(QStringLiteral("Track it again from the beginning?"));
  };
  const auto pressSpace = [this] { QTest::keyClick(window_.get(), Qt::Key_Space); };
  pressSpace(); // there is nothing to lose yet
  QVERIFY(!isAsked());
  QVERIFY(waitFor([this] { return shown().state == PlayState::Ended; }));
  QVERIFY(shown().history.newestTrackedFrame > 0);
  pressSpace();
  QVERIFY(isAsked());
  pressSpace(); // is no answer
  QVERIFY(isAsked());
  QCOMPARE(restarts.count(), 0);
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // the first answer
  find<QPushButton>("messageAnswer0")->click();
  QCOMPARE(restarts.count(), 1);
}

void DesktopHabitsTest::dialogsHaveTheirButtonsWhereThePlatformPutsThem() {
  openDemo();
  for (const char* name : {"actionShortcuts", "actionExportTrajectory", "actionImportCalibration",
                           "actionExportCalibration", "actionExperiments"}) {
    action(name)->trigger();
    const auto dialogs = window_->findChildren<QDialog*>();
    const auto open = std::ranges::find_if(dialogs, &QDialog::isVisible);
    QVERIFY2(open != dialogs.end(), name);
    QVERIFY2((*open)->findChild<QDialogButtonBox*>() != nullptr, name);
    QTest::keyClick(*open, Qt::Key_Escape);
    QVERIFY2(
        waitFor([dialog = QPointer<QDialog>(*open)] { return !dialog || !dialog->isVisible(); }),
        name);
  }
}

void DesktopHabitsTest::theFilterUsesAsManyThreadsAsChosen() {
  const auto threadsOfRun = [&] {
    QFile report(file("run.json"));
    return test::savesRun(*window_, folder_.path().toStdString()) &&
                   report.open(QIODevice::ReadOnly)
               ? QJsonDocument::fromJson(report.readAll()).object().value("threads").toInt()
               : -1;
  };
  const auto choose = [&](int wanted) {
    action("actionFilterThreads")->trigger();
    find<QSpinBox>("threadCount")->setValue(wanted);
    QTest::mouseClick(find<QPushButton>("threadCountAccept"), Qt::LeftButton);
    QVERIFY(waitFor([this] { return window_->findChild<QSpinBox*>("threadCount") == nullptr; }));
  };
  window_->show();
  const int most = QThread::idealThreadCount();
  QCOMPARE(Preferences().filterThreadCount(), 0); // nobody has chosen
  choose(most);
  QCOMPARE(Preferences().filterThreadCount(), most);
  openDemo();
  QCOMPARE(threadsOfRun(), most);
  choose(1); // while it runs
  QVERIFY(waitFor([&] { return threadsOfRun() == 1; }));
}

DEWPOINT_WINDOW_TEST(DesktopHabitsTest)

} // namespace dewpoint::tests

#include "desktop_habits_test.moc"
