// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a new project: what is dropped onto it, what it makes, and how one gets away again.
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/cameras/fake_devices.h"
#include "tests/ui/recorded_demo.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/document/document.h"
#include "ui/start/new_project_page.h"

#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include <memory>
#include <optional>

namespace dewpoint::tests {

class NewPageTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init() { makeWindow(); }
  void cleanup() { window_.reset(); }
  void twoVideosAndACalibrationMakeAProject();
  void whatCannotBeMadeIsSaidAndNothingIsLost();
  void furtherDropsAddToTheNewProject();
  void whatIsNoFootageIsRefused();
  void anErrorIsOverWhenAnotherProjectOpens();
  void cancelOfANewProjectChangesNothing();
  void cancelWhileItIsMadeOpensNothing();
  void aTypedFolderHasARate();
  void whatIsChosenIsReadAtOnce();
  void aCalibrationIsReadWhenItIsChosen();
  void theCalibrationBesideTheVideosIsProposed();
  void camerasOfOtherNamesAreMatched();
  void aCalibrationForOtherImagesIsFitted();
  void aPageOverARunHasNoTransport();
  void connectedCamerasAreStoredWithTheirIdentities();

private:
  QString found(int row) const { return find<QTableWidget>("newCameras")->item(row, 2)->text(); }
  /// Waits until the page has found out about all that was dropped.
  bool hasRows(int rows) const {
    return waitFor([&] {
      return find<QTableWidget>("newCameras")->rowCount() == rows &&
             find<QPushButton>("newCreate")->isEnabled();
    });
  }
};

void NewPageTest::twoVideosAndACalibrationMakeAProject() {
  QVERIFY(recordDemo(folder_.path().toStdString()));
  drop({file("left.mkv"), file("right.mkv"), file("calibration.toml")});
  QVERIFY(hasRows(2));
  QCOMPARE(find<QLabel>("newCalibrationFile")->text(), QStringLiteral("calibration.toml"));
  QTest::mouseClick(find<QPushButton>("newCreate"), Qt::LeftButton);
  QVERIFY(isOpen(2));
  const Project& project = window_->document().project();
  QCOMPARE(project.cameras[0].camera.name, std::string("left"));
  QCOMPARE(project.cameras[1].camera.intrinsics.height, 320); // the demo's second camera, by order
  QVERIFY(window_->document().isUnsaved());
  QVERIFY(window_->isWindowModified());
  QVERIFY(find<QLabel>("messageText")->text().contains(QStringLiteral("order")));
}

void NewPageTest::whatCannotBeMadeIsSaidAndNothingIsLost() {
  action("actionNew")->trigger();
  QVERIFY(!find<QPushButton>("newCreate")->isEnabled());
  drop({file("left.mkv"), file("nowhere.mkv")});
  QVERIFY(hasRows(2));
  QTest::mouseClick(find<QPushButton>("newCreate"), Qt::LeftButton);
  QVERIFY(waitFor([this] {
    return find<QLabel>("messageText")->text().contains(QStringLiteral("nowhere.mkv"));
  }));
  QCOMPARE(find<QTableWidget>("newCameras")->rowCount(), 2);
  QVERIFY(find<QPushButton>("newCreate")->isEnabled());
  QTest::mouseClick(find<QPushButton>("newCancel"), Qt::LeftButton);
  QVERIFY(find<QWidget>("startPage")->isVisible());
}

void NewPageTest::furtherDropsAddToTheNewProject() {
  QVERIFY(recordDemo(folder_.path().toStdString()));
  for (const char* name : {"cam 10.mkv", "cam 2.mkv", "cam 1.mkv"}) {
    QFile::copy(file("left.mkv"), file(name));
  }
  drop({file("cam 10.mkv"), file("cam 2.mkv")});
  drop({file("cam 1.mkv")});
  drop({file("cam 1.mkv"), file("calibration.toml")}); // twice the same is one camera
  auto* table = find<QTableWidget>("newCameras");
  QVERIFY(hasRows(3));
  QCOMPARE(table->item(0, 0)->text(), QStringLiteral("cam 2")); // numbers as numbers
  QCOMPARE(table->item(1, 0)->text(), QStringLiteral("cam 10"));
  QCOMPARE(table->item(2, 0)->text(), QStringLiteral("cam 1"));
  QCOMPARE(find<QLabel>("newCalibrationFile")->text(), QStringLiteral("calibration.toml"));
}

