// SPDX-License-Identifier: GPL-3.0-or-later
// A run as a video, while the window goes on.
#include "core/base/text_file.h"
#include "core/capture/video_reader.h"
#include "core/session/session.h"
#include "tests/ui/export/dialog_fields.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/cameraview/camera_view.h"
#include "ui/export/video_dialog.h"
#include "ui/workbench/workbench.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace dewpoint::tests {

class VideoExportTest : public QObject,
                        private test::WindowFixture,
                        private test::DialogFields<VideoDialog*> {
  Q_OBJECT
private Q_SLOTS:
  void initTestCase();
  void init();
  void cleanupTestCase() { window_.reset(); }
  void offersTheViewsAndWhatTheComputerCanWrite();
  void previewsTheFirstImage();
  void previewsTheChosenSpanAndImage();
  void writesWhatIsSeen();
  void writesTheBirdsEyeView();
  void showsSlowMotion();
  void cancelingLeavesNoFile();
  void asksBeforeAFileIsReplaced();
  void saysWhatFailed();
  void closingTheProjectStopsIt();

private:
  void check(int row, bool checked) const {
    field<QListWidget>("videoViews")
        ->item(row)
        ->setCheckState(checked ? Qt::Checked : Qt::Unchecked);
  }
  /// Lossless: the last format.
  void chooseLossless() const {
    auto* formats = field<QComboBox>("videoEncoding");
    formats->setCurrentIndex(formats->count() - 1);
  }
  void setFile(const QString& name) const { field<QLineEdit>("videoFile")->setText(name); }
  QString outcome() const { return field<QLabel>("exportOutcome")->text(); }
  bool isIdle() const { return field<QPushButton>("videoStart")->isEnabled(); }
  void start() const { QTest::mouseClick(field<QPushButton>("videoStart"), Qt::LeftButton); }
  /// Exports into a file of the test's folder and waits for the end.
  bool exportsTo(const QString& name) {
    setFile(name);
    start();
    return waitFor([this] { return isIdle(); });
  }
};

void VideoExportTest::initTestCase() {
  makeWindow({.size = {1400, 900}});
  window_->openProject({});
  QTRY_VERIFY_WITH_TIMEOUT(window_->shown() != nullptr && window_->shown()->frame > 20, kTimeoutMs);
  action("actionPlay")->trigger();
  QTRY_VERIFY_WITH_TIMEOUT(window_->shown()->state == PlayState::Paused, kTimeoutMs);
  action("actionExportVideo")->trigger();
  dialog_ = window_->findChild<VideoDialog*>();
  QVERIFY(dialog_ != nullptr);
  QVERIFY(QTest::qWaitForWindowExposed(dialog_));
  QTRY_VERIFY_WITH_TIMEOUT(isIdle(), kTimeoutMs); // it is known what can be written
}

void VideoExportTest::init() {
  for (int row = 0; row < field<QListWidget>("videoViews")->count(); ++row) {
    check(row, row == 0);
  }
  field<QDoubleSpinBox>("videoFrom")->setValue(-1.0);
  field<QDoubleSpinBox>("videoTo")->setValue(0.2);
  field<QDoubleSpinBox>("videoSpeed")->setValue(0.0);
  field<QDoubleSpinBox>("videoRate")->setValue(0.0);
  field<QComboBox>("videoSize")->setCurrentIndex(1);
  field<QCheckBox>("videoTitles")->setChecked(false);
  field<QCheckBox>("videoStamp")->setChecked(false);
  chooseLossless();
}

void VideoExportTest::offersTheViewsAndWhatTheComputerCanWrite() {
  auto* views = field<QListWidget>("videoViews");
  QCOMPARE(views->count(), 3); // two cameras, the bird's-eye view
  QCOMPARE(views->item(0)->text(), QStringLiteral("camera 1"));
  QVERIFY(views->item(2)->text().contains(QStringLiteral("Bird")));
  QVERIFY(field<QComboBox>("videoEncoding")->count() >= 1);
  QVERIFY(field<QLineEdit>("videoFile")->text().endsWith(QStringLiteral(".mkv")));
  QVERIFY(!dialog_->isModal());
}

