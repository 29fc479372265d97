// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timeline/timeline_scale.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

/// 100 frames over 200 pixels, from pixel 10 on.
TimelineScale hundredFrames() {
  TimelineScale scale;
  scale.setPixelRange(10.0, 200.0);
  scale.setExtent(0, 99);
  return scale;
}

TEST(TimelineScale, FramesAndPixelsBelongTogether) {
  const TimelineScale scale = hundredFrames();
  EXPECT_DOUBLE_EQ(scale.pixelsPerFrame(), 2.0);
  EXPECT_DOUBLE_EQ(scale.xOf(0), 10.0);
  EXPECT_DOUBLE_EQ(scale.xOf(100), 210.0); // one past the last
  for (const qint64 frame : {0, 1, 57, 99}) {
    EXPECT_EQ(scale.frameAt(scale.xOf(double(frame)) + 1.0), frame); // in its middle
  }
  EXPECT_EQ(scale.frameAt(-50.0), 0);
  EXPECT_EQ(scale.frameAt(1000.0), 99);
}

TEST(TimelineScale, ALongerRunIsFollowedWhileAllIsShown) {
  TimelineScale scale = hundredFrames();
  scale.setExtent(0, 199);
  EXPECT_TRUE(scale.showsWholeRun());
  EXPECT_DOUBLE_EQ(scale.shownEnd(), 200.0);
  scale.showFrames(50, 99);
  scale.setExtent(0, 399); // what was chosen stays
  EXPECT_DOUBLE_EQ(scale.shownBegin(), 50.0);
  EXPECT_DOUBLE_EQ(scale.shownEnd(), 100.0);
  EXPECT_FALSE(scale.showsWholeRun());
}

TEST(TimelineScale, ZoomKeepsWhatIsUnderThePointer) {
  TimelineScale scale = hundredFrames();
  const double x = 110.0; // frame 50
  scale.zoom(2.0, x);
  EXPECT_DOUBLE_EQ(scale.shownEnd() - scale.shownBegin(), 50.0);
  EXPECT_EQ(scale.frameAt(x + 1.0), 50);
  scale.zoom(1e6, x); // at the closest ten frames
  EXPECT_DOUBLE_EQ(scale.shownEnd() - scale.shownBegin(), 10.0);
  scale.zoom(1e-6, x);
  EXPECT_TRUE(scale.showsWholeRun());
  EXPECT_DOUBLE_EQ(scale.shownBegin(), 0.0);
}

TEST(TimelineScale, ScrollingEndsAtTheEnds) {
  TimelineScale scale = hundredFrames();
  scale.showFrames(20, 39);
  scale.scroll(-100.0);
  EXPECT_DOUBLE_EQ(scale.shownBegin(), 0.0);
  scale.scroll(1000.0);
  EXPECT_DOUBLE_EQ(scale.shownEnd(), 100.0);
  EXPECT_DOUBLE_EQ(scale.shownBegin(), 80.0);
}

TEST(TimelineScale, RevealScrollsAsLittleAsNeeded) {
  TimelineScale scale = hundredFrames();
  scale.showFrames(40, 59);
  scale.reveal(50);
  EXPECT_DOUBLE_EQ(scale.shownBegin(), 40.0); // it is there
  scale.reveal(70);
  EXPECT_DOUBLE_EQ(scale.shownEnd(), 72.0); // with a twentieth of the 20 frames beside it
  scale.reveal(10);
  EXPECT_DOUBLE_EQ(scale.shownBegin(), 9.0);
  scale.reveal(0);
  EXPECT_DOUBLE_EQ(scale.shownBegin(), 0.0);
}

TEST(TimelineScale, FewFramesAreNotCutFurther) {
  TimelineScale scale;
  scale.setPixelRange(0.0, 100.0);
  scale.setExtent(5, 7);
  scale.zoom(4.0, 50.0);
  EXPECT_TRUE(scale.showsWholeRun());
  EXPECT_DOUBLE_EQ(scale.shownBegin(), 5.0);
  scale.setExtent(3, 1); // nothing: one frame
  EXPECT_EQ(scale.lastFrame(), 3);
}

} // namespace
} // namespace dewpoint::tests
