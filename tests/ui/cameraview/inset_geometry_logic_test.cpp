// SPDX-License-Identifier: GPL-3.0-or-later
// Where loupe and inset lie in a camera view, how much they enlarge, and the colors of particles.
#include "ui/cameraview/inset_geometry.h"
#include "ui/cameraview/loupe.h"
#include "ui/cameraview/particle_ramp.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

const QRectF kView(0.0, 0.0, 400.0, 300.0);

TEST(InsetGeometry, ACloudIsTightBelowTenUnits) {
  EXPECT_TRUE(isTightCloud(9.0));
  EXPECT_FALSE(isTightCloud(11.0));
}

TEST(InsetGeometry, AnInsetNeedsRoom) {
  EXPECT_EQ(insetSideLength(kView), 96.0);
  EXPECT_EQ(insetSideLength({0.0, 0.0, 300.0, 225.0}), 76.0);
  EXPECT_EQ(insetSideLength({0.0, 0.0, 1000.0, 800.0}), 144.0);
  EXPECT_FALSE(insetSideLength({0.0, 0.0, 200.0, 120.0}));
}

TEST(InsetGeometry, TheCloudFillsAFifthToThreeFifths) {
  EXPECT_EQ(insetMagnification(2.0, 96.0), 27);
  EXPECT_EQ(insetMagnification(1.0, 96.0), 27);
  EXPECT_EQ(insetMagnification(0.5, 96.0), 81);
  EXPECT_EQ(insetMagnification(1e-4, 96.0), 243);
  EXPECT_FALSE(insetMagnification(60.0, 96.0)); // not even with pixels as they are
}

TEST(InsetGeometry, ItLiesInTheFirstCornerWithRoomToTheTarget) {
  const QRectF lowerLeft(8.0, 196.0, 96.0, 96.0);
  const QRectF lowerRight(296.0, 196.0, 96.0, 96.0);
  EXPECT_EQ(insetRect(kView, 96.0, {50.0, 60.0}, {}), lowerLeft);
  EXPECT_EQ(insetRect(kView, 96.0, {350.0, 250.0}, {}), lowerLeft);
  EXPECT_EQ(insetRect(kView, 96.0, {120.0, 200.0}, {}), lowerRight);
  // What is there already keeps its corner.
  EXPECT_EQ(insetRect(kView, 96.0, {50.0, 60.0}, {{10.0, 270.0, 40.0, 20.0}}), lowerRight);
  // In a small view there is no such room anywhere.
  const QRectF small(0.0, 0.0, 210.0, 200.0);
  EXPECT_EQ(insetRect(small, 68.0, {90.0, 90.0}, {}), QRectF(134.0, 124.0, 68.0, 68.0));
}

TEST(InsetGeometry, TheScaleBarHasARoundLength) {
  EXPECT_DOUBLE_EQ(scaleBarLength(8.0, 40.0), 5.0);
  EXPECT_DOUBLE_EQ(scaleBarLength(12.0, 40.0), 2.0);
  EXPECT_DOUBLE_EQ(scaleBarLength(384.0, 40.0), 0.1);
  EXPECT_DOUBLE_EQ(scaleBarLength(1.0, 40.0), 20.0);
}

TEST(Loupe, IsNeverUnderThePointerNorCut) {
  for (const QSizeF room : {QSizeF(400.0, 300.0), QSizeF(180.0, 90.0), QSizeF(130.0, 400.0)}) {
    for (double x = 0.0; x <= room.width(); x += 7.0) {
      for (double y = 0.0; y <= room.height(); y += 7.0) {
        const QRectF place = loupeRect({x, y}, room);
        ASSERT_FALSE(place.isEmpty());
        EXPECT_TRUE(QRectF(QPointF(), room).contains(place)) << x << " " << y;
        EXPECT_FALSE(place.adjusted(-8.0, -8.0, 8.0, 8.0).contains(x, y)) << x << " " << y;
      }
    }
  }
  EXPECT_TRUE(loupeRect({10.0, 10.0}, {100.0, 100.0}).isEmpty());
}

double luminance(const QColor& color) {
  return 0.2126 * color.redF() + 0.7152 * color.greenF() + 0.0722 * color.blueF();
}

TEST(ParticleRamp, HeavierParticlesAreBrighter) {
  for (const ParticleRamp& ramp : {ParticleRamp::heatRamp(), ParticleRamp::tintedRamp("#ff8640"),
                                   ParticleRamp::tintedRamp("#56b4e9")}) {
    for (int k = 0; k < 20; ++k) {
      EXPECT_LT(luminance(ramp.colorAt(k / 20.0)), luminance(ramp.colorAt((k + 1) / 20.0))) << k;
    }
    EXPECT_EQ(ramp.colorAt(-1.0), ramp.colorAt(0.0));
    EXPECT_EQ(ramp.colorAt(2.0), ramp.colorAt(1.0));
  }
  EXPECT_EQ(ParticleRamp::tintedRamp("#ff8640").colorAt(0.5), QColor("#ff8640"));
}

} // namespace
} // namespace dewpoint::tests
