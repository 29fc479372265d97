// SPDX-License-Identifier: GPL-3.0-or-later
// What one sees at a glance: the first view, the color of a target, the cloud inside of it, lines
// of sight, names, and which view a new rig is seen in.
#include "tests/ui/scene3d/ball_snapshot.h"
#include "tests/ui/scene3d/scene_test.h"
#include "ui/scene3d/mean_path.h"
#include "ui/view3d/birds_eye_view.h"

#include <QApplication>
#include <QTest>
#include <QToolButton>

#include <cmath>
#include <functional>
#include <limits>

namespace dewpoint::tests {
namespace {

/// Pixels within `reach` of `around` (device pixels) that this is true for.
int countPixels(const QImage& picture, QPointF around, double reach,
                const std::function<bool(int x, int y)>& counts) {
  int count = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      count +=
          std::hypot(x + 0.5 - around.x(), y + 0.5 - around.y()) < reach && counts(x, y) ? 1 : 0;
    }
  }
  return count;
}

/// A quarter of the size, as another calibration would have it.
std::shared_ptr<TrackSnapshot> quartered(const TrackSnapshot& snapshot) {
  const auto small = std::make_shared<TrackSnapshot>(snapshot);
  CameraRig rig = *snapshot.rig;
  for (Camera& camera : rig) {
    camera.cameraFromWorld.translation() *= 0.25;
  }
  small->rig = std::make_shared<CameraRig>(rig);
  small->targets.clear();
  return small;
}

} // namespace

class SceneLookTest : public QObject {
  Q_OBJECT

private Q_SLOTS:
  void init() {
    view_ = std::make_unique<BirdsEyeView>();
    view_->resize(640, 480);
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
  }

  void cleanup() { view_.reset(); }

  void opensInPerspective() {
    view_->setSnapshot(ballSnapshot());
    view_->currentImage();
    QCOMPARE(view_->currentView(), Scene3d::View::Free);
    QVERIFY(view_->findChild<QToolButton*>(QStringLiteral("lookFreeButton"))->isChecked());
    // From obliquely above: z is up in the picture, and so is what is farther away.
    const Scene3d& scene = view_->scene();
    QVERIFY(scene.projectToImage({0, 0, 1}).y() > scene.projectToImage({0, 0, 0}).y() + 20.0);
    QVERIFY(scene.projectToImage({0, 1, 0}).y() > scene.projectToImage({0, 0, 0}).y() + 10.0);
    // All of the rig is in it.
    const auto rig = ballSnapshot()->rig; // the snapshot goes before the loop does
    for (const Camera& camera : *rig) {
      const Eigen::Vector2d place =
          scene.projectToImage(camera.center()) / view_->devicePixelRatioF();
      QVERIFY(std::abs(place.x()) < 320.0 && std::abs(place.y()) < 240.0);
    }
  }

  void fitFramesEverything() {
    view_->setSnapshot(ballSnapshot());
    const QImage before = view_->currentImage();
    QTest::keyClick(view_.get(), Qt::Key_Plus);
    QTest::keyClick(view_.get(), Qt::Key_Plus);
    QVERIFY(view_->currentImage() != before);
    QTest::mouseClick(view_->findChild<QToolButton*>(QStringLiteral("fitSceneButton")),
                      Qt::LeftButton);
    QCOMPARE(view_->currentImage(), before);
  }

  void theFitButtonStaysInANarrowView() {
    const auto* fit = view_->findChild<QToolButton*>(QStringLiteral("fitSceneButton"));
    const auto* side = view_->findChild<QToolButton*>(QStringLiteral("lookFromSideButton"));
    QCOMPARE(fit->y(), side->y()); // beside it, as long as there is room
    const QSize before = view_->size();
    view_->resize(side->geometry().right() + 12, before.height());
    QTRY_VERIFY(fit->geometry().bottom() < side->y());
    QVERIFY(view_->rect().contains(fit->geometry()));
    view_->resize(before);
    QTRY_COMPARE(fit->y(), side->y());
  }

