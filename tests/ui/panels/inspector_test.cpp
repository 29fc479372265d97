// SPDX-License-Identifier: GPL-3.0-or-later
// The panels of the inspector: the method and its parameters, the targets, how colors are learned,
// and what the docks are called.
#include "core/geometry/projector.h"
#include "core/project/project.h"
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/image_pick_overlay.h"
#include "ui/document/document.h"
#include "ui/panels/target_row_delegate.h"
#include "ui/text/tracking_state_text.h"
#include "ui/widgets/collapsible_section.h"
#include "ui/widgets/path_field.h"

#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListView>
#include <QListWidget>
#include <QPushButton>
#include <QScrollBar>
#include <QSlider>
#include <QToolButton>
#include <QUndoStack>

#include <algorithm>

namespace dewpoint::tests {

class InspectorTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup() { window_.reset(); }
  void fewParametersAreInSightAndTheRestInSections();
  void aChangedParameterIsMarkedAndReset();
  void backspaceOnASliderResetsIt();
  void allParametersAreResetInOneStep();
  void aBoundThatCountsIsSaidAtBothParameters();
  void theVolumeIsOpenOnlyWhenItIsSet();
  void buttonsOfTheTargetPanelDoWhatTheirActionsDo();
  void rowsOfTargetsSayStateAndSize();
  void theEyeOfARowHidesItsTarget();
  void samplesAreAddedAndExcludedByButtons();
  void aNameStandsInTheTabOrInTheTitle();
  void aLongPathIsCutAtItsBeginning();

private:
  double value(const char* key) { return window_->document().project().parameters.at(key); }
  bool isMarked(const char* key) {
    return !find<QToolButton>(QStringLiteral("reset_") + QLatin1String(key))->isHidden() &&
           !find<QLabel>(QStringLiteral("dot_") + QLatin1String(key))->isHidden();
  }
  QString note(const char* key) {
    const auto* label = find<QLabel>(QStringLiteral("note_") + QLatin1String(key));
    return label->isHidden() ? QString() : label->text();
  }
  QUndoStack& history() { return *window_->document().undoStack(); }
  /// A place of the first target in the image of the first camera, in its view.
  QPoint placeInImage();
};

void InspectorTest::init() {
  makeWindow({.size = {1500, 950}, .theme = Theme::Light, .play = false});
  open();
  QVERIFY(waitFor([this] { return shown().history.newestTrackedFrame == 0; }));
}

void InspectorTest::fewParametersAreInSightAndTheRestInSections() {
  int inSight = 0;
  for (const ParameterDeclaration& one : window_->document().project().parameters.declarations()) {
    const auto* slider = find<QSlider>(QStringLiteral("slider_") + QString::fromStdString(one.key));
    QCOMPARE(slider->isVisible(), one.group == ParameterGroup::Essential);
    inSight += slider->isVisible() ? 1 : 0;
  }
  QCOMPARE(inSight, 3);
  auto* expert = find<CollapsibleSection>("group_Expert");
  QVERIFY(!expert->isOpen());
  expert->findChild<QToolButton*>("sectionHead")->click();
  QVERIFY(find<QSlider>("slider_kld_error")->isVisible());
  // It is as the user left it when the form is made again.
  window_->document().setMethod("dynamics");
  QVERIFY(waitFor([this] { return window_->findChild<QSlider*>("slider_kld_error") == nullptr; }));
  QVERIFY(find<CollapsibleSection>("group_Expert")->isOpen());
  QVERIFY(!find<CollapsibleSection>("group_Search and start")->isOpen());
}

void InspectorTest::aChangedParameterIsMarkedAndReset() {
  const double before = value("kld_error");
  QVERIFY(!isMarked("kld_error"));
  auto* mark = find<CollapsibleSection>("group_Expert")->findChild<QLabel*>();
  QVERIFY(mark->isHidden());
  find<QDoubleSpinBox>("box_kld_error")->setValue(0.4);
  QCOMPARE(value("kld_error"), 0.4);
  QVERIFY(isMarked("kld_error"));
  QVERIFY(!isMarked("particles"));
  QVERIFY(!mark->isHidden()); // seen while the section is closed
  find<QToolButton>("reset_kld_error")->click();
  QCOMPARE(value("kld_error"), before);
  QCOMPARE(find<QDoubleSpinBox>("box_kld_error")->value(), before);
  QVERIFY(!isMarked("kld_error"));
  QVERIFY(mark->isHidden());
  action("actionUndo")->trigger();
  QCOMPARE(value("kld_error"), 0.4);
  QVERIFY(isMarked("kld_error"));
  action("actionUndo")->trigger();
  QVERIFY(!isMarked("kld_error"));
}

