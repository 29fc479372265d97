// SPDX-License-Identifier: GPL-3.0-or-later
// The inset that enlarges a tiny cloud, and targets that are hidden, in the bird's-eye view.
#include "tests/ui/scene3d/ball_snapshot.h"
#include "tests/ui/scene3d/scene_test.h"
#include "ui/view3d/birds_eye_view.h"

#include <QApplication>
#include <QTest>

#include <memory>

namespace dewpoint::tests {

class SceneInsetTest : public QObject {
  Q_OBJECT

private Q_SLOTS:
  void init() {
    view_ = std::make_unique<BirdsEyeView>();
    view_->resize(640, 480);
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
  }
  void cleanup() { view_.reset(); }

  void namesAvoidTheInset() {
    const auto snapshot = ballSnapshot();
    scatter(snapshot->targets[0], 0.0004);
    view_->setSnapshot(snapshot);
    for (const auto look : {Scene3d::View::Free, Scene3d::View::Above, Scene3d::View::Front}) {
      view_->setView(look);
      view_->currentImage();
      const QRectF inset = view_->cloudInset().shownArea(*view_, -1);
      QVERIFY(QRectF(view_->rect()).contains(inset));
      const ViewProjection projection(*view_, view_->scene());
      for (const CameraGlyph& glyph : view_->scene().cameraGlyphs()) {
        if (inset.contains(projection.toWidget(glyph.center))) {
          continue; // both corners of the view would cover a camera
        }
        for (const auto& label : view_->cameraLabels().labels(*view_, inset)) {
          QVERIFY2(label.text != QString::fromStdString(glyph.name) ||
                       !label.area.intersects(inset),
                   glyph.name.c_str());
        }
      }
    }
  }

  void aHiddenTargetIsNotDrawn() {
    const auto hidden = ballSnapshot();
    hidden->targets[0].target.isShown = false;
    scatter(hidden->targets[0], 0.0004); // which would have an inset
    const auto none = std::make_shared<TrackSnapshot>(*hidden);
    none->targets.clear();
    view_->setSnapshot(hidden); // and it is framed like the others
    view_->currentImage();
    QCOMPARE(view_->cloudInset().targetToEnlarge(*view_, -1), -1);
    const QImage seen = view_->currentImage();
    view_->setSnapshot(none);
    QCOMPARE(view_->currentImage(), seen);
  }

private:
  std::unique_ptr<BirdsEyeView> view_;
};

DEWPOINT_NAMED_TEST(SceneInsetTest, &runSceneTest<SceneInsetTest>)

} // namespace dewpoint::tests

#include "scene_inset_test.moc"