void VideoExportTest::previewsTheFirstImage() {
  auto* summary = field<QLabel>("videoSummary");
  QTRY_VERIFY_WITH_TIMEOUT(summary->text().contains(QStringLiteral("Images: 7.")), kTimeoutMs);
  QVERIFY(summary->text().contains(QStringLiteral("640 × 360")));
  QVERIFY(!field<QLabel>("videoPreview")->pixmap(Qt::ReturnByValue).isNull());
  check(0, false);
  QTRY_VERIFY_WITH_TIMEOUT(summary->text().contains(QStringLiteral("no view")), kTimeoutMs);
}

void VideoExportTest::previewsTheChosenSpanAndImage() {
  auto* summary = field<QLabel>("videoSummary");
  auto* slider = field<QSlider>("videoImage");
  auto* text = field<QLabel>("videoImageText");
  field<QCheckBox>("videoStamp")->setChecked(true);
  const auto previewed = [this] {
    return field<QLabel>("videoPreview")->pixmap(Qt::ReturnByValue).toImage();
  };
  QTRY_VERIFY_WITH_TIMEOUT(summary->text().contains(QStringLiteral("Images: 7.")), kTimeoutMs);
  QCOMPARE(text->text(), QStringLiteral("Image 1 of 7: frame 1"));
  // Frames 4 to 6 at 30 frames a second, counted from 0: their first one is shown.
  field<QDoubleSpinBox>("videoFrom")->setValue(0.133);
  QTRY_VERIFY_WITH_TIMEOUT(summary->text().contains(QStringLiteral("Images: 3.")), kTimeoutMs);
  QCOMPARE(text->text(), QStringLiteral("Image 1 of 3: frame 5"));
  QCOMPARE(slider->maximum(), 2);
  const QImage first = previewed();
  slider->setValue(2);
  QCOMPARE(text->text(), QStringLiteral("Image 3 of 3: frame 7"));
  QTRY_VERIFY_WITH_TIMEOUT(previewed() != first, kTimeoutMs); // the stamp names another frame
  // The image stays while only its look changes; with another range, the first one is back.
  field<QCheckBox>("videoTitles")->setChecked(true);
  QTRY_VERIFY_WITH_TIMEOUT(previewed() != first, kTimeoutMs);
  QCOMPARE(slider->value(), 2);
  field<QDoubleSpinBox>("videoFrom")->setValue(0.1);
  QTRY_COMPARE_WITH_TIMEOUT(text->text(), QStringLiteral("Image 1 of 4: frame 4"), kTimeoutMs);
}

void VideoExportTest::writesWhatIsSeen() {
  const auto frameBefore = window_->shown()->frame;
  field<QComboBox>("videoSize")->setCurrentIndex(0); // of the camera's images
  QVERIFY(exportsTo(file("camera.mkv")));
  QVERIFY2(outcome().contains(file("camera.mkv")), qPrintable(outcome()));
  QCOMPARE(window_->shown()->frame, frameBefore); // the window has not moved
  const auto reader = openVideoReader(path("camera.mkv").string(), "");
  QVERIFY(reader);
  QCOMPARE((*reader)->read(0)->cols, 320);
  Session* session = window_->workbench().session.session();
  auto* view = find<CameraView>("cameraView0");
  for (const std::int64_t frame : {0, 3, 6}) {
    session->showFrame(frame);
    QVERIFY(waitFor([&] { return shown().frame == frame && !shown().isPreview; }));
    const auto picture = (*reader)->read(frame);
    QVERIFY(picture);
    QImage expected =
        cameraPicture(session->newest(), 0, view->options(), {picture->cols, picture->rows});
    int worst = 0;
    for (int y = 0; y < picture->rows; ++y) {
      for (int x = 0; x < picture->cols; ++x) {
        const QRgb pixel = expected.pixel(x, y);
        const auto& read = picture->at<cv::Vec3b>(y, x);
        worst = std::max({worst, std::abs(qBlue(pixel) - read[0]),
                          std::abs(qGreen(pixel) - read[1]), std::abs(qRed(pixel) - read[2])});
      }
    }
    QCOMPARE(worst, 0);
  }
  session->returnToNewestFrame();
}

