// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/live_frame_filler.h"

#include <QTest>

namespace dewpoint::tests {

class LateImagesTest : public QObject {
  Q_OBJECT
private Q_SLOTS:
  void aLateCameraShowsItsLastImage();
  void aSilentCameraIsMissing();
  void recordingsAndThePastAreShownAsTheyAre();
};

namespace {

/// A live moment of two cameras; where `present` is false, a camera has no image.
std::shared_ptr<TrackSnapshot> moment(double time, bool first, bool second) {
  auto set = std::make_shared<FrameSet>();
  set->time = timeStamp(time);
  for (const bool present : {first, second}) {
    set->frames.push_back(present
                              ? std::make_shared<const Frame>(Frame{
                                    0, set->time, cv::Mat(2, 2, CV_8UC3, cv::Scalar(time, 0, 0))})
                              : nullptr);
  }
  auto snapshot = std::make_shared<TrackSnapshot>();
  snapshot->frames = set;
  return snapshot;
}

FramePtr frameOf(const TrackSnapshotPtr& snapshot, std::size_t camera) {
  return snapshot->frames->frames[camera];
}

} // namespace

void LateImagesTest::aLateCameraShowsItsLastImage() {
  LiveFrameFiller late;
  const auto both = moment(1.0, true, true);
  QCOMPARE(late.filled(both).get(), both.get()); // nothing to fill: no copy
  auto one = moment(1.05, true, false);
  one->masks = {cv::Mat(2, 2, CV_8UC1), cv::Mat()};
  const auto seen = late.filled(one);
  QCOMPARE(frameOf(seen, 0), frameOf(one, 0));
  QCOMPARE(frameOf(seen, 1), frameOf(both, 1));
  QVERIFY(frameOf(one, 1) == nullptr); // what was published stays as it was
  QCOMPARE(seen->masks.size(), std::size_t{2});
}

void LateImagesTest::aSilentCameraIsMissing() {
  LiveFrameFiller late;
  late.filled(moment(1.0, true, true));
  QVERIFY(frameOf(late.filled(moment(1.0 + 0.9 * LiveFrameFiller::kYoung, true, false)), 1) !=
          nullptr);
  QVERIFY(frameOf(late.filled(moment(1.0 + LiveFrameFiller::kYoung, true, false)), 1) == nullptr);
  QVERIFY(frameOf(late.filled(moment(0.5, true, false)), 1) == nullptr); // begun anew
}

void LateImagesTest::recordingsAndThePastAreShownAsTheyAre() {
  LiveFrameFiller late;
  late.filled(moment(1.0, true, true));
  auto recorded = moment(1.05, true, false);
  recorded->frameCount = 100;
  QVERIFY(frameOf(late.filled(recorded), 1) == nullptr);
  auto past = moment(1.05, true, false);
  past->past = true;
  QVERIFY(frameOf(late.filled(past), 1) == nullptr);
  QVERIFY(late.filled(nullptr) == nullptr);
}

} // namespace dewpoint::tests

QTEST_GUILESS_MAIN(dewpoint::tests::LateImagesTest)
#include "late_images_test.moc"
