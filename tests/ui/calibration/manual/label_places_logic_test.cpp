// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/manual/label_places.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

const QRectF kArea(0.0, 0.0, 200.0, 100.0);
const QSizeF kLabel(40.0, 12.0);

TEST(LabelPlacer, ALabelLiesBesideItsPoint) {
  for (const QPointF outward : {QPointF(1, 0), QPointF(1, -1), QPointF(-3, 1), QPointF(0, 1)}) {
    LabelPlacer places(kArea);
    const QPointF point(100.0, 50.0);
    const auto box = places.reservePlace(point, kLabel, outward);
    ASSERT_TRUE(box);
    EXPECT_EQ(box->size(), kLabel);
    EXPECT_FALSE(box->adjusted(-5.0, -5.0, 5.0, 5.0).contains(point)); // its ring is seen
    EXPECT_GT(QPointF::dotProduct(box->center() - point, outward), 0.0);
  }
}

TEST(LabelPlacer, ALabelAvoidsLinesAndOtherLabels) {
  LabelPlacer places(kArea);
  const QPointF point(100.0, 50.0);
  places.avoid({QPointF(110.0, 0.0), QPointF(110.0, 100.0)}); // at the right of the point
  const auto first = places.reservePlace(point, kLabel, {1.0, 0.0});
  ASSERT_TRUE(first);
  EXPECT_LT(first->right(), 110.0);
  const auto second = places.reservePlace(point, kLabel, {1.0, 0.0});
  ASSERT_TRUE(second);
  EXPECT_FALSE(first->intersects(*second));
}

TEST(LabelPlacer, ANeededLabelCoversALineRatherThanItsPoint) {
  LabelPlacer places(kArea);
  const QPointF point(100.0, 50.0);
  for (double x = 5.0; x < 200.0; x += 10.0) {
    places.avoid({QPointF(x, 0.0), QPointF(x, 100.0)});
  }
  EXPECT_FALSE(places.reservePlace(point, kLabel, {0.0, -1.0}));
  const auto box = places.reservePlaceOverLines(point, kLabel, {0.0, -1.0});
  ASSERT_TRUE(box);
  EXPECT_LT(box->bottom(), point.y());
  EXPECT_FALSE(places.reservePlaceInDirection({40.0, 50.0}, kLabel,
                                              {0.0, -1.0})); // this one may be left out
}

TEST(LabelPlacer, NoLabelOfAPointOutOfSight) {
  LabelPlacer places(kArea);
  EXPECT_FALSE(places.reservePlace({201.0, 50.0}, kLabel, {1.0, 0.0}));
  const auto atTheEdge = places.reservePlace({199.0, 50.0}, kLabel, {1.0, 0.0});
  ASSERT_TRUE(atTheEdge);
  EXPECT_TRUE(kArea.contains(*atTheEdge));
}

TEST(LabelPlacer, ALabelThatMayBeLeftOutHasOnePlace) {
  LabelPlacer places(kArea);
  const QPointF point(100.0, 50.0);
  EXPECT_TRUE(places.reservePlaceInDirection(point, kLabel, {1.0, -1.0}));
  EXPECT_FALSE(places.reservePlaceInDirection(point, kLabel, {1.0, -1.0}));
  EXPECT_TRUE(places.reservePlace(point, kLabel, {1.0, -1.0})); // elsewhere
}

} // namespace
} // namespace dewpoint::tests
