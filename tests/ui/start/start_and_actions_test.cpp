// SPDX-License-Identifier: GPL-3.0-or-later
// Beginning, finding one's way and coming back: start page, new projects, actions, recovery.
#include "core/project/project_save.h"
#include "core/session/run/tracking_run.h"
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/recorded_demo.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/actions/action_registry.h"
#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/image_pick_overlay.h"
#include "ui/color/color_learner.h"
#include "ui/document/document.h"
#include "ui/document/project_saver.h"
#include "ui/preferences/preferences.h"
#include "ui/selection/selection.h"
#include "ui/widgets/hue_ring.h"
#include "ui/widgets/range_bar.h"

#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QToolButton>
#include <QTreeWidget>

#include <map>

namespace dewpoint::tests {

class StartAndActionsTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init() { makeWindow(); }
  void cleanup() { window_.reset(); }
  void theStartPageOpensTheDemoAndClosingReturnsToIt();
  void droppedFilesAreOpened();
  void aSavedProjectIsRecent();
  void everyShortcutIsOfOneAction();
  void theKeysOfTheDesktopDoWhatTheyDoElsewhere();
  void thePaletteFindsAnActionByKeyboardAlone();
  void aShortcutCanBeChangedTakenAndReset();
  void theLayoutBelongsToTheProject();
  void namesAndSizesAreUndoable();
  void theStatusIsThatOfTheChosenTarget();
  void workLeftBehindIsOffered();
  void oneClickLearnsAColorAndTracksIt();
  void thePickerIsDraggedByHandAndByKeys();
  void eachOfSeveralColorsIsShownChangedAndTakenAway();
};

void StartAndActionsTest::theStartPageOpensTheDemoAndClosingReturnsToIt() {
  QVERIFY(find<QWidget>("startPage")->isVisible());
  QVERIFY(!action("actionPlay")->isEnabled());
  QVERIFY(!find<QDockWidget>("birdsEyeDock")->isVisible());
  openDemo();
  QVERIFY(find<QDockWidget>("birdsEyeDock")->isVisible());
  action("actionCloseProject")->trigger();
  QVERIFY(waitFor([this] { return find<QWidget>("startPage")->isVisible(); }));
  QVERIFY(!window_->shown());
  QVERIFY(!find<QDockWidget>("birdsEyeDock")->isVisible());
  openDemo(); // and again
}

void StartAndActionsTest::droppedFilesAreOpened() {
  for (const char* name : {"demo.toml", "demo.dewpoint"}) {
    QVERIFY(saveProject(*resolveProject("demo"), path(name)));
    drop({file(name)});
    QVERIFY(waitFor([&] { return window_->document().project().file.filename() == name; }));
  }
}

void StartAndActionsTest::aSavedProjectIsRecent() {
  openDemo();
  QVERIFY(Preferences().recentProjects().isEmpty()); // the demo is no file
  const auto project = resolveProject("demo");
  QVERIFY(saveProject(*project, file("mine.toml").toStdString()));
  window_->openProject(file("mine.toml").toStdString());
  QVERIFY(
      waitFor([this] { return Preferences().recentProjects() == QStringList{file("mine.toml")}; }));
  QVERIFY(isOpen(2));
  action("actionCloseProject")->trigger();
  auto* recent = find<QListWidget>("startRecent");
  QCOMPARE(recent->count(), 1);
  recent->setCurrentRow(0);
  QTest::keyClick(recent, Qt::Key_Return);
  QVERIFY(isOpen(2));
}

void StartAndActionsTest::everyShortcutIsOfOneAction() {
  std::map<QString, QString> holders;
  for (QAction* one : window_->findChild<ActionRegistry*>()->allActions()) {
    for (const QKeySequence& shortcut : one->shortcuts()) {
      const QString keys = shortcut.toString();
      QVERIFY2(holders.emplace(keys, one->objectName()).second,
               qPrintable(keys + QStringLiteral(": ") + holders[keys] + QStringLiteral(", ") +
                          one->objectName()));
    }
  }
}

