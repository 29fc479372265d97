// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/image_zoom.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

constexpr ZoomSizes kSizes{{1280, 720}, {400, 300}, 1.0};

void expectNear(const QPointF& point, const QPointF& wanted, double reach) {
  EXPECT_NEAR(point.x(), wanted.x(), reach);
  EXPECT_NEAR(point.y(), wanted.y(), reach);
}

TEST(ImageZoom, IsFittedAtFirst) {
  const ImageZoom zoom;
  EXPECT_TRUE(zoom.isFitted(kSizes));
  const ImagePlacement all = zoom.placement(kSizes);
  EXPECT_DOUBLE_EQ(all.scale, 400.0 / 1280.0);
  EXPECT_EQ(all.topLeft, QPointF(0.0, 38.0)); // (300 - 225) / 2, at a whole pixel
  EXPECT_EQ(zoom.visiblePart(kSizes), QRect(0, 0, 1280, 720));
  EXPECT_EQ(zoom.visiblePartSize(kSizes), QSize(400, 225));
}

TEST(ImageZoom, ThePixelUnderThePointerStays) {
  ImageZoom zoom;
  const QPointF pointer(230.0, 140.0);
  const QPointF pixel = zoom.placement(kSizes).pixelAt(pointer);
  for (int step = 0; step < 12; ++step) {
    zoom.zoomBy(ImageZoom::kZoomStep, pointer, kSizes);
    // Half a device pixel: the corner lies at a whole one.
    expectNear(zoom.placement(kSizes).positionOf(pixel), pointer, 0.51);
  }
  EXPECT_NEAR(zoom.placement(kSizes).scale, 20.0, 1e-9); // 64 times the fit
}

TEST(ImageZoom, StepsBackLeadToTheFit) {
  ImageZoom zoom;
  for (int step = 0; step < 5; ++step) {
    zoom.zoomBy(ImageZoom::kZoomStep, {10.0, 60.0}, kSizes);
  }
  EXPECT_FALSE(zoom.isFitted(kSizes));
  for (int step = 0; step < 5; ++step) {
    zoom.zoomBy(1.0 / ImageZoom::kZoomStep, {300.0, 200.0}, kSizes);
  }
  EXPECT_TRUE(zoom.isFitted(kSizes));
  EXPECT_EQ(zoom.placement(kSizes).topLeft, QPointF(0.0, 38.0));
  zoom.zoomBy(0.1, {0.0, 0.0}, kSizes);
  EXPECT_TRUE(zoom.isFitted(kSizes)); // never smaller
}

TEST(ImageZoom, PixelsAreNotLargerThanTheMost) {
  ImageZoom zoom;
  zoom.zoomBy(1e6, {200.0, 150.0}, kSizes);
  EXPECT_DOUBLE_EQ(zoom.placement(kSizes).scale, ImageZoom::kMaxScale);
  const QSize size =
      zoom.visiblePartSize(kSizes); // what is seen, and at most a pixel more on each side
  EXPECT_LE(size.width(), 400 + 64);
  EXPECT_LE(size.height(), 300 + 64);
  const ZoomSizes tiny{{4, 3}, {400, 300}, 1.0};
  ImageZoom larger; // 100 widget units each, where it fits
  larger.zoomBy(2.0, {0.0, 0.0}, tiny);
  EXPECT_TRUE(larger.isFitted(tiny));
}

TEST(ImageZoom, NoMoreIsLeftEmptyThanByTheFit) {
  ImageZoom zoom;
  zoom.panBy({50.0, 50.0}, kSizes);
  EXPECT_EQ(zoom.placement(kSizes).topLeft, QPointF(0.0, 38.0)); // a fitted one stays
  zoom.zoomBy(8.0, {200.0, 150.0}, kSizes);                      // 3200 x 1800
  zoom.panBy({1e5, 1e5}, kSizes);
  expectNear(zoom.placement(kSizes).topLeft, {0.0, 37.5}, 0.51);
  EXPECT_EQ(zoom.visiblePart(kSizes).topLeft(), QPoint(0, 0));
  zoom.panBy({-1e5, -1e5}, kSizes);
  expectNear(zoom.placement(kSizes).topLeft, {400.0 - 3200.0, 300.0 - 1800.0 - 37.5}, 0.51);
  EXPECT_EQ(zoom.visiblePart(kSizes).bottomRight(), QPoint(1279, 719));
  const QPointF before = zoom.placement(kSizes).topLeft;
  zoom.panBy({100.0, 20.0}, kSizes);
  expectNear(zoom.placement(kSizes).topLeft - before, {100.0, 20.0}, 1e-9);
}

TEST(ImageZoom, ThePartIsWhatIsSeen) {
  ImageZoom zoom;
  zoom.zoomBy(32.0, {200.0, 150.0}, kSizes); // ten widget units per pixel: 40 x 30 pixels are seen
  const ImagePlacement placement = zoom.placement(kSizes);
  const QRect part = zoom.visiblePart(kSizes);
  const QRectF seen(placement.positionOf(part.topLeft()) - QPointF(5.0, 5.0),
                    QSizeF(part.size()) * placement.scale);
  EXPECT_TRUE(seen.contains(QRectF(0.0, 0.0, 400.0, 300.0)));
  EXPECT_LE(part.width(), 46);
  EXPECT_LE(part.height(), 36);
  EXPECT_EQ(zoom.visiblePartSize(kSizes), part.size() * 10);
  const ZoomSizes sharp{kSizes.imageSize, kSizes.viewSize, 2.0};
  EXPECT_EQ(zoom.visiblePartSize(sharp), zoom.visiblePart(sharp).size() * 20);
}

TEST(ImageZoom, TheCenterStaysInAnotherView) {
  ImageZoom zoom;
  zoom.zoomBy(16.0, {130.0, 120.0}, kSizes);
  const QPointF middle = zoom.placement(kSizes).pixelAt({200.0, 150.0});
  const ZoomSizes wide{kSizes.imageSize, {900, 500}, 1.0};
  EXPECT_DOUBLE_EQ(zoom.placement(wide).scale, zoom.placement(kSizes).scale);
  expectNear(zoom.placement(wide).pixelAt({450.0, 250.0}), middle, 0.2);
}

TEST(ImageZoom, APixelIsRevealedByAsLittleAsIsNeeded) {
  ImageZoom zoom;
  zoom.zoomBy(16.0, {200.0, 150.0}, kSizes);
  const ImagePlacement before = zoom.placement(kSizes);
  zoom.reveal(before.pixelAt({210.0, 140.0}), kSizes);
  EXPECT_EQ(zoom.placement(kSizes).topLeft, before.topLeft); // it is seen already
  const QPointF beside = before.pixelAt({460.0, 150.0});
  zoom.reveal(beside, kSizes);
  expectNear(zoom.placement(kSizes).positionOf(beside), {376.0, 150.0}, 1.0);
}

} // namespace
} // namespace dewpoint::tests