void NewPageTest::whatIsNoFootageIsRefused() {
  QVERIFY(recordDemo(folder_.path().toStdString()));
  QFile table(file("truth.csv"));
  QVERIFY(table.open(QIODevice::WriteOnly));
  table.write("frame,x,y,z\n0,1,2,3\n");
  table.close();
  QVERIFY(QDir().mkpath(file("no images")));
  drop({file("left.mkv"), file("truth.csv"), file("calibration.toml"), file("no images")});
  QVERIFY(hasRows(1));
  QCOMPARE(find<QTableWidget>("newCameras")->item(0, 0)->text(), QStringLiteral("left"));
  const QString text = find<QLabel>("messageText")->text();
  QVERIFY2(text.contains(QStringLiteral("truth.csv")) && text.contains(QStringLiteral("no images")),
           qPrintable(text));
}

void NewPageTest::anErrorIsOverWhenAnotherProjectOpens() {
  window_->openProject("gone.toml");
  auto* message = find<QLabel>("messageText");
  QVERIFY(waitFor([&] { return message->text().contains(QStringLiteral("gone.toml")); }));
  openDemo();
  QVERIFY(!message->isVisible());
}

void NewPageTest::cancelOfANewProjectChangesNothing() {
  openDemo();
  auto* birdsEye = find<QDockWidget>("birdsEyeDock");
  auto* plots = find<QDockWidget>("plotDock");
  birdsEye->setFloating(true);
  plots->toggleViewAction()->trigger();
  QVERIFY(!plots->isVisible());
  const QSize size = window_->size();
  const Project before = window_->document().project();
  action("actionNew")->trigger();
  QVERIFY(find<QWidget>("newProjectPage")->isVisible());
  QVERIFY(!birdsEye->isVisible());
  QVERIFY(keepsItsSize(window_.get()));
  QCOMPARE(window_->size(), size);
  QTest::mouseClick(find<QPushButton>("newCancel"), Qt::LeftButton);
  QVERIFY(waitFor([&] { return birdsEye->isVisible() && birdsEye->isFloating(); }));
  QVERIFY(!plots->isVisible());
  QVERIFY(find<QWidget>("start")->isHidden());
  QVERIFY(keepsItsSize(window_.get()));
  QCOMPARE(window_->size(), size);
  QVERIFY(window_->document().project() == before);
}

void NewPageTest::cancelWhileItIsMadeOpensNothing() {
  QVERIFY(recordDemo(folder_.path().toStdString()));
  drop({file("left.mkv"), file("right.mkv")});
  QVERIFY(hasRows(2));
  // Both clicks come before the event loop can deliver what was made.
  find<QPushButton>("newCreate")->click();
  find<QPushButton>("newCancel")->click();
  QVERIFY(find<QWidget>("startPage")->isVisible());
  QVERIFY(jobsEnd()); // what was being made is there by now
  QVERIFY(find<QWidget>("startPage")->isVisible());
  QVERIFY(!find<QLabel>("messageText")->isVisible());
}

void NewPageTest::aTypedFolderHasARate() {
  action("actionNew")->trigger();
  QVERIFY(QDir().mkpath(file("images")));
  QTest::mouseClick(find<QPushButton>("newAddAddress"), Qt::LeftButton);
  QTableWidgetItem* source = find<QTableWidget>("newCameras")->item(0, 1);
  source->setText(file("images"));
  auto* rate = find<QWidget>("newRate");
  QVERIFY(waitFor([&] { return rate->isVisible(); }));
  source->setText(QStringLiteral("rtsp://camera.example/1"));
  QVERIFY(!rate->isVisible());
}