  void aTargetHasTheColorThatWasLearned() {
    const auto snapshot = ballSnapshot();
    snapshot->targets[0].target.color = {200.0, 224.0, 0.4, 0.8, 0.3, 0.7}; // blue
    view_->setSnapshot(snapshot);
    const QImage picture = view_->currentImage();
    const auto isBlue = [&](int x, int y) {
      const QRgb pixel = picture.pixel(x, y);
      return qBlue(pixel) > qRed(pixel) + 60 && qBlue(pixel) > 100;
    };
    QVERIFY(countPixels(picture, at(picture, kBall), 60.0, isBlue) > 50);
    QCOMPARE(blob(picture, at(picture, kBall), 60.0).count, 0); // nothing of the palette's first
    QVERIFY(view_->scene().colorOf(0).z() > view_->scene().colorOf(0).x() + 0.2);
  }

  void aCloudIsSeenInsideTheBall() {
    const auto with = ballSnapshot();
    with->targets[0].target.radius = 0.25;
    with->targets[0].truth.reset();
    scatter(with->targets[0], 0.04);
    const auto without = std::make_shared<TrackSnapshot>(*with);
    without->targets[0].particles.resize(0, 3);
    without->targets[0].weights.resize(0);
    view_->setSnapshot(with);
    const QImage seen = view_->currentImage();
    view_->setSnapshot(without);
    const QImage bare = view_->currentImage();
    const double ratio = view_->devicePixelRatioF();
    const auto stands = [&](int x, int y) {
      return std::abs(qGray(seen.pixel(x, y)) - qGray(bare.pixel(x, y))) > 25;
    };
    // The cloud is 0.08 m about the middle; the ball reaches three times as far.
    const double reach = ratio * view_->scene().lengthInLogicalPixels(kBall, 0.1);
    QVERIFY(countPixels(seen, at(seen, kBall), reach, stands) > 100);
    QCOMPARE(view_->cloudInset().targetToEnlarge(*view_, -1), -1);
  }

  void aTinyCloudIsEnlargedInACorner() {
    const auto snapshot = ballSnapshot();
    scatter(snapshot->targets[0], 0.0004);
    view_->setSnapshot(snapshot);
    const QImage with = view_->currentImage();
    QCOMPARE(view_->cloudInset().targetToEnlarge(*view_, -1), 0);
    QCOMPARE(view_->cloudInset().targetToEnlarge(*view_, 0), 0);
    const double ratio = view_->devicePixelRatioF();
    const QPointF middle = SceneInset::usualArea(*view_).center() * ratio;
    // Particles of the target's color about the middle of the inset.
    QVERIFY(blob(with, middle, 45.0 * ratio).count > 100);
    // Nearer, it is seen in the picture itself.
    scatter(snapshot->targets[0], 0.08);
    const auto large = std::make_shared<TrackSnapshot>(*snapshot);
    view_->setSnapshot(large);
    view_->currentImage();
    QCOMPARE(view_->cloudInset().targetToEnlarge(*view_, -1), -1);
    view_->setSnapshot(TrackSnapshotPtr{});
    view_->currentImage();
    QCOMPARE(view_->cloudInset().targetToEnlarge(*view_, -1), -1);
  }

  void linesOfSightEndWhereACameraDoesNotSee() {
    const auto snapshot = ballSnapshot();
    view_->setSnapshot(snapshot);
    const QImage seen = view_->currentImage();
    view_->setRaysShown(false);
    const QImage none = view_->currentImage();
    const auto onRay = [&](const QImage& one, const QImage& other) {
      int different = 0;
      const Eigen::Vector3d camera = snapshot->rig->at(1).center();
      for (double share = 0.2; share < 0.6; share += 0.002) {
        const QPointF place = at(one, camera + share * (kBall - camera));
        const QPoint pixel(int(std::floor(place.x())), int(std::floor(place.y())));
        different += one.pixel(pixel) != other.pixel(pixel) ? 1 : 0;
      }
      return different;
    };
    const int whole = onRay(seen, none);
    QVERIFY(whole > 150); // of 200
    view_->setRaysShown(true);
    const auto hidden = std::make_shared<TrackSnapshot>(*snapshot);
    hidden->targets[0].cameraReports.resize(3);
    hidden->targets[0].cameraReports[1].status = CameraStatus::Hidden;
    view_->setSnapshot(hidden);
    const int broken = onRay(view_->currentImage(), none);
    QVERIFY(broken > 40 && broken < whole - 40);
    hidden->targets[0].cameraReports[1].status = CameraStatus::OutOfView;
    view_->setSnapshot(std::make_shared<TrackSnapshot>(*hidden));
    QVERIFY(onRay(view_->currentImage(), none) < 20);
  }

