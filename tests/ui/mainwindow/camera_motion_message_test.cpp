// SPDX-License-Identifier: GPL-3.0-or-later
// A camera is turned during a run: the window says so, and one click puts it right. A board that is
// shown to live cameras to calibrate them is no such turn.
#include "core/calibration/manual/moved_camera_pose.h"
#include "core/capture/recording.h"
#include "core/simulation/scene/scene_catalog.h"
#include "core/simulation/scene/scene_renderer.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/calibration/board/board_calibrator.h"
#include "ui/document/document.h"
#include "ui/text/camera_motion_text.h"
#include "ui/widgets/message_bar.h"

#include <QLabel>
#include <QPushButton>
#include <QUndoStack>

#include <atomic>
#include <chrono>
#include <memory>
#include <numbers>
#include <thread>
#include <utility>

namespace dewpoint::tests {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr int kMoved = 1;
constexpr std::int64_t kMotionFrame = 40;

Scene stillScene() {
  Scene scene = *loadScene("demo");
  scene.framesPerSecond = 10.0;
  scene.frameCount = 2000;
  return scene;
}

Camera movedCamera() {
  return rotatedCamera(stillScene().cameras[kMoved], Eigen::Vector3d(0.2, -0.4, 0.1) * kDegree);
}

/// The same scene after the camera was moved.
Scene movedScene() {
  Scene scene = stillScene();
  scene.cameras[kMoved] = movedCamera();
  return scene;
}

/// The demo, whose second camera is turned from kMotionFrame on.
Result<SessionInputs> openMoved(const SessionRequest&) {
  const Scene scene = stillScene();
  const auto still = std::make_shared<const SceneRenderer>(scene);
  const auto rotated = std::make_shared<const SceneRenderer>(movedScene());
  std::vector<RecordedCamera> cameras;
  for (std::size_t k = 0; k < scene.cameras.size(); ++k) {
    RecordedCamera camera;
    camera.name = scene.cameras[k].name;
    camera.kind = RecordedCamera::Kind::Generated;
    camera.width = scene.cameras[k].intrinsics.width;
    camera.height = scene.cameras[k].intrinsics.height;
    camera.generate = [still, rotated, k](std::int64_t frame) {
      return (frame < kMotionFrame ? still : rotated)->render(static_cast<int>(k), frame);
    };
    camera.generatedFrameCount = scene.frameCount;
    cameras.push_back(std::move(camera));
  }
  auto source = openRecording(cameras, scene.framesPerSecond);
  if (!source) {
    return tl::unexpected(source.error());
  }
  SessionInputs inputs{makeSceneProject(scene, "demo"), std::move(*source), {}};
  return inputs;
}

/// The demo before live cameras, ten frames to a second of their time stamps; the second camera is
/// turned as long as `turned` is set.
class TurnedDemo final : public FrameSetSource {
public:
  explicit TurnedDemo(std::shared_ptr<const std::atomic<bool>> turned)
      : turned_(std::move(turned)) {}

  std::optional<std::int64_t> frameCount() const override { return std::nullopt; }
  double framesPerSecond() const override { return still_.scene().framesPerSecond; }
  Status seek(std::int64_t) override { return {}; }
  Result<FrameSetPtr> next() override {
    std::this_thread::sleep_for(std::chrono::milliseconds(10)); // the window has its turns as well
    auto set = std::make_shared<FrameSet>();
    set->index = index_++;
    set->time = timeStamp(frameTime(still_.scene(), set->index));
    const SceneRenderer& now = *turned_ ? rotated_ : still_;
    for (int k = 0; k < static_cast<int>(still_.scene().cameras.size()); ++k) {
      set->frames.push_back(
          std::make_shared<const Frame>(Frame{set->index, set->time, now.render(k, set->index)}));
    }
    return set;
  }

private:
  std::shared_ptr<const std::atomic<bool>> turned_;
  SceneRenderer still_{stillScene()};
  SceneRenderer rotated_{movedScene()};
  std::int64_t index_ = 0;
};

double degreesBetween(const Camera& a, const Camera& b) {
  return Eigen::AngleAxisd(a.cameraFromWorld.linear() * b.cameraFromWorld.linear().transpose())
             .angle() /
         kDegree;
}

} // namespace

class CameraMotionMessageTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void cleanup() { window_.reset(); }
  void aClickSolvesTheCameraAgain();
  void whileABoardIsShownNoCameraIsTakenForMoved();