void NewPageTest::whatIsChosenIsReadAtOnce() {
  QVERIFY(recordDemo(folder_.path().toStdString()));
  QVERIFY(QDir().mkpath(file("other")));
  QVERIFY(recordDemo(file("other").toStdString(), 5));
  action("actionNew")->trigger();
  QVERIFY(find<QWidget>("newDropZone")->isVisible());
  const auto* note = find<QLabel>("newFootageNote");
  drop({file("left.mkv")});
  QVERIFY(hasRows(1));
  QVERIFY(!find<QWidget>("newDropZone")->isVisible());
  QVERIFY(waitFor([this] { return found(0).contains(QStringLiteral("320×240")); }));
  QVERIFY2(found(0).contains(QStringLiteral("30")) && found(0).contains(QStringLiteral("8 frames")),
           qPrintable(found(0)));
  QVERIFY(!find<QTableWidget>("newCameras")->item(0, 0)->icon().isNull());
  QVERIFY(!note->isVisible());
  drop({file("other/left.mkv"), file("nowhere.mkv")});
  QVERIFY(hasRows(3));
  QVERIFY(waitFor([&] { return note->isVisible(); }));
  QVERIFY2(note->text().contains(QStringLiteral("first 5 frames")), qPrintable(note->text()));
  QVERIFY(waitFor([this] { return found(2).startsWith(QStringLiteral("✗")); }));
}

void NewPageTest::aCalibrationIsReadWhenItIsChosen() {
  QVERIFY(recordDemo(folder_.path().toStdString()));
  const auto* result = find<QLabel>("newCalibrationResult");
  drop({file("left.mkv"), file("right.mkv"), file("calibration.toml")});
  QVERIFY(hasRows(2));
  QVERIFY(waitFor([&] { return result->text().contains(QStringLiteral("Dewpoint, 2 cameras")); }));
  find<QTableWidget>("newCameras")->selectRow(1);
  find<QPushButton>("newRemove")->click(); // two cameras are no calibration of one
  QVERIFY2(result->text().contains(QStringLiteral("camera 1, camera 2")),
           qPrintable(result->text()));
  QFile other(file("other.json"));
  QVERIFY(other.open(QIODevice::WriteOnly));
  other.write("{\"K\": [1, 2, 3]}");
  other.close();
  drop({file("other.json")});
  QVERIFY(waitFor([&] { return result->text().contains(QStringLiteral("Not recognized")); }));
  QVERIFY2(result->text().contains(QStringLiteral("Caliscope")), qPrintable(result->text()));
  find<QPushButton>("newDropCalibration")->click();
  QVERIFY(!result->isVisible());
}

void NewPageTest::theCalibrationBesideTheVideosIsProposed() {
  QVERIFY(recordDemo(folder_.path().toStdString()));
  for (const char* other : {"half.toml", "tall.toml", "other.json"}) {
    QFile::remove(file(other)); // of other tests
  }
  const auto* name = find<QLabel>("newCalibrationFile");
  const QString proposed = QStringLiteral("calibration.toml (found beside the recordings)");
  drop({file("left.mkv")});
  QVERIFY(hasRows(1));
  QVERIFY(name->text().startsWith(QStringLiteral("None"))); // it has two cameras
  drop({file("right.mkv")});
  QVERIFY(hasRows(2));
  QCOMPARE(name->text(), proposed);
  find<QTableWidget>("newCameras")->selectRow(1);
  find<QPushButton>("newRemove")->click();
  QVERIFY(hasRows(1));
  QVERIFY(name->text().startsWith(QStringLiteral("None")));
  drop({file("right.mkv")});
  QVERIFY(hasRows(2));
  QCOMPARE(name->text(), proposed);
  // Refused once, it is not proposed again.
  find<QPushButton>("newDropCalibration")->click();
  find<QTableWidget>("newCameras")->selectRow(1);
  find<QPushButton>("newRemove")->click();
  drop({file("right.mkv")});
  QVERIFY(hasRows(2));
  QVERIFY(name->text().startsWith(QStringLiteral("None")));
  // The next project gets a proposal again.
  find<QPushButton>("newCancel")->click();
  drop({file("left.mkv"), file("right.mkv")});
  QVERIFY(hasRows(2));
  QCOMPARE(name->text(), proposed);
  QTest::mouseClick(find<QPushButton>("newCreate"), Qt::LeftButton);
  QVERIFY(isOpen(2));
  QCOMPARE(window_->document().project().cameras[1].camera.intrinsics.height, 320);
  QVERIFY(!hasGuessedPose(window_->document().project()));
}

