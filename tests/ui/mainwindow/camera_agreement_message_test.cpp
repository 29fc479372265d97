// SPDX-License-Identifier: GPL-3.0-or-later
// Cameras cannot agree: the window says why, and one click mends it.
#include "core/capture/recording.h"
#include "core/simulation/scene/scene_catalog.h"
#include "core/simulation/scene/scene_renderer.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/document/document.h"
#include "ui/widgets/message_bar.h"

#include <QPushButton>
#include <QUndoStack>

#include <memory>
#include <utility>

namespace dewpoint::tests {
namespace {

/// The demo with a ball that moves from the start, and with two cameras of one kind: others could
/// not be taken for each other.
Scene demo() {
  Scene scene = *loadScene("demo");
  scene.cameras[1].intrinsics = scene.cameras[0].intrinsics;
  scene.balls.front().stillSeconds = 0.0;
  scene.framesPerSecond = 15.0;
  scene.frameCount = 2000;
  return scene;
}

/// The demo with its project as `spoil` leaves it, and the images of `cameras` in their order.
Result<SessionInputs> spoiled(const std::vector<std::size_t>& order,
                              const std::function<void(Project&)>& spoil) {
  const Scene scene = demo();
  const auto renderer = std::make_shared<const SceneRenderer>(scene);
  std::vector<RecordedCamera> cameras;
  for (const std::size_t shown : order) {
    RecordedCamera camera;
    camera.name = scene.cameras[cameras.size()].name;
    camera.kind = RecordedCamera::Kind::Generated;
    camera.width = scene.cameras[shown].intrinsics.width;
    camera.height = scene.cameras[shown].intrinsics.height;
    camera.generate = [renderer, shown](std::int64_t frame) {
      return renderer->render(static_cast<int>(shown), frame);
    };
    camera.generatedFrameCount = scene.frameCount;
    cameras.push_back(std::move(camera));
  }
  auto source = openRecording(cameras, scene.framesPerSecond);
  if (!source) {
    return tl::unexpected(source.error());
  }
  SessionInputs inputs{makeSceneProject(scene, "demo"), std::move(*source), {}};
  spoil(inputs.project);
  return inputs;
}

} // namespace

class CameraAgreementMessageTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void cleanup() { window_.reset(); }
  void swappedCamerasAreExchangedByAClick();
  void aRigInMillimetersIsConvertedByAClick();
  void nothingIsAskedWhileAPageForCalibrationIsShown();

private:
  QPushButton* answer() {
    auto* button = window_->findChild<QPushButton*>("messageAnswer0");
    return button != nullptr && button->isVisible() ? button : nullptr;
  }
  QString said() { return find<MessageBar>("messageBar")->text(); }
  const Camera& camera(std::size_t k) { return window_->document().project().cameras[k].camera; }
  QUndoStack& history() { return *window_->document().undoStack(); }
};

void CameraAgreementMessageTest::swappedCamerasAreExchangedByAClick() {
  makeWindow({.opener =
                  [](const SessionRequest&) {
                    return spoiled({1, 0}, [](Project&) {});
                  },
              .size = {1400, 900},
              .theme = Theme::Light});
  open();
  const Eigen::Isometry3d first = camera(0).cameraFromWorld;
  const Eigen::Isometry3d second = camera(1).cameraFromWorld;
  QVERIFY(waitFor([&] { return answer() != nullptr; }));
  QVERIFY2(said().contains(QStringLiteral("swapped")), qPrintable(said()));
  QVERIFY(shown().frames && seconds(shown().frames->time) < 4.0);
  if (qEnvironmentVariableIsSet("DEWPOINT_SCREENSHOTS")) {
    window_->grab().save(qEnvironmentVariable("DEWPOINT_SCREENSHOTS") +
                         QStringLiteral("/camera-agreement.png"));
  }
  answer()->click();
  QCOMPARE(history().count(), 1);
  QVERIFY(camera(0).cameraFromWorld.isApprox(second)); // a scene's images are made as they are
  QVERIFY(waitFor([&] { return shown().disagreements.empty(); }));
  const auto frame = shown().frame;
  QVERIFY(waitFor([&] { return shown().frame > frame + 60; })); // 4 s
  QVERIFY(shown().disagreements.empty());
  history().undo();
  QVERIFY(camera(0).cameraFromWorld.isApprox(first));
  QVERIFY(waitFor([&] { return answer() != nullptr; }));
}

void CameraAgreementMessageTest::aRigInMillimetersIsConvertedByAClick() {
  makeWindow({.opener =
                  [](const SessionRequest&) {
                    return spoiled({0, 1}, [](Project& project) {
                      for (ProjectCamera& one : project.cameras) {
                        one.camera.cameraFromWorld.translation() *= 1000.0;
                      }
                    });
                  },
              .size = {1400, 900},
              .theme = Theme::Light,
              .play = false});
  open();
  QVERIFY(waitFor([&] { return answer() != nullptr; })); // before anything moved
  QVERIFY2(said().contains(QStringLiteral("millimeters")), qPrintable(said()));
  answer()->click();
  QVERIFY(camera(0).center().isApprox(demo().cameras[0].center(), 1e-9));
  QVERIFY(waitFor([&] { return shown().disagreements.empty(); }));
  history().undo();
  QVERIFY(camera(0).center().norm() > 100.0);
  QVERIFY(waitFor([&] { return answer() != nullptr; }));
}

void CameraAgreementMessageTest::nothingIsAskedWhileAPageForCalibrationIsShown() {
  makeWindow({.opener =
                  [](const SessionRequest&) {
                    return spoiled({1, 0}, [](Project&) {});
                  },
              .size = {1400, 900},
              .theme = Theme::Light,
              .play = false});
  open();
  const auto isSaid = [this] { return said().contains(QStringLiteral("swapped")); };
  action("actionCalibrateBoard")->trigger();
  action("actionPlay")->trigger();
  QVERIFY(waitFor([this] { return !shown().disagreements.empty(); }));
  for (const char* page :
       {"actionCalibrateWand", "actionCalibrateWorld", "actionCalibrateBoard", "actionCalibrate"}) {
    action(page)->trigger();
    const auto frame = shown().frame;
    QVERIFY(waitFor([&] { return shown().frame > frame + 5; }));
    QVERIFY(!shown().disagreements.empty());
    QVERIFY2(!isSaid(), page);
  }
  action("actionCalibrateByHand")->setChecked(false);
  QVERIFY(waitFor(isSaid));
}

DEWPOINT_WINDOW_TEST(CameraAgreementMessageTest)

} // namespace dewpoint::tests

#include "camera_agreement_message_test.moc"