void VideoExportTest::writesTheBirdsEyeView() {
  check(0, false);
  check(2, true);
  QVERIFY(exportsTo(file("scene.mkv")));
  const auto reader = openVideoReader(path("scene.mkv").string(), "");
  QVERIFY2(reader, qPrintable(outcome()));
  const auto picture = (*reader)->read(6);
  QVERIFY(picture && !picture->empty());
  QCOMPARE(picture->cols, 640);
  std::set<int> levels;
  for (int y = 0; y < picture->rows; ++y) {
    for (int x = 0; x < picture->cols; ++x) {
      levels.insert(picture->at<cv::Vec3b>(y, x)[1]);
    }
  }
  QVERIFY(levels.size() > 20); // the room is seen, not only the ground
}

void VideoExportTest::showsSlowMotion() {
  field<QDoubleSpinBox>("videoSpeed")->setValue(0.5);
  field<QDoubleSpinBox>("videoRate")->setValue(30.0);
  QVERIFY(exportsTo(file("slow.mkv")));
  const auto reader = openVideoReader(path("slow.mkv").string(), "");
  QVERIFY2(reader, qPrintable(outcome()));
  QCOMPARE((*reader)->frameCount(), std::int64_t{14}); // 7 frames at 30 per second, each twice
}

void VideoExportTest::cancelingLeavesNoFile() {
  QDir().mkpath(file("canceled"));
  field<QDoubleSpinBox>("videoTo")->setValue(-1.0);
  field<QDoubleSpinBox>("videoSpeed")->setValue(0.01); // long
  field<QComboBox>("videoSize")->setCurrentIndex(3);
  setFile(file("canceled/a.mkv"));
  start();
  QVERIFY(!isIdle());
  QVERIFY(waitFor([&] { return QDir(file("canceled")).count() > 2; })); // more than . and ..
  QTest::mouseClick(field<QPushButton>("videoCancel"), Qt::LeftButton);
  QVERIFY(waitFor([this] { return isIdle(); }));
  QVERIFY(outcome().contains(QStringLiteral("canceled")));
  QVERIFY(QDir(file("canceled")).isEmpty());
}

void VideoExportTest::asksBeforeAFileIsReplaced() {
  QVERIFY(writeTextFile(path("precious.mkv"), "precious"));
  QVERIFY(exportsTo(file("precious.mkv")));
  auto* question = field<QLabel>("videoQuestion");
  QVERIFY(question->isVisible());
  QCOMPARE(*readTextFile(path("precious.mkv")), std::string("precious"));
  // Any change takes the question back.
  field<QCheckBox>("videoStamp")->toggle();
  QVERIFY(!question->isVisible());
  QVERIFY(exportsTo(file("precious.mkv")));
  QVERIFY(question->isVisible());
  start();
  QVERIFY(waitFor([this] { return isIdle(); }));
  QVERIFY(openVideoReader(path("precious.mkv").string(), ""));
}

void VideoExportTest::saysWhatFailed() {
  QVERIFY(exportsTo(file("no/folder/a.mkv")));
  QVERIFY2(outcome().contains(QStringLiteral("no/folder/a.mkv")), qPrintable(outcome()));
  field<QDoubleSpinBox>("videoFrom")->setValue(5000.0);
  field<QDoubleSpinBox>("videoTo")->setValue(6000.0);
  QVERIFY(exportsTo(file("a.mkv")));
  QVERIFY2(outcome().contains(QStringLiteral("no frame")), qPrintable(outcome()));
  QVERIFY(!QFileInfo::exists(file("a.mkv")));
}

void VideoExportTest::closingTheProjectStopsIt() {
  QDir().mkpath(file("closed"));
  field<QDoubleSpinBox>("videoTo")->setValue(-1.0);
  field<QDoubleSpinBox>("videoSpeed")->setValue(0.01);
  setFile(file("closed/a.mkv"));
  const QSignalSpy failed(dialog_, &VideoDialog::failed);
  start();
  QVERIFY(waitFor([&] { return QDir(file("closed")).count() > 2; }));
  open(); // another run
  QCOMPARE(failed.count(), 1);
  QVERIFY(!dialog_->isExporting());
  QVERIFY(waitFor([&] { return QDir(file("closed")).isEmpty(); }));
}

DEWPOINT_WINDOW_TEST(VideoExportTest)

} // namespace dewpoint::tests

#include "video_export_test.moc"