void InspectorTest::backspaceOnASliderResetsIt() {
  const double before = value("particles");
  auto* slider = find<QSlider>("slider_particles");
  for (const Qt::Key key : {Qt::Key_Backspace, Qt::Key_Delete}) {
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_PageUp);
    QVERIFY(value("particles") > before);
    QTest::keyClick(slider, key);
    QCOMPARE(value("particles"), before);
  }
}

void InspectorTest::allParametersAreResetInOneStep() {
  auto* all = find<QPushButton>("parametersReset");
  QVERIFY(!all->isEnabled());
  const ParameterValues before = window_->document().project().parameters;
  QVERIFY(window_->document().setParameter("particles", 200.0));
  QVERIFY(window_->document().setParameter("start_x", 3.0));
  QVERIFY(isMarked("start_x"));
  QVERIFY(all->isEnabled());
  const int steps = history().count();
  all->click();
  QCOMPARE(history().count(), steps + 1);
  QCOMPARE(value("particles"), before.at("particles"));
  QVERIFY(!isMarked("start_x"));
  QVERIFY(!all->isEnabled());
  action("actionUndo")->trigger();
  QCOMPARE(value("particles"), 200.0);
  QCOMPARE(value("start_x"), 3.0);
}

void InspectorTest::aBoundThatCountsIsSaidAtBothParameters() {
  QVERIFY(note("particles").isEmpty() && note("fewest_particles").isEmpty());
  QVERIFY(window_->document().setParameter("particles", 50.0));
  QCOMPARE(note("fewest_particles"),
           QStringLiteral("This value is larger than “Particles”, so 50 is used instead."));
  QCOMPARE(
      note("particles"),
      QStringLiteral(
          "This value is smaller than “Minimum particles”, so “Minimum particles” has no effect."));
  QVERIFY(window_->document().setParameter("fewest_particles", 50.0));
  QVERIFY(note("particles").isEmpty() && note("fewest_particles").isEmpty());
}

void InspectorTest::theVolumeIsOpenOnlyWhenItIsSet() {
  auto* section = find<CollapsibleSection>("group_volume");
  QVERIFY(!section->isOpen());
  find<QPushButton>("volumeFromCameras")->click();
  QVERIFY(window_->document().project().volumeOfInterest);
  QVERIFY(section->isOpen());
  window_->document().setMethod("barrera");
  QVERIFY(waitFor([this] { return window_->findChild<QSlider*>("slider_kld_error") == nullptr; }));
  QVERIFY(find<CollapsibleSection>("group_volume")->isOpen());
}

void InspectorTest::buttonsOfTheTargetPanelDoWhatTheirActionsDo() {
  find<QDockWidget>("targetDock")->raise();
  QVERIFY(waitFor([this] { return find<QToolButton>("targetAdd")->isVisible(); }));
  auto* learn = find<QToolButton>("targetLearn");
  QVERIFY(learn->isEnabled() && !learn->isChecked());
  learn->click();
  QVERIFY(action("actionLearnColor")->isChecked() && learn->isChecked());
  learn->click();
  QVERIFY(!action("actionLearnColor")->isChecked() && !learn->isChecked());
  find<QToolButton>("targetRemove")->click();
  QVERIFY(window_->document().project().targets.empty());
  action("actionUndo")->trigger();
  QCOMPARE(window_->document().project().targets.size(), std::size_t{1});
  auto* add = find<QToolButton>("targetAdd");
  add->click();
  QVERIFY(action("actionAddTarget")->isChecked() && add->isChecked()); // the next click makes one
  QVERIFY(!action("actionLearnColor")->isChecked() && !learn->isChecked());
  QVERIFY(find<QToolButton>("colorLearn")->isChecked());
  QVERIFY(!find<QToolButton>("colorAddSample")->isEnabled());
  // Another way to use a click ends it.
  learn->click();
  QVERIFY(action("actionLearnColor")->isChecked() && !add->isChecked());
  add->click();
  QVERIFY(add->isChecked() && !learn->isChecked());
  action("actionCorrectPosition")->setChecked(true);
  QVERIFY(!add->isChecked() && !find<QToolButton>("colorLearn")->isChecked());
  add->click();
  QVERIFY(add->isChecked() && !action("actionCorrectPosition")->isChecked());
  add->click();
  QVERIFY(!add->isChecked() && !learn->isChecked());
  // Over a calibration page the click belongs to the new target.
  action("actionCalibrateByHand")->setChecked(true);
  add->click();
  QVERIFY(add->isChecked() && learn->isChecked());
  learn->click();
  QVERIFY(!add->isChecked() && !learn->isChecked());
}

