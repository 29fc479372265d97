// SPDX-License-Identifier: GPL-3.0-or-later
// Two network cameras on this machine's loopback, opened from a project file and tracked live in
// the real window.
#include "core/project/project_save.h"
#include "core/session/snapshot/snapshot.h"
#include "core/setup/new_project/new_project.h"
#include "core/simulation/scene/scene_renderer.h"
#include "tests/capture/mjpeg_server.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/cameraview/camera_view.h"
#include "ui/style/image.h"
#include "ui/widgets/message_bar.h"
#include "ui/widgets/notice_list.h"
#include "ui/workbench/workbench.h"

#include <QLabel>
#include <QToolButton>

#include <array>
#include <memory>

namespace dewpoint::tests {

namespace {

/// JPEG blurs the ball's rim a little; the paper's 3 cm is the bound all the same.
constexpr double kErrorBound = 0.03;
/// Mean difference of a color channel, of 255: JPEG, scaling and the overlay change little.
constexpr double kSamePicture = 15.0;

/// Mean difference of the color channels between a picture and what a view shows of it,
/// letterboxed.
double difference(QWidget& view, const cv::Mat& picture) {
  const QImage grabbed = view.grab().toImage();
  const QSize size = QSize(picture.cols, picture.rows).scaled(view.size(), Qt::KeepAspectRatio);
  const QPoint corner((view.width() - size.width()) / 2, (view.height() - size.height()) / 2);
  const QImage expected =
      toQImage(picture).scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  double sum = 0.0;
  for (int y = 0; y < size.height(); ++y) {
    for (int x = 0; x < size.width(); ++x) {
      const QColor a = grabbed.pixelColor(corner + QPoint(x, y));
      const QColor b = expected.pixelColor(x, y);
      sum += std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
             std::abs(a.blue() - b.blue());
    }
  }
  return sum / (3.0 * size.width() * size.height());
}

/// A picture as a camera sends it: none is like the one before.
cv::Mat sentPicture(const cv::Mat& picture, std::int64_t number) {
  cv::Mat sent = picture.clone();
  sent(cv::Rect(0, 0, 16, 16)).setTo(cv::Scalar::all(40.0 + static_cast<double>(7 * number % 151)));
  return sent;
}

} // namespace

class LiveWindowTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void initTestCase();
  void cleanup() { window_.reset(); }
  void tracksTwoStreamsToTheBall();
  void saysWhichCameraDoesNotAnswer();
  void imagesOfAnySizeAreSeenAtOnce();
  void noticesStayAsLongAsTheirCauses();

private:
  /// A project file with two stream cameras of the scene, at these addresses.
  std::filesystem::path savedProject(const std::string& first, const std::string& second) const;

  Scene scene_ = demoScene();
  std::array<cv::Mat, 2> pictures_;
};

void LiveWindowTest::initTestCase() {
  QVERIFY(folder_.isValid());
  scene_.balls.front().motion = Motion::Still;
  const SceneRenderer renderer(scene_);
  pictures_ = {renderer.render(0, 0), renderer.render(1, 0)};
}

std::filesystem::path LiveWindowTest::savedProject(const std::string& first,
                                                   const std::string& second) const {
  Project project = makeSceneProject(scene_, "");
  project.cameras[0].source = project.cameras[1].source = SourceKind::Stream;
  project.cameras[0].location = first;
  project.cameras[1].location = second;
  const std::filesystem::path file = folder_.filePath("live.toml").toStdString();
  if (const auto saved = saveProject(project, file); !saved) {
    qFatal("%s", errorSentence(saved.error()).c_str());
  }
  return file;
}

void LiveWindowTest::imagesOfAnySizeAreSeenAtOnce() {
  const cv::Mat wide(720, 1280, CV_8UC3, cv::Scalar(40, 90, 160));
  const cv::Mat tall(600, 480, CV_8UC3, cv::Scalar(40, 90, 160));
  const test::MjpegServer left([&](auto&&...) { return wide; });
  const test::MjpegServer right([&](auto&&...) { return tall; });
  NewProject wanted;
  wanted.cameras = {{"left", SourceKind::Stream, left.address()},
                    {"right", SourceKind::Stream, right.address()}};
  const auto made = createNewProject(wanted);
  QVERIFY(made);
  const std::filesystem::path file = folder_.filePath("sizes.toml").toStdString();
  QVERIFY(saveProject(made->project, file));
  makeWindow({});
  open(file);
  const auto isSeen = [this](std::size_t camera, const cv::Size& size) {
    const auto shown = window_->shown();
    const FramePtr frame = shown && shown->frames ? shown->frames->frames[camera] : nullptr;
    return frame != nullptr && frame->image.size() == size &&
           (*shown->rig)[camera].intrinsics.width == size.width &&
           (*shown->rig)[camera].intrinsics.height == size.height;
  };
  QVERIFY(waitFor([&] { return isSeen(0, wide.size()) && isSeen(1, tall.size()); }));
}