  void imagesLieOnThePyramidsWhenWanted() {
    const auto snapshot = ballSnapshot();
    const auto frames = std::make_shared<FrameSet>();
    for (const Camera& camera : *snapshot->rig) {
      const auto frame = std::make_shared<Frame>();
      frame->image = cv::Mat(camera.intrinsics.height, camera.intrinsics.width, CV_8UC3,
                             cv::Scalar(20, 200, 20));
      frames->frames.push_back(frame);
    }
    frames->frames.back() = nullptr; // this camera has none now
    snapshot->frames = frames;
    view_->setSnapshot(snapshot);
    const auto green = [](const QImage& picture) {
      return countPixels(picture, QPointF(picture.width() / 2.0, picture.height() / 2.0), 1e4,
                         [&](int x, int y) {
                           const QRgb pixel = picture.pixel(x, y);
                           return qGreen(pixel) > qRed(pixel) + 60;
                         });
    };
    const int ofTheAxes = green(view_->currentImage());
    view_->setImagesShown(true);
    QVERIFY(green(view_->currentImage()) > ofTheAxes + 200);
    view_->setImagesShown(false);
    QCOMPARE(green(view_->currentImage()), ofTheAxes);
  }

  void ofVeryManyTargetsTheRestArePoints() {
    const auto snapshot = ballSnapshot();
    const TargetSnapshot target = snapshot->targets[0];
    for (int k = 0; k < 1600; ++k) {
      TargetSnapshot more = target;
      auto& estimate = std::get<SphereEstimate>(more.estimate);
      estimate.mean += Eigen::Vector3d(0.02 * (k % 40) - 0.4, 0.02 * (k / 40) - 0.4, 0.3);
      snapshot->targets.push_back(more);
    }
    view_->setSnapshot(snapshot);
    const QImage all = view_->currentImage();
    // What was framed stays framed: only the points are missing now.
    const auto fewer = std::make_shared<TrackSnapshot>(*snapshot);
    fewer->targets.resize(100); // so many are drawn in full
    view_->setSnapshot(fewer);
    QVERIFY(view_->currentImage() != all);
    view_->setSnapshot(snapshot);
    QCOMPARE(view_->currentImage(), all);
  }

  void namesStandBesideTheCameras() {
    view_->setSnapshot(ballSnapshot());
    for (const auto look : {Scene3d::View::Free, Scene3d::View::Above, Scene3d::View::Front}) {
      view_->setView(look);
      view_->currentImage();
      const auto labels = view_->cameraLabels().labels(*view_);
      QCOMPARE(labels.size(), std::size_t{3});
      const ViewProjection projection(*view_, view_->scene());
      for (const CameraGlyph& glyph : view_->scene().cameraGlyphs()) {
        for (const Eigen::Vector3d& corner : glyph.corners) {
          for (double share = 0.0; share <= 1.0; share += 0.05) {
            const Eigen::Vector3d point = glyph.center + share * (corner - glyph.center);
            const QPointF edge = projection.toWidget(point);
            for (const auto& label : labels) {
              QVERIFY2(!label.area.contains(edge), qPrintable(label.text));
            }
          }
        }
      }
      for (const auto& label : labels) {
        QVERIFY(QRectF(view_->rect()).contains(label.area));
      }
    }
  }

  void aRigOfAnotherScaleIsFramedAlsoAfterZooming() {
    const auto large = ballSnapshot();
    const auto small = quartered(*large);
    view_->setSnapshot(small);
    view_->currentImage();
    const double fresh = view_->scene().metersPerPixel();
    view_->setSnapshot(large);
    view_->currentImage();
    QTest::keyClick(view_.get(), Qt::Key_Plus);
    view_->setSnapshot(small);
    view_->currentImage();
    QCOMPARE(view_->scene().metersPerPixel(), fresh);
  }