void InspectorTest::rowsOfTargetsSayStateAndSize() {
  const auto rows = [this] {
    return static_cast<TargetRowDelegate*>(find<QListView>("targetList")->itemDelegate())->rows();
  };
  action("actionNextFrame")->trigger();
  action("actionNextFrame")->trigger();
  QVERIFY(waitFor([&] { return rows().size() == 1 && rows()[0].state == TrackingState::Held; }));
  QVERIFY(rows()[0].sizeText.startsWith(QStringLiteral("radius ")));
  // As soon as there are a few frames to compute it from.
  action("actionNextFrame")->trigger();
  action("actionNextFrame")->trigger();
  QVERIFY(waitFor([&] { return rows()[0].speedText.endsWith(QStringLiteral(" m/s")); }));
  QVERIFY(!rows()[0].sizeText.contains(QStringLiteral("found"))); // the demo gives it
  QVERIFY(rows()[0].learnedColor && *rows()[0].learnedColor != rows()[0].identityColor);
  QVERIFY(window_->document().edit(QStringLiteral("no radius"),
                                   [](Project& project) { project.targets[0].radius = 0.0; }));
  action("actionNextFrame")->trigger();
  QVERIFY(waitFor([&] { return rows()[0].sizeText.contains(QStringLiteral("(estimated)")); }));
}

void InspectorTest::theEyeOfARowHidesItsTarget() {
  action("actionNextFrame")->trigger();
  QVERIFY(waitFor([this] { return shown().isTracked; }));
  find<QDockWidget>("targetDock")->raise();
  auto* list = find<QListView>("targetList");
  QVERIFY(waitFor([&] { return list->isVisible(); }));
  auto* view = find<CameraView>("cameraView0");
  QVERIFY(settles(*view));
  const QImage with = view->grab().toImage();
  const auto isShown = [this] { return window_->document().project().targets[0].isShown; };
  const QRect eye = TargetRowDelegate::eyeIconArea(list->visualRect(list->model()->index(0, 0)));
  QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::NoModifier, eye.center());
  QVERIFY(!isShown());
  QVERIFY(waitFor([this] { return !shown().targets[0].target.isShown; }));
  QVERIFY(settles(*view));
  QVERIFY(view->grab().toImage() != with);
  QVERIFY(!static_cast<TargetRowDelegate*>(list->itemDelegate())->rows()[0].isShown);
  action("actionUndo")->trigger();
  QVERIFY(waitFor([this] { return shown().targets[0].target.isShown; }));
  QVERIFY(settles(*view));
  QCOMPARE(view->grab().toImage(), with);
  action("actionHideTarget")->trigger();
  QVERIFY(!isShown());
  action("actionHideTarget")->trigger();
  QVERIFY(isShown());
}

QPoint InspectorTest::placeInImage() {
  const auto* view = find<CameraView>("cameraView0");
  const auto mean = positionOf(shown().targets.at(0).estimate);
  const auto pixel = Projector((*shown().rig)[0]).project(mean->mean);
  return (view->placement().topLeft +
          (QPointF(pixel->x(), pixel->y()) + QPointF(0.5, 0.5)) * view->placement().scale)
      .toPoint();
}

