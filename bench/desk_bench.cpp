// SPDX-License-Identifier: GPL-3.0-or-later
//
// The window at work: how long its event loop stalls while a person begins, and what four 640x480
// views with particles and the bird's-eye view achieve. Needs a display (xvfb-run will do).
#include "app/wiring/open_project.h"
#include "app/wiring/quiet_libraries.h"
#include "core/project/project_save.h"
#include "core/session/snapshot/snapshot.h"
#include "core/simulation/scene/scene_renderer.h"
#include "tests/ui/event_loop_probe.h"
#include "ui/calibration/manual/grid_layer.h"
#include "ui/calibration/planner/rig_planner.h"
#include "ui/cameraview/camera_view.h"
#include "ui/document/document.h"
#include "ui/mainwindow/main_window.h"
#include "ui/view3d/birds_eye_view.h"

#include <QAction>
#include <QApplication>
#include <QMouseEvent>
#include <QTemporaryDir>
#include <QToolButton>
#include <fmt/format.h>
#include <opencv2/videoio.hpp>

#include <algorithm>
#include <functional>
#include <vector>

namespace dewpoint::bench {
namespace {

using tests::EventLoopProbe;

constexpr int kCameras = 4;
constexpr int kFrames = 300;
constexpr int kSettleMs = 3000;
constexpr int kMeasureMs = 10000;
constexpr int kTimeoutMs = 60000;
constexpr int kMoves = 100;
constexpr int kBetweenMovesMs = 20;

/// The demo's ball, seen by four 640x480 cameras around it.
Scene fourCameraScene() {
  Scene scene = demoScene();
  scene.name = "four cameras";
  scene.frameCount = kFrames;
  scene.cameras.clear();
  for (int k = 0; k < kCameras; ++k) {
    const double angle = 0.4 + 1.57 * k;
    Camera camera;
    camera.name = fmt::format("camera {}", k + 1);
    camera.intrinsics = {640, 480, 700.0, 700.0, 319.5, 239.5};
    camera.cameraFromWorld =
        lookAt({0.5 + 1.1 * std::cos(angle), 0.5 + 1.1 * std::sin(angle), 0.7}, {0.5, 0.5, 0.15});
    scene.cameras.push_back(camera);
  }
  return scene;
}

/// Records it as MJPEG, what cheap cameras deliver.
std::filesystem::path recordFour(const std::filesystem::path& folder) {
  const Scene scene = fourCameraScene();
  const SceneRenderer renderer(scene);
  Project project = makeSceneProject(scene, "");
  for (int k = 0; k < kCameras; ++k) {
    auto& camera = project.cameras[static_cast<std::size_t>(k)];
    camera.source = SourceKind::Video;
    camera.location = (folder / fmt::format("{}.avi", k)).string();
    cv::VideoWriter writer(camera.location, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'),
                           scene.framesPerSecond, {640, 480});
    for (int frame = 0; frame < kFrames; ++frame) {
      writer.write(renderer.render(k, frame));
    }
  }
  const auto file = folder / "project.toml";
  if (!saveProject(project, file)) {
    std::exit(1);
  }
  return file;
}

/// Counts how often widgets are painted.
class PaintCounter : public QObject {
public:
  bool eventFilter(QObject*, QEvent* event) override {
    paints += event->type() == QEvent::Paint ? 1 : 0;
    return false;
  }
  int paints = 0;
};

bool waitUntil(const std::function<bool()>& holds, int patienceMs) {
  QElapsedTimer clock;
  clock.start();
  while (!holds() && clock.elapsed() < patienceMs) {
    QApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents, 5);
  }
  return holds();
}

void wait(int milliseconds) {
  waitUntil([] { return false; }, milliseconds);
}

class Bench {
public:
  int run() {
    measure("window shown", [this] {
      window_.setTheme(Theme::Light);
      window_.resize(1600, 1000);
      window_.show();
      wait(1000);
    });
    measure("demo opened and played, 3 s", [this] {
      window_.findChild<QToolButton*>("startDemo")->click();
      wait(kSettleMs);
    });
    measure("mask shown, paused, stepped, undone", [this] {
      for (const char* id : {"actionShowMask", "actionPlay", "actionNextFrame", "actionNextFrame",
                             "actionRestart", "actionShowMask", "actionPlay"}) {
        window_.findChild<QAction*>(QLatin1String(id))->trigger();
        wait(300);
      }
    });
    measure("other theme", [this] {
      window_.setTheme(Theme::Dark);
      wait(500);
    });
    measure("project closed", [this] {
      window_.findChild<QAction*>("actionCloseProject")->trigger();
      wait(500);
    });
    QTemporaryDir folder;
    const auto file = recordFour(folder.path().toStdString());
    wait(100); // recording was no work of the window
    probe_.takeLongest();
    measure("four 640x480 recordings opened", [&] {
      window_.openProject(file);
      waitUntil([this] { return window_.shown() && window_.shown()->frame > 5; }, kTimeoutMs);
      wait(1000);
    });
    fourViews();
    fourMasks();
    fourGrids();
    mapWhileMoving();
    return 0;
  }

private:
  void measure(const char* what, const std::function<void()>& act) {
    act();
    fmt::print("{:<44} longest stall {:6.0f} ms\n", what, probe_.takeLongest());
  }

