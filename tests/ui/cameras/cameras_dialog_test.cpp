// SPDX-License-Identifier: GPL-3.0-or-later
// The dialog Cameras in the real window, with fake devices and test patterns.
#include "core/project/project_save.h"
#include "core/session/snapshot/snapshot.h"
#include "core/simulation/scene/scene.h"
#include "tests/ui/cameras/fake_devices.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/cameras/cameras_dialog.h"
#include "ui/cameras/device_watch.h"
#include "ui/document/document.h"
#include "ui/selection/selection.h"
#include "ui/session/session_controller.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/workbench.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QUndoStack>

#include <memory>

namespace dewpoint::tests {

class CamerasDialogTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup() { window_.reset(); }
  void aRemovedCameraComesBackWithItsCalibration();
  void aTestPatternIsTriedAndAdded();
  void anAddressThatFailsSaysWhy();
  void devicesAppearAndVanish();
  void aDeviceIsAddedWithItsIdentity();
  void controlsReachTheDevice();
  void colorsAreLockedInOneStep();
  void aLearnedColorOffersTheLock();
  void aMissingDeviceIsAskedForOnce();
  void aShortBusIsSaidWithFormatsThatFit();
  void imagesAreRotatedWithTheirCalibration();
  void imagesAreCroppedWithTheirCalibration();
  void aSceneKeepsItsCameras();

private:
  Document& document() { return window_->workbench().document; }
  const std::vector<ProjectCamera>& cameras() { return document().project().cameras; }
  QUndoStack& history() { return *document().undoStack(); }
  void click(const char* button) { QTest::mouseClick(find<QPushButton>(button), Qt::LeftButton); }
  /// A calibrated project whose cameras are test patterns.
  Project patterns() const;
  void openProjectOf(const Project& project);
  void openDialog();
  /// Waits until the run has so many cameras.
  bool runs(std::size_t cameras) {
    return waitFor([&] {
      return window_->shown() && window_->shown()->rig && window_->shown()->rig->size() == cameras;
    });
  }
  /// Adds the only device that is plugged in, and selects its camera.
  void addDevice();

  std::shared_ptr<test::FakeDevices> devices_;
};

void CamerasDialogTest::init() {
  devices_ = std::make_shared<test::FakeDevices>();
  makeWindow({.play = false});
  window_->findChild<DeviceWatch*>()->setDeviceAccess(devices_);
}

Project CamerasDialogTest::patterns() const {
  Project project = makeSceneProject(demoScene(), "");
  project.scene.clear();
  project.cameras.resize(2);
  for (ProjectCamera& camera : project.cameras) {
    const Intrinsics& lens = camera.camera.intrinsics;
    camera.source = SourceKind::Stream;
    camera.location = "test:ball?rate=15&width=" + std::to_string(lens.width) +
                      "&height=" + std::to_string(lens.height);
  }
  return project;
}

void CamerasDialogTest::openProjectOf(const Project& project) {
  QVERIFY(saveProject(project, path("patterns.toml")));
  open(path("patterns.toml"));
}

void CamerasDialogTest::openDialog() {
  action("actionCameras")->trigger();
  QVERIFY(find<CamerasDialog>("camerasDialog")->isVisible());
  QVERIFY(waitFor([this] { return window_->findChild<DeviceWatch*>()->areDevicesListed(); }));
}

void CamerasDialogTest::addDevice() {
  QVERIFY(waitFor([this] { return find<QListWidget>("connectedDevices")->count() == 1; }));
  find<QListWidget>("connectedDevices")->setCurrentRow(0);
  click("deviceAdd");
  QCOMPARE(cameras().size(), std::size_t(3));
  QVERIFY(runs(3));
  window_->workbench().selection.selectCamera(2);
}

void CamerasDialogTest::aRemovedCameraComesBackWithItsCalibration() {
  openProjectOf(patterns());
  QVERIFY(runs(2));
  const std::vector<ProjectCamera> before = cameras();
  openDialog();
  window_->workbench().selection.selectCamera(0);
  click("projectCameraRemove");
  QCOMPARE(cameras().size(), std::size_t(1));
  QCOMPARE(cameras()[0].camera.name, before[1].camera.name);
  QVERIFY(runs(1));
  QVERIFY(!find<QPushButton>("projectCameraRemove")->isEnabled()); // the last one stays
  history().undo();
  QVERIFY(cameras() == before);
  QVERIFY(runs(2));
  history().redo();
  QVERIFY(runs(1));
}

void CamerasDialogTest::aTestPatternIsTriedAndAdded() {
  openProjectOf(patterns());
  QVERIFY(runs(2));
  openDialog();
  find<QLineEdit>("addressText")->setText(QStringLiteral("test:smpte?width=320&height=240"));
  click("addressTry");
  auto* result = find<QLabel>("addressResult");
  QVERIFY(waitFor([&] { return result->text().contains(QStringLiteral("320 × 240")); }));
  QVERIFY(find<QLabel>("addressImage")->isVisible());
  const int steps = history().count();
  click("addressAdd");
  QVERIFY(waitFor([this] { return cameras().size() == 3; }));
  QCOMPARE(cameras()[2].camera.intrinsics.width, 320);
  QVERIFY(runs(3));
  QCOMPARE(history().count(), steps + 1); // with what the camera reports when it is opened
  history().undo();
  QCOMPARE(cameras().size(), std::size_t(2));
  QVERIFY(runs(2));
  QVERIFY(history().canRedo());
}

