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
  EXPECT_TRUE(isTightCloud(9.0, false));
  EXPECT_FALSE(isTightCloud(11.0, false));
  EXPECT_TRUE(isTightCloud(11.0, true)); // no flicker
  EXPECT_FALSE(isTightCloud(15.0, true));
  EXPECT_FALSE(isTightCloud(0.0, true)); // there is none
}

TEST(InsetGeometry, AnInsetNeedsRoom) {
  EXPECT_EQ(insetSide(kView), 96.0);
  EXPECT_EQ(insetSide({0.0, 0.0, 300.0, 225.0}), 76.0);
  EXPECT_EQ(insetSide({0.0, 0.0, 1000.0, 800.0}), 144.0);
  EXPECT_FALSE(insetSide({0.0, 0.0, 200.0, 120.0}));
}

TEST(InsetGeometry, TheFactorRestsWhileTheCloudIsSeen) {
  EXPECT_EQ(insetFactor(2.0, 96.0, std::nullopt), 24); // fills a half
  EXPECT_EQ(insetFactor(1.2, 96.0, 24), 24);
  EXPECT_EQ(insetFactor(0.5, 96.0, 24), 96); // it would be a dot
  EXPECT_EQ(insetFactor(3.0, 96.0, 24), 16); // it would not fit
  EXPECT_EQ(insetFactor(1e-4, 96.0, 384), 384);
  EXPECT_FALSE(insetFactor(60.0, 96.0, std::nullopt));
}

TEST(InsetGeometry, ItLiesInTheNearestCornerWithRoomToTheTarget) {
  const InsetPlace place = insetPlace(kView, 96.0, {50.0, 60.0}, {}, std::nullopt);
  EXPECT_EQ(place.corner, 2);
  EXPECT_EQ(place.square, QRectF(8.0, 196.0, 96.0, 96.0));
  // What is there already keeps its corner.
  const QRectF taken(10.0, 270.0, 40.0, 20.0);
  EXPECT_EQ(insetPlace(kView, 96.0, {50.0, 60.0}, {taken}, std::nullopt).corner, 1);
  // In a small view there is no such room anywhere.
  const QRectF small(0.0, 0.0, 210.0, 200.0);
  EXPECT_EQ(insetPlace(small, 68.0, {90.0, 90.0}, {}, std::nullopt).corner, 3);
}

TEST(InsetGeometry, ItMovesOnlyWhenTheTargetComesNear) {
  EXPECT_EQ(insetPlace(kView, 96.0, {200.0, 150.0}, {}, 1).corner, 1);
  EXPECT_EQ(insetPlace(kView, 96.0, {285.0, 60.0}, {}, 1).corner, 3);
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
        const QRectF place = loupePlace({x, y}, room);
        ASSERT_FALSE(place.isEmpty());
        EXPECT_TRUE(QRectF(QPointF(), room).contains(place)) << x << " " << y;
        EXPECT_FALSE(place.adjusted(-8.0, -8.0, 8.0, 8.0).contains(x, y)) << x << " " << y;
      }
    }
  }
  EXPECT_TRUE(loupePlace({10.0, 10.0}, {100.0, 100.0}).isEmpty());
}

double luminance(const QColor& color) {
  return 0.2126 * color.redF() + 0.7152 * color.greenF() + 0.0722 * color.blueF();
}

TEST(ParticleRamp, HeavierParticlesAreBrighter) {
  for (const ParticleRamp& ramp :
       {ParticleRamp::heat(), ParticleRamp::tinted("#ff8640"), ParticleRamp::tinted("#56b4e9")}) {
    for (int k = 0; k < 20; ++k) {
      EXPECT_LT(luminance(ramp.at(k / 20.0)), luminance(ramp.at((k + 1) / 20.0))) << k;
    }
    EXPECT_EQ(ramp.at(-1.0), ramp.at(0.0));
    EXPECT_EQ(ramp.at(2.0), ramp.at(1.0));
  }
  EXPECT_EQ(ParticleRamp::tinted("#ff8640").at(0.5), QColor("#ff8640"));
}

} // namespace
} // namespace dewpoint::tests