void InspectorTest::samplesAreAddedAndExcludedByButtons() {
  find<QDockWidget>("colorDock")->raise();
  auto* learn = find<QToolButton>("colorLearn");
  auto* add = find<QToolButton>("colorAddSample");
  auto* exclude = find<QToolButton>("colorExclude");
  QVERIFY(waitFor([&] { return learn->isVisible() && exclude->isVisible(); }));
  QVERIFY(add->isEnabled() && !exclude->isEnabled()); // the demo's color was given, not learned
  QVERIFY(waitFor([this] { return !shown().targets.empty(); }));
  action("actionNextFrame")->trigger();
  QVERIFY(waitFor([this] { return shown().frame == 1 && shown().isTracked; }));
  auto* layer = find<ImagePickOverlay>("cameraView0Pick");
  const QPoint place = placeInImage();
  const auto samples = [this] { return window_->document().project().targets[0].samples; };
  QVERIFY(!find<QLabel>("targetHint")->isHidden());
  learn->click();
  QVERIFY(action("actionLearnColor")->isChecked());
  QTest::mouseClick(layer, Qt::LeftButton, Qt::NoModifier, place);
  QVERIFY(waitFor([&] { return !samples().empty() && !learn->isChecked(); })); // for one click
  const std::size_t learned = samples().size();
  QVERIFY(add->isEnabled() && exclude->isEnabled());
  QVERIFY(find<QLabel>("targetHint")->isHidden()); // there is nothing left to do
  const auto* list = find<QListWidget>("colorSamples");
  QVERIFY2(!list->horizontalScrollBar()->isVisible(), qPrintable(list->item(0)->text()));
  action("actionPlay")->isChecked() ? action("actionPlay")->trigger() : (void)0;
  add->click();
  QVERIFY(add->isChecked() && action("actionLearnColor")->isChecked());
  QTest::mouseClick(layer, Qt::LeftButton, Qt::NoModifier, place + QPoint(2, 2));
  QVERIFY(waitFor([&] { return samples().size() == learned + 1; }));
  QVERIFY(add->isChecked()); // samples come in numbers
  exclude->click();
  QVERIFY(exclude->isChecked() && !add->isChecked());
  const QPoint corner = find<CameraView>("cameraView0")->placement().topLeft.toPoint();
  QTest::mouseClick(layer, Qt::LeftButton, Qt::NoModifier, corner + QPoint(5, 5));
  QVERIFY(waitFor([&] {
    return std::ranges::count_if(samples(), [](const auto& one) { return one.isExcluded; }) == 1;
  }));
  QTest::keyClick(layer, Qt::Key_Escape);
  QVERIFY(!exclude->isChecked() && !action("actionLearnColor")->isChecked());
  action("actionUndo")->trigger();
  QCOMPARE(samples().size(), learned + 1);
}

void InspectorTest::aNameStandsInTheTabOrInTheTitle() {
  const auto* tabbed = find<QLabel>("parameterDockTitleName");
  const auto* alone = find<QLabel>("birdsEyeDockTitleName");
  QVERIFY(waitFor([&] { return tabbed->isHidden(); }));
  QVERIFY(!alone->isHidden());
  auto* dock = find<QDockWidget>("parameterDock");
  dock->setFloating(true);
  QVERIFY(waitFor([&] { return !tabbed->isHidden(); }));
  dock->setFloating(false);
  QVERIFY(waitFor([&] { return tabbed->isHidden(); }));
}

void InspectorTest::aLongPathIsCutAtItsBeginning() {
  PathField field;
  field.resize(160, 28);
  field.setText(QStringLiteral("/a/rather/long/folder/in/which/there/are/many/others/left.mp4"));
  QVERIFY(field.shownText().endsWith(QStringLiteral("left.mp4")));
  QVERIFY(!field.shownText().startsWith(QStringLiteral("/a")));
  field.setText(QStringLiteral("a.mp4"));
  QCOMPARE(field.shownText(), QStringLiteral("a.mp4"));
  QVERIFY(qobject_cast<PathField*>(find<QLineEdit>("cameraSource")) != nullptr);
}

DEWPOINT_WINDOW_TEST(InspectorTest)

} // namespace dewpoint::tests

#include "inspector_test.moc"