  void fourViews() {
    PaintCounter cameras;
    PaintCounter birdsEye;
    for (CameraView* view : window_.findChildren<CameraView*>()) {
      view->installEventFilter(&cameras);
    }
    window_.findChild<BirdsEyeView*>()->installEventFilter(&birdsEye);
    probe_.takeLongest();
    wait(kMeasureMs / 2); // half the recording
    const double seconds = 1e-3 * kMeasureMs / 2;
    fmt::print("four 640x480 views at 30 frames/s, {:.0f} s\n", seconds);
    fmt::print("  tracked                {:6.1f} /s\n", window_.shown()->framesPerSecond);
    fmt::print("  each camera view drawn {:6.1f} /s\n", cameras.paints / seconds / kCameras);
    fmt::print("  bird's-eye view drawn  {:6.1f} /s\n", birdsEye.paints / seconds);
    fmt::print("  longest stall          {:6.0f} ms\n", probe_.takeLongest());
  }

  /// From a moved handle of the color range to the masks of all four views, paused.
  void fourMasks() {
    window_.findChild<QAction*>("actionShowMask")->setChecked(true);
    window_.findChild<QAction*>("actionPlay")->trigger();
    wait(500);
    std::vector<double> milliseconds;
    for (int move = 0; move < kMoves; ++move) {
      const TrackSnapshotPtr before = window_.shown();
      QElapsedTimer clock;
      clock.start();
      (void)window_.document().edit(
          QStringLiteral("Change color range"),
          [&](Project& project) { project.targets[0].color.hueMin += 0.1; }, "drag");
      const auto views = window_.findChildren<CameraView*>();
      waitUntil(
          [&] {
            return window_.shown() != before && std::ranges::all_of(views, &CameraView::isDrawn);
          },
          kTimeoutMs);
      for (CameraView* view : views) {
        view->repaint();
      }
      milliseconds.push_back(1e-6 * static_cast<double>(clock.nsecsElapsed()));
    }
    std::ranges::sort(milliseconds);
    fmt::print("range handle moved: four masks on screen after {:.1f} ms (median of {}), {:.1f} ms "
               "at most; a frame of the display is 16 ms\n",
               milliseconds[kMoves / 2], kMoves, milliseconds.back());
  }

  /// From a move of the mouse to the new grid in all four views, two points held, paused.
  void fourGrids() {
    window_.findChild<QAction*>("actionShowMask")->setChecked(false);
    window_.findChild<QAction*>("actionCalibrateByHand")->setChecked(true);
    wait(1000);
    auto* layer = window_.findChild<GridLayer*>("gridLayer0");
    const QPointF middle = layer->rect().toRectF().center();
    const auto send = [&](QEvent::Type type, QPointF at) {
      const bool moves = type == QEvent::MouseMove;
      QMouseEvent event(type, at, layer->mapToGlobal(at), moves ? Qt::NoButton : Qt::LeftButton,
                        type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, {});
      QApplication::sendEvent(layer, &event);
    };
    for (const QPointF& offset : {QPointF(-50.0, 40.0), QPointF(60.0, 50.0)}) {
      send(QEvent::MouseButtonPress, middle + offset);
      send(QEvent::MouseButtonRelease, middle + offset);
    }
    std::vector<double> milliseconds;
    const QPointF from = middle + QPointF(0.0, 20.0);
    send(QEvent::MouseButtonPress, from);
    for (int move = 0; move < kMoves; ++move) {
      QElapsedTimer clock;
      clock.start();
      send(QEvent::MouseMove, from + QPointF(4.0 + 0.3 * move, 0.2 * move));
      for (GridLayer* each : window_.findChildren<GridLayer*>()) {
        each->repaint();
      }
      milliseconds.push_back(1e-6 * static_cast<double>(clock.nsecsElapsed()));
      wait(10);
    }
    send(QEvent::MouseButtonRelease, from);
    std::ranges::sort(milliseconds);
    fmt::print(
        "grid dragged, two points held: four grids on screen after {:.1f} ms (median of {}), "
        "{:.1f} ms at most\n",
        milliseconds[kMoves / 2], kMoves, milliseconds.back());
  }

  /// How often the map of what the cameras see follows a camera that is dragged, on screen.
  void mapWhileMoving() {
    window_.findChild<QAction*>("actionShowMap")->setChecked(true);
    wait(2000);
    PaintCounter birdsEye;
    window_.findChild<BirdsEyeView*>()->installEventFilter(&birdsEye);
    int maps = 0;
    auto* desk = window_.findChild<RigPlanner*>();
    const auto counting =
        QObject::connect(desk, &RigPlanner::mapChanged, &window_, [&maps] { ++maps; });
    probe_.takeLongest();
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < kSettleMs) {
      (void)window_.document().edit(
          QStringLiteral("Move camera"),
          [](Project& project) {
            project.cameras[0].camera.cameraFromWorld.translation().x() += 0.001;
          },
          "drag");
      wait(kBetweenMovesMs);
    }
    QObject::disconnect(counting);
    const double seconds = 1e-3 * static_cast<double>(clock.elapsed());
    fmt::print("camera dragged, map shown: {:.1f} maps/s, bird's-eye view drawn {:.1f} /s, longest "
               "stall {:.0f} ms\n",
               maps / seconds, birdsEye.paints / seconds, probe_.takeLongest());
  }

  MainWindow window_{&openProject};
  EventLoopProbe probe_; ///< after the window: making it is launching
};

} // namespace
} // namespace dewpoint::bench

int main(int argc, char** argv) {
  dewpoint::app::silenceLibraries();
  dewpoint::ui::BirdsEyeView::prepareSurfaceFormat();
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("dewpoint-bench"));
  return dewpoint::bench::Bench().run();
}
