// SPDX-License-Identifier: GPL-3.0-or-later
// The volume of interest in the window: set by numbers and from the cameras, seen in the images and
// in the bird's-eye view, taken back.
#include "core/geometry/seen_volume.h"
#include "core/project/project.h"
#include "core/project/project_rig.h"
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/cameraview/camera_view.h"
#include "ui/document/document.h"
#include "ui/view3d/birds_eye_view.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QUndoStack>

#include <cmath>
#include <optional>
#include <vector>

namespace dewpoint::tests {

class VolumeTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup() { window_.reset(); }
  void itIsTakenFromTheCamerasAndBack();
  void itsNumbersAreSteps();
  void aBoxTurnedInsideOutIsRefused();
  void withoutOneANumberBeginsWithWhatTheCamerasSee();
  void viewsShowIt();
  void onlyMethodsThatGoByItHaveIt();

private:
  const std::optional<WorldBox>& volume() const {
    return window_->document().project().volumeOfInterest;
  }
  std::optional<WorldBox> seen() const { return seenVolume(rigOf(window_->document().project())); }
  QDoubleSpinBox& field(const char* name) const { return *find<QDoubleSpinBox>(name); }
  void press(const char* button) { find<QPushButton>(button)->click(); }
  QUndoStack& history() { return *window_->document().undoStack(); }
};

void VolumeTest::init() {
  makeWindow({.size = {1500, 950}, .theme = Theme::Light, .play = false});
  open();
  QVERIFY(waitFor([this] { return shown().history.newestTrackedFrame == 0; }));
  QVERIFY(!volume());
}

void VolumeTest::itIsTakenFromTheCamerasAndBack() {
  auto* none = find<QPushButton>("volumeNone");
  auto* state = find<QLabel>("volumeState");
  QVERIFY(!none->isEnabled());
  QVERIFY(state->text().startsWith(QStringLiteral("None")));
  press("volumeFromCameras");
  QVERIFY(seen());
  QVERIFY(volume() == seen());
  QVERIFY(none->isEnabled());
  QVERIFY(!state->text().startsWith(QStringLiteral("None")));
  QCOMPARE(field("volumeFromX").value(), std::round(1e3 * seen()->min.x()) / 1e3);
  QCOMPARE(field("volumeToZ").value(), std::round(1e3 * seen()->max.z()) / 1e3);
  press("volumeNone");
  QVERIFY(!volume());
  QCOMPARE(history().count(), 2);
  action("actionUndo")->trigger();
  QVERIFY(volume() == seen());
  QVERIFY(none->isEnabled());
  action("actionUndo")->trigger();
  QVERIFY(!volume());
  QVERIFY(!none->isEnabled());
  action("actionRedo")->trigger();
  QVERIFY(volume() == seen());
}

void VolumeTest::itsNumbersAreSteps() {
  press("volumeFromCameras");
  const WorldBox before = *volume();
  WorldBox wanted = before;
  wanted.min.x() = std::round(100.0 * before.center().x()) / 100.0 - 0.1;
  field("volumeFromX").setValue(wanted.min.x());
  QVERIFY(*volume() == wanted); // the other five to the bit, not as the fields round them
  wanted.max.z() = std::ceil(before.max.z()) + 0.5;
  field("volumeToZ").setValue(wanted.max.z());
  QVERIFY(*volume() == wanted);
  QCOMPARE(history().count(), 3);
  wanted.max.z() += 0.1;
  field("volumeToZ").setValue(wanted.max.z()); // the same number again: one step
  QCOMPARE(history().count(), 3);
  QVERIFY(*volume() == wanted);
  action("actionUndo")->trigger();
  action("actionUndo")->trigger();
  QVERIFY(*volume() == before);
  QCOMPARE(field("volumeFromX").value(), std::round(1e3 * before.min.x()) / 1e3);
}

void VolumeTest::aBoxTurnedInsideOutIsRefused() {
  press("volumeFromCameras");
  const WorldBox before = *volume();
  field("volumeFromY").setValue(before.max.y() + 1.0);
  QVERIFY(*volume() == before);
  QCOMPARE(field("volumeFromY").value(), std::round(1e3 * before.min.y()) / 1e3);
  QCOMPARE(history().count(), 1);
}

void VolumeTest::withoutOneANumberBeginsWithWhatTheCamerasSee() {
  QCOMPARE(field("volumeToY").value(), std::round(1e3 * seen()->max.y()) / 1e3);
  QVERIFY(!volume());
  WorldBox wanted = *seen();
  wanted.max.y() = std::ceil(wanted.max.y()) + 1.0;
  field("volumeToY").setValue(wanted.max.y());
  QVERIFY(volume());
  QVERIFY(*volume() == wanted);
  action("actionUndo")->trigger();
  QVERIFY(!volume());
  QCOMPARE(field("volumeToY").value(), std::round(1e3 * seen()->max.y()) / 1e3);
}

void VolumeTest::viewsShowIt() {
  // A box in the middle of what is seen: its edges are in both images.
  const Eigen::Vector3d middle = seen()->center();
  const Eigen::Vector3d half = 0.1 * seen()->halfSize();
  QVERIFY(window_->document().edit(QStringLiteral("test"), [&](Project& project) {
    project.volumeOfInterest = WorldBox{middle - half, middle + half};
  }));
  const std::vector<QWidget*> views{find<CameraView>("cameraView0"),
                                    find<CameraView>("cameraView1")};
  auto* layer = action("actionShowVolumeOfInterest");
  QVERIFY(layer->isEnabled());
  QVERIFY(layer->isChecked());
  for (QWidget* view : views) {
    QVERIFY(settles(*view));
    const QImage with = view->grab().toImage();
    layer->setChecked(false);
    QVERIFY(settles(*view));
    const QImage without = view->grab().toImage();
    layer->setChecked(true);
    QVERIFY(settles(*view));
    QVERIFY(with != without);
    QCOMPARE(view->grab().toImage(), with);
  }
  auto* birdsEye = find<BirdsEyeView>("birdsEyeView");
  if (birdsEye->hasImage()) {
    const QImage with = birdsEye->currentImage();
    layer->setChecked(false);
    QVERIFY(birdsEye->currentImage() != with);
  }
}

void VolumeTest::onlyMethodsThatGoByItHaveIt() {
  window_->document().setMethod("histogram");
  QVERIFY(waitFor([this] { return window_->findChild<QPushButton*>("volumeNone") == nullptr; }));
  QVERIFY(!action("actionShowVolumeOfInterest")->isEnabled());
  action("actionUndo")->trigger();
  QVERIFY(waitFor([this] { return window_->findChild<QPushButton*>("volumeNone") != nullptr; }));
  QVERIFY(action("actionShowVolumeOfInterest")->isEnabled());
}

DEWPOINT_WINDOW_TEST(VolumeTest)

} // namespace dewpoint::tests

#include "volume_test.moc"