void CamerasDialogTest::anAddressThatFailsSaysWhy() {
  openProjectOf(patterns());
  openDialog();
  find<QLineEdit>("addressText")->setText(QStringLiteral("test:no-such-pattern"));
  click("addressTry");
  auto* result = find<QLabel>("addressResult");
  QVERIFY(waitFor([&] { return result->text().startsWith(QStringLiteral("✗")); }));
  click("addressAdd");
  auto* message = find<QLabel>("camerasMessage");
  QVERIFY(waitFor([&] { return message->isVisible(); }));
  QCOMPARE(cameras().size(), std::size_t(2));
}

void CamerasDialogTest::devicesAppearAndVanish() {
  openProjectOf(patterns());
  openDialog();
  auto* list = find<QListWidget>("connectedDevices");
  QCOMPARE(list->count(), 0);
  QVERIFY(find<QLabel>("noDevices")->isVisible());
  devices_->plug(test::fakeWebcam(1, "A1"));
  QVERIFY(waitFor([&] { return list->count() == 1; }));
  const QString text = list->item(0)->text();
  QVERIFY2(text.contains(QStringLiteral("A1")) && text.contains(QStringLiteral("MJPG")),
           qPrintable(text));
  // Its stream is opened beside the window.
  QVERIFY(waitFor([&] { return list->item(0)->text().contains(QStringLiteral("320 × 240")); }));
  devices_->unplug("A1");
  QVERIFY(waitFor([&] { return list->count() == 0; }));
}

void CamerasDialogTest::aDeviceIsAddedWithItsIdentity() {
  devices_->plug(test::fakeWebcam(1, "A1"));
  openProjectOf(patterns());
  openDialog();
  addDevice();
  QCOMPARE(cameras()[2].source, SourceKind::Device);
  QCOMPARE(cameras()[2].device.identity.serial, std::string("A1"));
  const QString text = find<QListWidget>("connectedDevices")->item(0)->text();
  QVERIFY2(text.contains(QStringLiteral("camera 3")), qPrintable(text)); // which uses it
  QVERIFY(!find<QPushButton>("deviceAdd")->isEnabled());
}

void CamerasDialogTest::controlsReachTheDevice() {
  const auto webcam = test::fakeWebcam(1, "A1");
  devices_->plug(webcam);
  openProjectOf(patterns());
  openDialog();
  addDevice();
  QVERIFY(waitFor([this] { return window_->findChild<QWidget*>("control_gain") != nullptr; }));
  auto* gain = find<QWidget>("control_gain")->findChild<QSlider*>();
  QCOMPARE(gain->value(), 64);
  QCOMPARE(gain->maximum(), 255);
  QVERIFY(!find<QWidget>("control_exposure_time_absolute")->isEnabled()); // it is automatic
  gain->setValue(100);
  gain->setValue(120);
  QCOMPARE(cameras()[2].device.controls.at("gain"), std::int64_t(120));
  QVERIFY(waitFor([&] { return devices_->value(webcam.path, "gain") == 120; }));
  history().undo(); // both moves of the slider
  QVERIFY(!cameras()[2].device.controls.contains("gain"));
  QVERIFY(waitFor([&] { return devices_->value(webcam.path, "gain") == 64; }));
}

void CamerasDialogTest::colorsAreLockedInOneStep() {
  const auto webcam = test::fakeWebcam(1, "A1");
  devices_->plug(webcam);
  openProjectOf(patterns());
  openDialog();
  addDevice();
  const int steps = history().count();
  click("projectCameraLock");
  QVERIFY(waitFor([&] { return devices_->value(webcam.path, "auto_exposure") == 1; }));
  QVERIFY(waitFor([this] { return !cameras()[2].device.controls.empty(); }));
  QCOMPARE(cameras()[2].device.controls.at("exposure_time_absolute"), std::int64_t(250));
  QCOMPARE(history().count(), steps + 1);
}

void CamerasDialogTest::aLearnedColorOffersTheLock() {
  const auto webcam = test::fakeWebcam(1, "A1");
  devices_->plug(webcam);
  openProjectOf(patterns());
  openDialog();
  addDevice();
  const auto learned = document().edit(QStringLiteral("Learn color"), [](Project& project) {
    project.targets.front().samples.emplace_back();
  });
  QVERIFY(learned);
  QVERIFY(waitFor([this] {
    return messageText().contains(QStringLiteral("adjust their colors automatically")) &&
           window_->findChild<QPushButton*>("messageAnswer0") != nullptr;
  }));
  QTest::mouseClick(find<QPushButton>("messageAnswer0"), Qt::LeftButton);
  QVERIFY(waitFor([&] { return devices_->value(webcam.path, "auto_exposure") == 1; }));
}