void NewPageTest::camerasOfOtherNamesAreMatched() {
  QVERIFY(recordDemo(folder_.path().toStdString()));
  CameraRig rig = demoScene().cameras;
  rig[0].name = "left"; // the other one has another name
  QVERIFY(saveCalibration(rig, file("half.toml").toStdString()).has_value());
  drop({file("left.mkv"), file("right.mkv"), file("half.toml")});
  QVERIFY(hasRows(2));
  QVERIFY(waitFor([this] {
    const auto* choice = window_->findChild<QComboBox*>(QStringLiteral("newCalibrationName1"));
    return choice != nullptr && choice->isVisible();
  }));
  QCOMPARE(find<QComboBox>("newCalibrationName0")->currentText(), QStringLiteral("left"));
  auto* right = find<QComboBox>("newCalibrationName1");
  right->setCurrentIndex(right->findText(QStringLiteral("camera 2")));
  QVERIFY2(find<QLabel>("newCalibrationResult")->text().contains(QStringLiteral("✓")),
           qPrintable(find<QLabel>("newCalibrationResult")->text()));
  QTest::mouseClick(find<QPushButton>("newCreate"), Qt::LeftButton);
  QVERIFY(isOpen(2));
  const Project& project = window_->document().project();
  QCOMPARE(project.cameras[1].camera.name, std::string("right"));
  QVERIFY(project.cameras[1].camera.intrinsics == rig[1].intrinsics);
}

void NewPageTest::aCalibrationForOtherImagesIsFitted() {
  QVERIFY(recordDemo(folder_.path().toStdString()));
  CameraRig rig = demoScene().cameras;
  for (Camera& camera : rig) {
    camera.intrinsics.height += 8; // as of a video format that stores whole blocks
  }
  QVERIFY(saveCalibration(rig, file("tall.toml").toStdString()).has_value());
  drop({file("left.mkv"), file("right.mkv"), file("tall.toml")});
  QVERIFY(hasRows(2));
  auto* fit = find<QComboBox>("newCalibrationFit");
  QVERIFY(!fit->isVisible());
  QTest::mouseClick(find<QPushButton>("newCreate"), Qt::LeftButton);
  QVERIFY(waitFor([&] { return fit->isVisible(); }));
  QVERIFY2(find<QLabel>("messageText")->text().contains(QStringLiteral("pixels")),
           qPrintable(find<QLabel>("messageText")->text()));
  fit->setCurrentIndex(fit->findData(QStringLiteral("trim")));
  QVERIFY(waitFor([this] { return find<QPushButton>("newCreate")->isEnabled(); }));
  QTest::mouseClick(find<QPushButton>("newCreate"), Qt::LeftButton);
  QVERIFY(isOpen(2));
  const Intrinsics& fitted = window_->document().project().cameras[0].camera.intrinsics;
  QVERIFY(fitted == demoScene().cameras[0].intrinsics);
}

void NewPageTest::aPageOverARunHasNoTransport() {
  openDemo();
  action("actionNew")->trigger();
  for (const char* id : {"actionPlay", "actionNextFrame", "actionRestart", "actionSave"}) {
    QVERIFY2(!action(id)->isEnabled(), id);
  }
  find<QPushButton>("newCancel")->click();
  QVERIFY(waitFor([this] { return action("actionPlay")->isEnabled(); }));
}

void NewPageTest::connectedCamerasAreStoredWithTheirIdentities() {
  const auto devices = std::make_shared<test::FakeDevices>();
  devices->plug(test::fakeWebcam(1, "A"));
  devices->plug(test::fakeWebcam(2, "B"));
  ui::NewProjectPage page;
  page.setDeviceAccess(devices);
  std::optional<Project> made;
  connect(&page, &ui::NewProjectPage::created, this,
          [&](const Project& project) { made = project; });
  page.startNewProject({});
  page.addConnectedCameras();
  auto* create = page.findChild<QPushButton*>(QStringLiteral("newCreate"));
  QVERIFY(waitFor([&] { return create->isEnabled(); }));
  create->click();
  QVERIFY(waitFor([&] { return made.has_value(); }));
  QCOMPARE(made->cameras.size(), std::size_t(2));
  for (const int k : {0, 1}) {
    const ProjectCamera& camera = made->cameras[static_cast<std::size_t>(k)];
    const capture::CameraDevice device = test::fakeWebcam(k + 1, k == 0 ? "A" : "B");
    QCOMPARE(camera.source, SourceKind::Device);
    QVERIFY(camera.device.identity == device.identity);
    QCOMPARE(camera.location, device.stablePath);
  }
}

DEWPOINT_WINDOW_TEST(NewPageTest)

} // namespace dewpoint::tests

#include "new_page_test.moc"
