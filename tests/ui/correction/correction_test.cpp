// SPDX-License-Identifier: GPL-3.0-or-later
// "Correct position" in the window: a target is dragged in the images, which is a correction of the
// project; tracking goes on from there, all views show it, and it can be taken back.
#include "core/geometry/ray.h"
#include "core/project/project.h"
#include "core/project/project_save.h"
#include "core/session/session.h"
#include "core/tracking/catalog/method_catalog.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/image_pick_overlay.h"
#include "ui/document/document.h"
#include "ui/selection/selection.h"
#include "ui/timeline/timeline.h"
#include "ui/trajectory/trajectory_model.h"
#include "ui/trajectory/trajectory_panel.h"
#include "ui/workbench/workbench.h"

#include <QDockWidget>
#include <QMouseEvent>
#include <QTableView>
#include <QUndoStack>

#include <algorithm>
#include <cmath>

namespace dewpoint::tests {

namespace {

constexpr std::int64_t kTrackedFrames = 25;  ///< frames tracked at first
constexpr std::int64_t kCorrectedFrame = 12; ///< of them, the one that is corrected

/// Distance of a pixel to the strokes of the guides.
double distanceTo(const std::vector<QPolygonF>& lines, const Eigen::Vector2d& pixel) {
  double nearest = 1e9;
  for (const QPolygonF& line : lines) {
    for (qsizetype k = 1; k < line.size(); ++k) {
      const Eigen::Vector2d from(line[k - 1].x(), line[k - 1].y());
      const Eigen::Vector2d way = Eigen::Vector2d(line[k].x(), line[k].y()) - from;
      const double share =
          std::clamp((pixel - from).dot(way) / std::max(way.squaredNorm(), 1e-12), 0.0, 1.0);
      nearest = std::min(nearest, (pixel - from - share * way).norm());
    }
  }
  return nearest;
}

} // namespace

class CorrectionTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup() { window_.reset(); }
  void aDragKeepsTheDepthAndIsTrackedOnFrom();
  void twoImagesFixThePosition();
  void otherViewsShowTheRay();
  void atTheHeadTheRunGoesOnFromIt();
  void itIsMarkedRemovedAndUndone();
  void keysDoTheSame();
  void withoutTheModeImagesAreAsBefore();
  void otherModesEndIt();
  void playingIsPaused();
  void framesBeforeItAreTrackedToo();

private:
  /// Opens a project (the demo: an empty path) and tracks its first frames.
  void trackBeginOf(const std::filesystem::path& project);
  const std::vector<PositionCorrection>& corrections() const {
    return window_->document().project().corrections;
  }
  const Camera& camera(int k) const { return shown().rig->at(static_cast<std::size_t>(k)); }
  Eigen::Vector2d pixelOf(int k, const Eigen::Vector3d& position) const {
    return Projector(camera(k)).project(position).value();
  }
  Eigen::Vector3d estimate() const { return positionOf(shown().targets.at(0).estimate)->mean; }
  ImagePickOverlay* layer(int k) const {
    return find<ImagePickOverlay>(QStringLiteral("cameraView%1Correction").arg(k));
  }
  QUndoStack& history() { return *window_->document().undoStack(); }
  bool shows(std::int64_t frame) const {
    return waitFor([&] { return shown().frame == frame && !shown().rerun; });
  }
  void show(std::int64_t frame) {
    window_->selection().requestFrame(frame);
    QVERIFY(shows(frame));
  }
  void begin() {
    action("actionCorrectPosition")->setChecked(true);
    QVERIFY(layer(0)->isVisible());
    QVERIFY(layer(1)->isVisible());
  }
  /// By event: QTest knows whole pixels only.
  void mouse(int k, QEvent::Type type, const Eigen::Vector2d& pixel) {
    const ImagePlacement& placement =
        find<CameraView>(QStringLiteral("cameraView%1").arg(k))->placement();
    const QPointF at =
        placement.topLeft + QPointF(pixel.x() + 0.5, pixel.y() + 0.5) * placement.scale;
    const bool moves = type == QEvent::MouseMove;
    const bool down = type != QEvent::MouseButtonRelease;
    QMouseEvent event(type, at, layer(k)->mapToGlobal(at), moves ? Qt::NoButton : Qt::LeftButton,
                      down ? Qt::LeftButton : Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(layer(k), &event);
  }
  void drag(int k, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    mouse(k, QEvent::MouseButtonPress, from);
    mouse(k, QEvent::MouseMove, 0.5 * (from + to));
    mouse(k, QEvent::MouseMove, to);
    mouse(k, QEvent::MouseButtonRelease, to);
  }
  std::vector<TrajectorySample> samples() const {
    return window_->workbench().session.session()->trajectory().samples;
  }
  /// Waits until these frames of the trajectory are corrected, and no others, and all is tracked.
  bool areCorrected(const std::vector<std::int64_t>& frames) const {
    return waitFor([&] {
      const auto all = samples();
      std::vector<std::int64_t> found;
      for (const TrajectorySample& sample : all) {
        if (sample.isCorrected) {
          found.push_back(sample.frame);
        }
      }
      return found == frames && all.size() == std::size_t{kTrackedFrames} && !shown().rerun;
    });
  }
};

void CorrectionTest::init() {
  makeWindow({.size = {1500, 950}, .theme = Theme::Light, .play = false});
  trackBeginOf({});
}

void CorrectionTest::trackBeginOf(const std::filesystem::path& project) {
  open(project);
  QVERIFY(waitFor([this] { return shown().history.newestTrackedFrame == 0; }));
  for (std::int64_t frame = 1; frame < kTrackedFrames; ++frame) {
    action("actionNextFrame")->trigger();
  }
  QVERIFY(waitFor([this] { return shown().history.newestTrackedFrame == kTrackedFrames - 1; }));
  for (const char* name : {"cameraView0", "cameraView1"}) {
    auto* view = find<CameraView>(name);
    QVERIFY(waitFor([&] { return !view->imageSize().isEmpty(); }));
    QVERIFY(keepsItsSize(view));
    QVERIFY(draws(*view));
  }
  QVERIFY(areCorrected({}));
}

void CorrectionTest::aDragKeepsTheDepthAndIsTrackedOnFrom() {
  const auto before = samples();
  show(kCorrectedFrame);
  const Eigen::Vector3d was = estimate();
  const Eigen::Vector2d from = pixelOf(0, was);
  const Eigen::Vector2d to = from + Eigen::Vector2d(12.25, -8.5);
  begin();
  mouse(0, QEvent::MouseButtonPress, from);
  mouse(0, QEvent::MouseMove, to);
  QVERIFY(corrections().empty()); // not before it is let go
  mouse(0, QEvent::MouseButtonRelease, to);
  QCOMPARE(corrections().size(), std::size_t{1});
  const PositionCorrection& made = corrections().front();
  QCOMPARE(made.frame, kCorrectedFrame);
  QCOMPARE(made.target, 0);
  QCOMPARE(made.clicks.size(), std::size_t{1});
  QCOMPARE(made.clicks[0].camera, 0);
  QVERIFY((made.clicks[0].pixel - to).norm() < 1e-6);
  QVERIFY((pixelOf(0, made.position) - to).norm() < 1e-6); // what the image says
  const Ray ray = Unprojector(camera(0)).ray(to).value();
  QVERIFY(std::abs((made.position - was).dot(ray.direction)) < 1e-9); // and the depth kept
  // The frames from there on are tracked again, and the frame is shown again.
  QVERIFY(areCorrected({kCorrectedFrame}));
  QVERIFY(shows(kCorrectedFrame));
  const auto after = samples();
  for (std::size_t k = 0; k < std::size_t{kCorrectedFrame}; ++k) {
    QVERIFY(after[k].position == before[k].position);
  }
  QVERIFY(after[kCorrectedFrame].position != before[kCorrectedFrame].position);
  action("actionUndo")->trigger();
  QVERIFY(corrections().empty());
  QVERIFY(areCorrected({}));
  const auto undone = samples();
  for (std::size_t k = 0; k < undone.size(); ++k) {
    QVERIFY(undone[k].position == before[k].position);
  }
}

void CorrectionTest::twoImagesFixThePosition() {
  show(kCorrectedFrame);
  QVERIFY(shown().targets.at(0).truth);
  const Eigen::Vector3d truth = *shown().targets.at(0).truth;
  begin();
  drag(0, pixelOf(0, estimate()), pixelOf(0, truth));
  QVERIFY(areCorrected({kCorrectedFrame}));
  QVERIFY(shows(kCorrectedFrame));
  drag(1, pixelOf(1, estimate()), pixelOf(1, truth));
  QCOMPARE(corrections().size(), std::size_t{1});
  QCOMPARE(corrections()[0].clicks.size(), std::size_t{2});
  QVERIFY((corrections()[0].position - truth).norm() < 1e-6); // where the rays meet
  QVERIFY(areCorrected({kCorrectedFrame}));
  QCOMPARE(history().count(), 2);
  action("actionUndo")->trigger();
  QCOMPARE(corrections()[0].clicks.size(), std::size_t{1});
  action("actionUndo")->trigger();
  QVERIFY(corrections().empty());
  QVERIFY(areCorrected({}));
}

void CorrectionTest::otherViewsShowTheRay() {
  show(kCorrectedFrame);
  const Eigen::Vector2d from = pixelOf(0, estimate());
  const Eigen::Vector2d to = from + Eigen::Vector2d(10.0, 6.0);
  begin();
  QVERIFY(layer(1)->guideLines().empty());
  mouse(0, QEvent::MouseButtonPress, from);
  mouse(0, QEvent::MouseMove, to);
  QVERIFY(layer(0)->guideLines().empty()); // there it is a point
  QVERIFY(!layer(1)->guideLines().empty());
  QVERIFY(layer(1)->guidePoint());
  const Ray ray = Unprojector(camera(0)).ray(to).value();
  const double depth = (estimate() - ray.origin).dot(ray.direction);
  for (const double share : {0.9, 1.0, 1.1}) {
    const Eigen::Vector3d point = ray.origin + share * depth * ray.direction;
    QVERIFY(distanceTo(layer(1)->guideLines(), pixelOf(1, point)) < 0.1);
  }
  const QPointF point = *layer(1)->guidePoint();
  const Eigen::Vector2d expected = pixelOf(1, ray.origin + depth * ray.direction);
  QVERIFY(std::hypot(point.x() - expected.x(), point.y() - expected.y()) < 1e-3);
  QTest::keyClick(layer(0), Qt::Key_Escape); // lets it go where it was
  QVERIFY(layer(1)->guideLines().empty());
  mouse(0, QEvent::MouseButtonRelease, to);
  QVERIFY(corrections().empty());
  QVERIFY(action("actionCorrectPosition")->isChecked());
  QTest::keyClick(layer(0), Qt::Key_Escape);
  QVERIFY(!action("actionCorrectPosition")->isChecked());
  QVERIFY(!layer(0)->isVisible());
}

void CorrectionTest::atTheHeadTheRunGoesOnFromIt() {
  QVERIFY(shows(kTrackedFrames - 1));
  const Eigen::Vector2d from = pixelOf(1, estimate());
  begin();
  drag(1, from, from + Eigen::Vector2d(5.0, 5.0));
  QCOMPARE(corrections().size(), std::size_t{1});
  QCOMPARE(corrections()[0].frame, kTrackedFrames - 1);
  QCOMPARE(corrections()[0].clicks.at(0).camera, 1);
  QVERIFY(areCorrected({kTrackedFrames - 1}));
  QCOMPARE(shown().frame, kTrackedFrames - 1);
  action("actionUndo")->trigger();
  QVERIFY(areCorrected({}));
}

void CorrectionTest::itIsMarkedRemovedAndUndone() {
  find<QDockWidget>("trajectoryDock")->raise();
  auto* table = find<QTableView>("trajectoryTable");
  const auto stateIs = [&](const char* word) {
    return waitFor([&] {
      const QModelIndex cell = table->model()->index(kCorrectedFrame, TrajectoryModel::Held);
      return cell.isValid() && cell.data().toString().contains(QLatin1String(word));
    });
  };
  const auto& timeline = find<Timeline>("timeline")->model();
  show(kCorrectedFrame);
  action("actionRemoveCorrection")->trigger(); // there is none
  QCOMPARE(history().count(), 0);
  QVERIFY(messageText().contains(QStringLiteral("no correction")));
  begin();
  const Eigen::Vector2d from = pixelOf(0, estimate());
  drag(0, from, from + Eigen::Vector2d(4.0, 0.0));
  QVERIFY(areCorrected({kCorrectedFrame}));
  QVERIFY(timeline.isCorrected(0, kCorrectedFrame));
  QVERIFY(!timeline.isCorrected(0, kCorrectedFrame + 1));
  QVERIFY(timeline.descriptionOf(kCorrectedFrame).contains(QStringLiteral("corrected")));
  QVERIFY(stateIs("corrected"));
  QVERIFY(shows(kCorrectedFrame));
  action("actionRemoveCorrection")->trigger();
  QVERIFY(corrections().empty());
  QVERIFY(areCorrected({}));
  QVERIFY(!timeline.isCorrected(0, kCorrectedFrame));
  QVERIFY(stateIs("tracking"));
  action("actionUndo")->trigger();
  QVERIFY(areCorrected({kCorrectedFrame}));
  QVERIFY(stateIs("corrected"));
  // From the row of the table.
  auto* panel = window_->findChild<TrajectoryPanel*>();
  Q_EMIT panel->correctionRemovalRequested(kCorrectedFrame, 0);
  QVERIFY(areCorrected({}));
}

void CorrectionTest::keysDoTheSame() {
  show(kCorrectedFrame);
  const Eigen::Vector2d there = pixelOf(0, estimate());
  begin();
  QTest::keyClick(layer(0), Qt::Key_Left); // shows the cross, or moves it
  QTest::keyClick(layer(0), Qt::Key_Right);
  QTest::keyClick(layer(0), Qt::Key_Return);
  QCOMPARE(corrections().size(), std::size_t{1});
  const double step = std::max(1.0, std::round(camera(0).intrinsics.width / 64.0));
  const Eigen::Vector2d clicked = corrections()[0].clicks.at(0).pixel;
  QVERIFY(std::abs(clicked.x() - there.x()) < step + 1e-6); // from the estimate, not the middle
  QVERIFY(std::abs(clicked.y() - there.y()) < 1e-6);
  QVERIFY(areCorrected({kCorrectedFrame}));
}

void CorrectionTest::withoutTheModeImagesAreAsBefore() {
  show(kCorrectedFrame);
  QVERIFY(!layer(0)->isVisible());
  auto* pick = find<ImagePickOverlay>("cameraView1Pick");
  QTest::mousePress(pick, Qt::LeftButton, {}, pick->rect().center());
  QTest::mouseMove(pick, pick->rect().center() + QPoint(40, 20));
  QTest::mouseRelease(pick, Qt::LeftButton, {}, pick->rect().center() + QPoint(40, 20));
  QCOMPARE(window_->selection().camera(), 1);
  QCOMPARE(history().count(), 0);
}

void CorrectionTest::otherModesEndIt() {
  begin();
  action("actionLearnColor")->setChecked(true);
  QVERIFY(!action("actionCorrectPosition")->isChecked());
  QVERIFY(!layer(0)->isVisible());
  begin();
  QVERIFY(!action("actionLearnColor")->isChecked());
  window_->document().setMethod("histogram"); // knows no room
  QVERIFY(!action("actionCorrectPosition")->isChecked());
  QVERIFY(!action("actionCorrectPosition")->isEnabled());
  QVERIFY(!action("actionRemoveCorrection")->isEnabled());
}

void CorrectionTest::playingIsPaused() {
  action("actionPlay")->trigger();
  QVERIFY(waitFor([this] { return shown().state == PlayState::Playing; }));
  begin();
  QVERIFY(waitFor([this] { return shown().state == PlayState::Paused; }));
}

// A filter that starts far from the ball never finds it. Whoever says in frame 12 where it is has
// it in the frames before, too; both are one step.
void CorrectionTest::framesBeforeItAreTrackedToo() {
  auto project = resolveProject("demo");
  QVERIFY(project);
  project->method = "barrera";
  project->parameters = ParameterValues(tracking::methodParameters("barrera"));
  for (const char* key : {"start_x", "start_y"}) {
    QVERIFY(project->parameters.set(key, 3.0));
  }
  QVERIFY(saveProject(*project, path("lost.toml")));
  trackBeginOf(path("lost.toml"));
  show(kCorrectedFrame);
  const Eigen::Vector3d truth = *shown().targets.at(0).truth;
  QVERIFY((estimate() - truth).norm() > 0.1);
  begin();
  drag(0, pixelOf(0, truth), pixelOf(0, truth));
  QVERIFY(shows(kCorrectedFrame));
  drag(1, pixelOf(1, truth), pixelOf(1, truth));
  const auto isTrackedBack = [](const PositionCorrection& one) {
    return one.trackedFrom == kCorrectedFrame;
  };
  QVERIFY(waitFor([&] { return std::ranges::count_if(corrections(), isTrackedBack) > 0; }));
  QCOMPARE(corrections().front().frame, std::int64_t{0});
  QVERIFY(messageText().contains(QStringLiteral("tracked backward to frame 1.")));
  // Until the session has tracked again from there: whoever looks at another frame meanwhile ends
  // it.
  QVERIFY(waitFor(
      [&] { return !samples().empty() && (samples().front().position - truth).norm() < 0.1; }));
  QVERIFY(areCorrected({kCorrectedFrame})); // what was found by tracking is not marked
  show(5);
  QVERIFY((estimate() - *shown().targets.at(0).truth).norm() < 0.03);
  QCOMPARE(history().count(), 2);
  action("actionUndo")->trigger(); // the second drag, with what was found from it
  QVERIFY(std::ranges::none_of(corrections(), isTrackedBack) ||
          corrections().back().clicks.size() == 1);
  action("actionUndo")->trigger();
  QVERIFY(corrections().empty());
  QVERIFY(areCorrected({}));
  // Redone and removed by its frame: what was found from it goes, too.
  action("actionRedo")->trigger();
  action("actionRedo")->trigger();
  QVERIFY(std::ranges::any_of(corrections(), isTrackedBack));
  QVERIFY(areCorrected({kCorrectedFrame}));
  show(kCorrectedFrame);
  action("actionRemoveCorrection")->trigger();
  QVERIFY(corrections().empty());
}

DEWPOINT_WINDOW_TEST(CorrectionTest)

} // namespace dewpoint::tests

#include "correction_test.moc"