  void theSameRigKeepsTheView() {
    view_->setSnapshot(ballSnapshot());
    view_->currentImage();
    QTest::keyClick(view_.get(), Qt::Key_Plus);
    view_->currentImage();
    const double zoomed = view_->scene().metersPerPixel();
    view_->setSnapshot(ballSnapshot({-0.2, 0.1, 0.8})); // the same rig, in another object
    view_->currentImage();
    QCOMPARE(view_->scene().metersPerPixel(), zoomed);
    view_->setSnapshot(TrackSnapshotPtr{}); // the run begins again
    view_->currentImage();
    view_->setSnapshot(ballSnapshot());
    view_->currentImage();
    QCOMPARE(view_->scene().metersPerPixel(), zoomed);
  }

  void aRefinedCalibrationKeepsTheView() {
    const auto snapshot = ballSnapshot();
    view_->setSnapshot(snapshot);
    view_->currentImage();
    QTest::keyClick(view_.get(), Qt::Key_Plus);
    view_->currentImage();
    const double zoomed = view_->scene().metersPerPixel();
    const auto refined = std::make_shared<TrackSnapshot>(*snapshot);
    CameraRig rig = *snapshot->rig;
    for (Camera& camera : rig) {
      camera.cameraFromWorld.translation() *= 1.02;
    }
    refined->rig = std::make_shared<CameraRig>(rig);
    view_->setSnapshot(refined);
    view_->currentImage();
    QCOMPARE(view_->scene().metersPerPixel(), zoomed);
  }

  void anotherProjectIsSeenAfresh() {
    view_->setSnapshot(ballSnapshot());
    view_->currentImage();
    const double fresh = view_->scene().metersPerPixel();
    view_->lookFromFront();
    QTest::keyClick(view_.get(), Qt::Key_Plus);
    view_->resetForNewProject();
    view_->currentImage();
    QCOMPARE(view_->currentView(), Scene3d::View::Free);
    QCOMPARE(view_->scene().metersPerPixel(), fresh);
  }

  void theWayOfTheMeanIsKeptUntilItIsHeld() {
    MeanPath path;
    TrackSnapshot snapshot = *ballSnapshot();
    auto& sphere = std::get<SphereEstimate>(snapshot.targets[0].estimate);
    sphere.isValid = false;
    for (int i = 1; i <= 70; ++i) {
      snapshot.iterationCount = i;
      sphere.mean.x() = 0.01 * i;
      path.add(snapshot);
      path.add(snapshot); // shown once more, of the same iteration
    }
    QCOMPARE(path.positionsOf(0).size(), MeanPath::kMaxPositions);
    QCOMPARE(path.positionsOf(0).back().x(), 0.70);
    snapshot.iterationCount = 1; // restarted
    path.add(snapshot);
    QCOMPARE(path.positionsOf(0).size(), std::size_t{1});
    snapshot.iterationCount = 2;
    sphere.isValid = true;
    path.add(snapshot);
    QVERIFY(path.positionsOf(0).empty());
    QVERIFY(path.positionsOf(7).empty());
  }

  void theWayOfTheMeanIsDrawn() {
    const auto first = ballSnapshot();
    first->targets[0].tailPositions.clear();
    std::get<SphereEstimate>(first->targets[0].estimate).isValid = false;
    first->iterationCount = 1;
    const auto second = std::make_shared<TrackSnapshot>(*first);
    std::get<SphereEstimate>(first->targets[0].estimate).mean.x() -= 1.0;
    second->iterationCount = 2;
    view_->setSnapshot(second);
    const QImage without = view_->currentImage();
    view_->setSnapshot(first); // begins the path again
    view_->setSnapshot(second);
    const QImage with = view_->currentImage();
    const QPointF middle = at(with, kBall - Eigen::Vector3d(0.5, 0.0, 0.0));
    QVERIFY(countPixels(with, middle, 6.0 * view_->devicePixelRatioF(),
                        [&](int x, int y) { return with.pixel(x, y) != without.pixel(x, y); }) > 5);
  }

private:
  /// Device pixels from the upper left corner.
  QPointF at(const QImage& picture, const Eigen::Vector3d& point) const {
    const Eigen::Vector2d place = view_->scene().projectToImage(point);
    return {picture.width() / 2.0 + place.x(), picture.height() / 2.0 - place.y()};
  }

  std::unique_ptr<BirdsEyeView> view_;
};

DEWPOINT_NAMED_TEST(SceneLookTest, &runSceneTest<SceneLookTest>)

} // namespace dewpoint::tests

#include "scene_look_test.moc"