void CamerasDialogTest::aMissingDeviceIsAskedForOnce() {
  devices_->plug(test::fakeWebcam(2, "B2"));
  Project project = patterns();
  project.cameras[0].source = SourceKind::Device;
  project.cameras[0].location = "/dev/video40";
  project.cameras[0].device.identity = {"usb-0:9:1.0", "GONE", "Other webcam", "1234:9999"};
  openProjectOf(project);
  const Camera calibration = cameras()[0].camera;
  QVERIFY(waitFor([this] {
    return messageText().contains(QStringLiteral("Plug it in")) &&
           window_->findChild<QPushButton*>("messageAnswer0") != nullptr;
  }));
  QVERIFY2(messageText().contains(QStringLiteral("GONE")), qPrintable(messageText()));
  QTest::mouseClick(find<QPushButton>("messageAnswer0"), Qt::LeftButton);
  QCOMPARE(cameras()[0].device.identity.serial, std::string("B2"));
  QVERIFY(cameras()[0].camera == calibration);
  QVERIFY(history().canUndo());
  devices_->unplug("B2");
  QVERIFY(waitFor([this] { return window_->findChild<DeviceWatch*>()->devices().empty(); }));
  QVERIFY(!messageText().contains(QStringLiteral("Plug it in"))); // it is expected back
}

void CamerasDialogTest::aShortBusIsSaidWithFormatsThatFit() {
  devices_->plug(test::fakeWebcam(1, "A1"));
  openProjectOf(patterns());
  openDialog();
  addDevice();
  auto* warning = find<QLabel>("bandwidthWarning");
  QVERIFY(!warning->isVisible());
  QVERIFY(document().edit(QStringLiteral("Change image format"), [](Project& project) {
    project.cameras[2].device.format = {"YUYV", 1920, 1080, 30.0};
  }));
  QVERIFY(warning->isVisible());
  QVERIFY2(warning->text().contains(QStringLiteral("camera 3")), qPrintable(warning->text()));
  click("bandwidthFit");
  QVERIFY(!warning->isVisible());
  QVERIFY(cameras()[2].device.format != (capture::DeviceFormat{"YUYV", 1920, 1080, 30.0}));
}

void CamerasDialogTest::imagesAreRotatedWithTheirCalibration() {
  openProjectOf(patterns());
  QVERIFY(runs(2));
  openDialog();
  window_->workbench().selection.selectCamera(0);
  const Intrinsics before = cameras()[0].camera.intrinsics;
  auto* rotation = find<QComboBox>("projectCameraRotation");
  rotation->setCurrentIndex(1);
  Q_EMIT rotation->activated(1);
  QCOMPARE(cameras()[0].rotateDegrees, 90);
  QCOMPARE(cameras()[0].camera.intrinsics.width, before.height);
  QVERIFY(waitFor([&] {
    const auto frames = window_->shown() ? window_->shown()->frames : nullptr;
    return frames && frames->frames[0] && frames->frames[0]->image.cols == before.height;
  }));
  history().undo();
  QVERIFY(cameras()[0].camera.intrinsics == before);
}

void CamerasDialogTest::imagesAreCroppedWithTheirCalibration() {
  openProjectOf(patterns());
  QVERIFY(runs(2));
  openDialog();
  window_->workbench().selection.selectCamera(1);
  const Intrinsics before = cameras()[1].camera.intrinsics;
  auto* left = find<QSpinBox>("cropLeft");
  QCOMPARE(left->maximum(), before.width - 16);
  const int steps = history().count();
  left->setValue(1);
  left->setValue(24); // both are one step
  QVERIFY(waitFor([this] { return cameras()[1].crop.left == 24; }));
  QCOMPARE(history().count(), steps + 1);
  QCOMPARE(cameras()[1].camera.intrinsics.width, before.width - 24);
  QCOMPARE(cameras()[1].camera.intrinsics.centerX, before.centerX - 24.0);
  QVERIFY(waitFor([&] {
    const auto frames = window_->shown() ? window_->shown()->frames : nullptr;
    return frames && frames->frames[1] && frames->frames[1]->image.cols == before.width - 24;
  }));
  QCOMPARE(find<QSpinBox>("cropRight")->maximum(), before.width - 24 - 16);
  history().undo();
  QVERIFY(cameras()[1].camera.intrinsics == before);
  QCOMPARE(left->value(), 0);
}

void CamerasDialogTest::aSceneKeepsItsCameras() {
  openDemo();
  openDialog();
  QVERIFY(!find<QPushButton>("projectCameraRemove")->isEnabled());
  QVERIFY(!find<QPushButton>("addressAdd")->isEnabled());
  QVERIFY(!find<QPushButton>("camerasAddVideos")->isEnabled());
  QVERIFY(find<QLabel>("projectCameraNotes")->isVisible());
}

DEWPOINT_WINDOW_TEST(CamerasDialogTest)

} // namespace dewpoint::tests

#include "cameras_dialog_test.moc"