void LiveWindowTest::tracksTwoStreamsToTheBall() {
  const test::MjpegServer left(
      [this](std::int64_t number) { return sentPicture(pictures_[0], number); });
  const test::MjpegServer right(
      [this](std::int64_t number) { return sentPicture(pictures_[1], number); });
  makeWindow({.play = false});
  open(savedProject(left.address(), right.address()));
  QTest::mouseClick(find<QToolButton>("actionPlayButton"), Qt::LeftButton);

  const Eigen::Vector3d truth = ballPosition(scene_, 0, 0.0);
  const auto error = [&] {
    const auto& targets = window_->shown()->targets;
    return targets.empty() || !std::get<SphereEstimate>(targets.front().estimate).isValid
               ? 1.0
               : (std::get<SphereEstimate>(targets.front().estimate).mean - truth).norm();
  };
  QVERIFY(waitFor([&] { return window_->shown() && error() < kErrorBound; }));
  QVERIFY(!window_->shown()->frameCount.has_value()); // it is live
  const auto held = [&](int camera) {
    return find<QLabel>(QStringLiteral("cameraDock%1TitleState").arg(camera))
        ->text()
        .contains(QStringLiteral("● tracking"));
  };
  QVERIFY(waitFor([&] { return held(0) && held(1); }));
  QVERIFY(waitFor([this] { return shown().liveLatency.draw.longest > 0.0; }));
  QTest::mouseClick(find<QToolButton>("actionPlayButton"), Qt::LeftButton); // pause
  QVERIFY(waitFor([&] { return window_->shown()->state == PlayState::Paused; }));
  for (const std::size_t camera : {0U, 1U}) {
    auto* view = find<CameraView>(QStringLiteral("cameraView%1").arg(camera));
    QVERIFY(draws(*view));
    QVERIFY2(difference(*view, pictures_[camera]) < kSamePicture,
             qPrintable(QString::number(difference(*view, pictures_[camera]))));
    // The bound tells pictures apart: a uniform gray is none of them.
    const cv::Mat gray(pictures_[camera].size(), CV_8UC3, cv::Scalar::all(128));
    QVERIFY(difference(*view, gray) > kSamePicture);
  }
  // Where the time from light to estimate, and to the screen, goes.
  const QString latency = find<QLabel>("statusLiveLatency")->text();
  QVERIFY2(latency.contains(QStringLiteral("capture")), qPrintable(latency));
  QVERIFY2(latency.contains(QStringLiteral("\n99th percentile: capture")), qPrintable(latency));
  const LiveLatency live = shown().liveLatency;
  QVERIFY(live.total.longest > 0.0 && live.wait.longest > 0.0 && live.decode.longest > 0.0);
  window_.reset(); // before its cameras are gone
}

void LiveWindowTest::saysWhichCameraDoesNotAnswer() {
  const test::MjpegServer left(
      [this](std::int64_t number) { return sentPicture(pictures_[0], number); });
  std::string nobody;
  {
    const test::MjpegServer gone(
        [this](std::int64_t number) { return sentPicture(pictures_[1], number); });
    nobody = gone.address();
  }
  makeWindow();
  window_->openProject(savedProject(left.address(), nobody));
  auto* message = find<QLabel>("noticesText");
  QVERIFY(waitFor([&] { return message->isVisible(); }));
  QVERIFY2(message->text().contains(QString::fromStdString(nobody)), qPrintable(message->text()));
  // The other one is shown all the same.
  auto* view = find<CameraView>("cameraView0");
  QVERIFY(waitFor([&] { return difference(*view, pictures_[0]) < kSamePicture; }));
  window_.reset();
}

void LiveWindowTest::noticesStayAsLongAsTheirCauses() {
  auto left = std::make_unique<test::MjpegServer>(
      [this](std::int64_t number) { return sentPicture(pictures_[0], number); });
  auto right = std::make_unique<test::MjpegServer>(
      [this](std::int64_t number) { return sentPicture(pictures_[1], number); });
  makeWindow();
  open(savedProject(left->address(), right->address()));
  QVERIFY(waitFor([this] { return shown().frames != nullptr; }));
  const auto& notices = find<NoticeList>("noticeList")->notices();
  QVERIFY(waitFor([&] { return notices.isEmpty(); }));
  left.reset();
  right.reset();
  QVERIFY(waitFor([&] { return notices.size() == 2; })); // both, not only the last one
  auto* text = find<QLabel>("noticesText");
  QVERIFY(text->isVisible());
  QVERIFY2(text->text().contains(QStringLiteral("camera 1")) &&
               text->text().contains(QStringLiteral("camera 2")),
           qPrintable(text->text()));
  // Hidden ones can be shown again; the views and the log have them all the while.
  QTest::mouseClick(find<QToolButton>("noticesClose"), Qt::LeftButton);
  QVERIFY(!text->isVisible());
  auto* hidden = find<QToolButton>("hiddenNotices");
  QVERIFY(waitFor([&] { return hidden->isVisible(); }));
  QTest::mouseClick(hidden, Qt::LeftButton);
  QVERIFY(waitFor([&] { return text->isVisible() && !hidden->isVisible(); }));
  const QStringList& recent = window_->workbench().messages.recentMessages();
  QVERIFY(recent.filter(QStringLiteral("camera 1")).size() > 0);
  QVERIFY(recent.filter(QStringLiteral("camera 2")).size() > 0);
  action("actionCloseProject")->trigger();
  QVERIFY(waitFor([&] { return notices.isEmpty() && !text->isVisible(); }));
}

DEWPOINT_WINDOW_TEST(LiveWindowTest)

} // namespace dewpoint::tests

#include "live_window_test.moc"