private:
  /// Waits until so many more frames were tracked.
  bool passes(std::int64_t frames) {
    const auto before = shown().frame;
    return waitFor([&] { return shown().frame >= before + frames; });
  }
  const Camera& camera() { return window_->document().project().cameras[kMoved].camera; }
  QPushButton* answer() {
    auto* button = window_->findChild<QPushButton*>("messageAnswer0");
    return button != nullptr && button->isVisible() ? button : nullptr;
  }
};

void CameraMotionMessageTest::aClickSolvesTheCameraAgain() {
  makeWindow({.opener = &openMoved, .size = {1400, 900}, .theme = Theme::Light});
  open();
  const Camera before = camera();
  const double error = degreesBetween(before, movedCamera()); // 0.46 degrees
  QVERIFY(error > 0.4);
  QVERIFY(waitFor([&] { return answer() != nullptr; }));
  QVERIFY(window_->shown()->frame > kMotionFrame);
  const QString said = find<MessageBar>("messageBar")->text();
  const QString name = QString::fromStdString(before.name);
  QVERIFY2(said.contains(name), qPrintable(said));
  QVERIFY2(answer()->text().contains(name), qPrintable(answer()->text()));
  // Its view says so, too, and no other.
  const auto title = [&](int k) {
    return find<QLabel>(QStringLiteral("cameraDock%1TitleReason").arg(k))
        ->toolTip(); // also where it is cut
  };
  QCOMPARE(title(kMoved), cameraMotionText(cameraMotionOf(*window_->shown(), kMoved)));
  QVERIFY(!title(kMoved).isEmpty());
  QVERIFY(cameraMotionOf(*window_->shown(), 0) == nullptr);
  // Some more of the target's sightings, then the click.
  const auto frame = window_->shown()->frame;
  QVERIFY(waitFor([&] { return window_->shown()->frame > frame + 30; }));
  QVERIFY(answer() != nullptr);
  answer()->click();
  QVERIFY(degreesBetween(camera(), movedCamera()) < 0.15 * error);
  QUndoStack& history = *window_->document().undoStack();
  QCOMPARE(history.count(), 1);
  QVERIFY(history.undoText().contains(name));
  // Only that camera; the run takes it and reports no more.
  const auto& cameras = window_->document().project().cameras;
  QVERIFY(cameras[0].camera == stillScene().cameras[0]);
  QVERIFY(waitFor([&] {
    return window_->shown()->cameraMotions.empty() && (*window_->shown()->rig)[kMoved] == camera();
  }));
  QVERIFY(answer() == nullptr);
  history.undo();
  QVERIFY(camera() == before);
}

// What a waved board does to the images, a turned camera does as well, and that is noticed for sure
// when somebody looks: within two seconds (camera_motion_detector_test.cpp).
void CameraMotionMessageTest::whileABoardIsShownNoCameraIsTakenForMoved() {
  constexpr std::int64_t kLongEnough = 40; // frames: 4 s
  const auto turned = std::make_shared<std::atomic<bool>>(false);
  makeWindow({.opener = [turned](const SessionRequest&) -> Result<SessionInputs> {
                return SessionInputs{makeSceneProject(stillScene(), "demo"),
                                     std::make_unique<TurnedDemo>(turned),
                                     {}};
              },
              .size = {1400, 900},
              .theme = Theme::Light});
  open();
  auto* board = window_->findChild<BoardCalibrator*>();
  QVERIFY(board != nullptr);
  QVERIFY(waitFor([&] { return board->usesLiveCameras(); }));
  QVERIFY(passes(kLongEnough)); // the cameras are watched, and stand still
  QVERIFY(shown().cameraMotions.empty());

  action("actionCalibrateBoard")->trigger();
  find<QPushButton>("boardStart")->click();
  QVERIFY(board->isGuiding());
  *turned = true;
  QVERIFY(passes(kLongEnough));
  QVERIFY(shown().cameraMotions.empty());
  // Afterwards it stands as it was calibrated, as it does then; the board is put down for 3 s.
  board->stopGuidance();
  QVERIFY(passes(30 + kLongEnough));
  QVERIFY(shown().cameraMotions.empty());
  // Now that no board is shown, the same turn is one.
  *turned = false;
  QVERIFY(waitFor([&] { return !shown().cameraMotions.empty(); }));
  QCOMPARE(shown().cameraMotions.front().event.camera, std::size_t{kMoved});
}

DEWPOINT_WINDOW_TEST(CameraMotionMessageTest)

} // namespace dewpoint::tests

#include "camera_motion_message_test.moc"