void StartAndActionsTest::theKeysOfTheDesktopDoWhatTheyDoElsewhere() {
  auto* registry = window_->findChild<ActionRegistry*>();
  const auto holder = [&](const QKeySequence& keys) {
    for (const QAction* one : registry->allActions()) {
      if (one->shortcuts().contains(keys)) {
        return one->objectName();
      }
    }
    return QString();
  };
  QCOMPARE(holder(Qt::Key_F1), QStringLiteral("actionManual"));
  QCOMPARE(holder(Qt::Key_F11), QStringLiteral("actionFullScreen"));
  QCOMPARE(holder(Qt::CTRL | Qt::Key_W), QStringLiteral("actionCloseProject"));
  QCOMPARE(holder(Qt::CTRL | Qt::Key_Y), QStringLiteral("actionRedo"));
  QCOMPARE(holder(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QStringLiteral("actionRedo"));
  QCOMPARE(holder(Qt::CTRL | Qt::Key_P), QString()); // prints nothing
  QCOMPARE(holder(Qt::CTRL | Qt::Key_D), QString());
  // Whoever wants one of the two for something else gets it, in the next window as well.
  registry->setShortcut(action("actionAddMark"), Qt::CTRL | Qt::Key_Y);
  QCOMPARE(holder(Qt::CTRL | Qt::Key_Y), QStringLiteral("actionAddMark"));
  QCOMPARE(holder(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QStringLiteral("actionRedo"));
  MainWindow other(&openProject);
  QCOMPARE(other.findChild<QAction*>("actionRedo")->shortcuts(),
           QList<QKeySequence>{Qt::CTRL | Qt::SHIFT | Qt::Key_Z});
  registry->resetShortcuts();
  QCOMPARE(holder(Qt::CTRL | Qt::Key_Y), QStringLiteral("actionRedo"));
}

void StartAndActionsTest::thePaletteFindsAnActionByKeyboardAlone() {
  openDemo();
  QVERIFY(!action("actionShowMask")->isChecked());
  QTest::keyClick(window_.get(), Qt::Key_K, Qt::ControlModifier);
  auto* search = find<QLineEdit>("paletteSearch");
  QVERIFY(waitFor([&] { return search->isVisible(); }));
  QTest::keyClicks(search, QStringLiteral("show mask"));
  QTest::keyClick(search, Qt::Key_Return);
  QVERIFY(waitFor([this] { return action("actionShowMask")->isChecked(); }));
  QVERIFY(!search->isVisible());
}

void StartAndActionsTest::aShortcutCanBeChangedTakenAndReset() {
  action("actionShortcuts")->trigger();
  auto* tree = find<QTreeWidget>("shortcutTree");
  auto* keys = find<QKeySequenceEdit>("shortcutKeys");
  const auto choose = [&](const char* id) {
    for (int i = 0; i < tree->topLevelItemCount(); ++i) {
      QTreeWidgetItem* item = tree->topLevelItem(i);
      if (item->data(0, Qt::UserRole).value<QObject*>() == action(id)) {
        tree->setCurrentItem(item);
        return;
      }
    }
    QFAIL("not listed");
  };
  choose("actionRestart");
  keys->setKeySequence(Qt::Key_M); // the mask's
  Q_EMIT keys->editingFinished();
  QCOMPARE(action("actionRestart")->shortcut(), QKeySequence(Qt::Key_M));
  QVERIFY(action("actionShowMask")->shortcut().isEmpty());
  QVERIFY(find<QLabel>("shortcutNote")->text().contains(QStringLiteral("Show mask")));
  QVERIFY(action("actionRestart")->toolTip().contains(QStringLiteral("(M)")));

  // It is the person's: the next window knows it.
  MainWindow other(&openProject);
  QCOMPARE(other.findChild<QAction*>("actionRestart")->shortcut(), QKeySequence(Qt::Key_M));

  QTest::mouseClick(find<QPushButton>("shortcutResetAll"), Qt::LeftButton);
  QCOMPARE(action("actionRestart")->shortcut(), QKeySequence(Qt::Key_R));
  QCOMPARE(action("actionShowMask")->shortcut(), QKeySequence(Qt::Key_M));
}

void StartAndActionsTest::theLayoutBelongsToTheProject() {
  const auto project = resolveProject("demo");
  const auto place = file("layout.toml").toStdString();
  QVERIFY(saveProject(*project, place));
  window_->openProject(place);
  QVERIFY(isOpen(2));
  auto* birdsEye = find<QDockWidget>("birdsEyeDock");
  birdsEye->setFloating(true);
  action("actionSave")->trigger();
  QVERIFY(waitFor([this] { return !window_->saver().isSaving(); }));
  QVERIFY(!window_->document().isUnsaved());
  makeAnotherWindow();
  window_->openProject(place);
  QVERIFY(isOpen(2));
  QVERIFY(find<QDockWidget>("birdsEyeDock")->isFloating());
  action("actionResetLayout")->trigger();
  QVERIFY(!find<QDockWidget>("birdsEyeDock")->isFloating());
}

void StartAndActionsTest::namesAndSizesAreUndoable() {
  openDemo();
  auto* name = find<QLineEdit>("targetName");
  find<QDockWidget>("targetDock")->raise();
  name->setFocus();
  name->setText(QStringLiteral("my ball"));
  QTest::keyClick(name, Qt::Key_Return);
  QVERIFY(!name->hasFocus()); // the keys go to the window
  QCOMPARE(window_->document().project().targets[0].name, std::string("my ball"));
  // The session follows: what it publishes next is called so.
  QVERIFY(waitFor([this] { return window_->shown()->targets.at(0).target.name == "my ball"; }));
  QVERIFY(action("actionUndo")->text().contains(QStringLiteral("Rename target")));
  action("actionUndo")->trigger();
  QCOMPARE(name->text(), QStringLiteral("pink ball"));

  action("actionRemoveTarget")->trigger();
  QVERIFY(waitFor([this] { return window_->shown()->targets.empty(); }));
  action("actionUndo")->trigger();
  QVERIFY(waitFor([this] { return window_->shown()->targets.size() == 1; }));
}

void StartAndActionsTest::theStatusIsThatOfTheChosenTarget() {
  window_->setPlayOnOpen(false); // a run that rests: nothing new comes by itself
  openDemo();
  QVERIFY(window_->document().edit(QStringLiteral("Add target"), [](Project& project) {
    Target other = project.targets.front();
    other.name = "other";
    other.color.hueMin = 100.0; // nothing in the demo is green
    other.color.hueMax = 110.0;
    project.targets.push_back(other);
  }));
  QVERIFY(waitFor([this] { return window_->shown()->targets.size() == 2; }));
  auto* held = find<QLabel>("statusHeld");
  window_->selection().selectTarget(1);
  QVERIFY2(held->text().startsWith(QStringLiteral("other")), qPrintable(held->text()));
  window_->selection().selectTarget(0);
  QVERIFY2(held->text().startsWith(QStringLiteral("pink ball")), qPrintable(held->text()));
}

void StartAndActionsTest::workLeftBehindIsOffered() {
  // What an earlier window left: a copy, and where the project was loaded from.
  const auto recovery = std::filesystem::path(folder_.path().toStdString()) / "recovery";
  std::filesystem::create_directories(recovery);
  auto project = *resolveProject("demo");
  project.name = "half done";
  QVERIFY(saveProject(project, recovery / "0123.toml"));
  window_->enableRecovery(recovery);
  QVERIFY(waitFor([this] { return messageText().contains(QStringLiteral("half done")); }));
  QTest::mouseClick(find<QPushButton>("messageAnswer0"), Qt::LeftButton);
  QVERIFY(isOpen(2));
  QCOMPARE(window_->document().project().name, std::string("half done"));
  QVERIFY(window_->document().isUnsaved());
  // This window has a copy of its own soon, and the old one is gone.
  QVERIFY(waitFor([&] { return !std::filesystem::exists(recovery / "0123.toml"); }));
}

void StartAndActionsTest::oneClickLearnsAColorAndTracksIt() {
  QVERIFY(recordDemo(folder_.path().toStdString()));
  drop({file("left.mkv"), file("right.mkv"), file("calibration.toml")});
  auto* create = find<QPushButton>("newCreate");
  QVERIFY(waitFor([&] { return create->isEnabled(); }));
  QTest::mouseClick(create, Qt::LeftButton);
  QVERIFY(isOpen(2));
  QVERIFY(window_->document().project().targets.empty());

  // The ball of the demo's first frame, as the first camera sees it: (0.5, 0.5, 0.15) m.
  const auto at = Projector(demoRig()[0]).project({0.5, 0.5, 0.15});
  auto* view = find<CameraView>("cameraView0");
  QVERIFY(waitFor([&] { return !view->imageSize().isEmpty(); }));
  const QPointF place = view->placement().topLeft +
                        (QPointF(at->x(), at->y()) + QPointF(0.5, 0.5)) * view->placement().scale;
  auto* layer = find<ImagePickOverlay>("cameraView0Pick");
  QTest::mouseClick(layer, Qt::LeftButton, Qt::NoModifier, place.toPoint());
  QVERIFY(waitFor([this] { return window_->document().project().targets.size() == 1; }));
  QVERIFY(action("actionShowMask")->isChecked()); // all cameras show what was learned
  QVERIFY(waitFor([this] {
    const auto& targets = window_->shown()->targets;
    return !targets.empty() && std::get<SphereEstimate>(targets[0].estimate).isValid &&
           window_->shown()->frame > 2;
  }));
  // 35 mm: the ball's radius; the path of eight frames is shorter.
  const Eigen::Vector3d mean = std::get<SphereEstimate>(window_->shown()->targets[0].estimate).mean;
  QVERIFY((mean - Eigen::Vector3d(0.5, 0.5, 0.15)).norm() < 0.035);
  QVERIFY(find<QLabel>("colorAssessment")->text().contains(QStringLiteral("of 100")));
  // The other camera was found to show the same.
  QCOMPARE(find<QListWidget>("colorSamples")->count(), 2);
  const auto samples = [this] { return window_->document().project().targets[0].samples; };
  QVERIFY(!samples()[0].isFoundByGeometry && samples()[1].isFoundByGeometry);
  QCOMPARE(samples()[1].camera, 1);
  const auto other = Projector(demoRig()[1]).project({0.5, 0.5, 0.15});
  QVERIFY(std::hypot(samples()[1].x - other->x(), samples()[1].y - other->y()) <
          24.0); // its radius

  // One more sample by Shift-click; taken away again, and all of it undone.
  QTest::mouseClick(layer, Qt::LeftButton, Qt::ShiftModifier, place.toPoint() + QPoint(3, 3));
  QVERIFY(waitFor([this] { return find<QListWidget>("colorSamples")->count() == 3; }));
  const auto* listed = find<QListWidget>("colorSamples"); // two of one image can be told apart
  QVERIFY(listed->item(0)->text() != listed->item(1)->text());
  // The same with Ctrl excludes, where a desktop keeps Alt for itself. The place: a red-free one.
  QTest::mouseClick(layer, Qt::LeftButton, Qt::ShiftModifier | Qt::ControlModifier,
                    view->placement().topLeft.toPoint() + QPoint(5, 5));
  QVERIFY(waitFor([this] { return find<QListWidget>("colorSamples")->count() == 4; }));
  QVERIFY(samples()[2].isExcluded && !samples()[1].isExcluded);
  action("actionUndo")->trigger();
  QVERIFY(waitFor([this] { return find<QListWidget>("colorSamples")->count() == 3; }));
  find<QListWidget>("colorSamples")->setCurrentRow(1);
  QTest::mouseClick(find<QPushButton>("colorRemoveSample"), Qt::LeftButton);
  QVERIFY(waitFor([this] { return find<QListWidget>("colorSamples")->count() == 2; }));
  // What was found and is taken away is not the target, and is not found again.
  find<QListWidget>("colorSamples")->setCurrentRow(1);
  QTest::mouseClick(find<QPushButton>("colorRemoveSample"), Qt::LeftButton);
  QVERIFY(waitFor([&] { return samples()[1].isExcluded; }));
  QCOMPARE(samples().size(), std::size_t{2});
  for (int i = 0; i < 4; ++i) {
    action("actionUndo")->trigger();
  }
  QVERIFY(window_->document().project().targets.empty());
  // The assessment was of that target.
  const auto* learner = window_->findChild<ColorLearner*>();
  QVERIFY(waitFor([&] { return !learner->isBusy(); })); // another may be under way
  QVERIFY(!find<QLabel>("colorAssessment")->text().contains(QStringLiteral("of 100")));

  // The same place by keys: the cross begins in the middle, Ctrl and an arrow move it by a pixel.
  layer->setFocus();
  const QPointF middle(view->imageSize().width() / 2 - 1, view->imageSize().height() / 2 - 1);
  const auto press = [&](double way, Qt::Key less, Qt::Key more) {
    for (int i = 0; i < static_cast<int>(std::lround(std::abs(way))); ++i) {
      QTest::keyClick(layer, way < 0.0 ? less : more, Qt::ControlModifier);
    }
  };
  press(at->x() - middle.x(), Qt::Key_Left, Qt::Key_Right);
  press(at->y() - middle.y(), Qt::Key_Up, Qt::Key_Down);
  QTest::keyClick(layer, Qt::Key_Return);
  QVERIFY(waitFor([this] { return window_->document().project().targets.size() == 1; }));
}

void StartAndActionsTest::thePickerIsDraggedByHandAndByKeys() {
  openDemo();
  find<QDockWidget>("colorDock")->raise();
  auto* ring = find<HueRing>("hueRing");
  QVERIFY(waitFor([&] { return ring->isVisible() && ring->width() > 100; }));
  const auto color = [this] { return window_->document().project().targets[0].color; };
  const ColorRange before = color();
  // The first end lies at the hue's angle, counterclockwise from the right, half a ring inside.
  const auto point = [&](double hue) {
    const double radius = std::min(ring->width(), ring->height()) / 2.0 - 19.0;
    const double angle = hue * 3.14159265 / 180.0;
    return QPointF(ring->width() / 2.0 + radius * std::cos(angle),
                   ring->height() / 2.0 - radius * std::sin(angle))
        .toPoint();
  };
  QTest::mousePress(ring, Qt::LeftButton, Qt::NoModifier, point(before.hueMin));
  for (int step = 1; step <= 10; ++step) {
    QTest::mouseMove(ring, point(before.hueMin - 2.0 * step));
  }
  QTest::mouseRelease(ring, Qt::LeftButton, Qt::NoModifier, point(before.hueMin - 20.0));
  QVERIFY(std::abs(color().hueMin - (before.hueMin - 20.0)) < 2.0); // a pixel is about a degree
  QCOMPARE(color().hueMax, before.hueMax);
  action("actionUndo")->trigger(); // the whole drag is one step
  QCOMPARE(color().hueMin, before.hueMin);

  auto* bar = find<RangeBar>("saturationBar");
  bar->setFocus(Qt::TabFocusReason);
  QTest::keyClick(bar, Qt::Key_Right);
  QVERIFY(std::abs(color().saturationMin - (before.saturationMin + 0.01)) < 1e-9);
  QTest::keyClick(bar, Qt::Key_Tab);
  QTest::keyClick(bar, Qt::Key_Left, Qt::ShiftModifier);
  QVERIFY(std::abs(color().saturationMax - (before.saturationMax - 0.1)) < 1e-9);
}

void StartAndActionsTest::eachOfSeveralColorsIsShownChangedAndTakenAway() {
  openDemo();
  find<QDockWidget>("colorDock")->raise();
  auto* choice = find<QWidget>("colorChoice");
  QVERIFY(!choice->isVisible());
  const ColorRange first = window_->document().project().targets[0].color;
  const ColorRange second{50.0, 70.0, 0.4, 1.0, 0.1, 0.9};
  QVERIFY(window_->document().edit(QStringLiteral("two colors"), [&](Project& project) {
    project.targets[0].otherColors = {second};
  }));
  const auto target = [this] { return window_->document().project().targets[0]; };
  QVERIFY(choice->isVisible());
  QCOMPARE(find<QDoubleSpinBox>("hueFrom")->value(), first.hueMin);
  QTest::mouseClick(find<QToolButton>("color2"), Qt::LeftButton);
  QCOMPARE(find<QDoubleSpinBox>("hueFrom")->value(), second.hueMin);
  find<QDoubleSpinBox>("hueFrom")->setValue(45.0);
  QCOMPARE(target().otherColors.at(0).hueMin, 45.0);
  QVERIFY(target().color == first);
  QCOMPARE(find<QDoubleSpinBox>("hueFrom")->value(), 45.0);

  QTest::mouseClick(find<QToolButton>("colorRemove"), Qt::LeftButton);
  QVERIFY(target().otherColors.empty());
  QVERIFY(target().color == first);
  QVERIFY(!choice->isVisible());
  QCOMPARE(find<QDoubleSpinBox>("hueFrom")->value(), first.hueMin);
  action("actionUndo")->trigger();
  QCOMPARE(target().otherColors.size(), std::size_t{1});
  QVERIFY(choice->isVisible());
}

DEWPOINT_WINDOW_TEST(StartAndActionsTest)

} // namespace dewpoint::tests

#include "start_and_actions_test.moc"
