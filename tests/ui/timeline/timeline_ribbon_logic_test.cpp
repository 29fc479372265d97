// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/theme.h"
#include "ui/timeline/timeline_ribbon.h"

#include <QImage>
#include <QPainter>
#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

constexpr int kHeight = 24;
constexpr int kFrames = 50;

/// A ribbon of frames that all have this status, 10 pixels each.
QImage ribbonOf(TargetStatus status, float existence = 0.99F, bool dark = false) {
  TimelineModel model;
  model.targetNames = {QStringLiteral("ball")};
  std::vector<FrameRecord> records(kFrames);
  for (int k = 0; k < kFrames; ++k) {
    records[static_cast<std::size_t>(k)].frame = k;
    records[static_cast<std::size_t>(k)].targets.resize(1);
    records[static_cast<std::size_t>(k)].targets[0].status = status;
    records[static_cast<std::size_t>(k)].targets[0].existenceProbability = existence;
  }
  model.append(records, true);
  TimelineScale scale;
  scale.setExtent(0, kFrames - 1);
  scale.setPixelRange(0.0, 10.0 * kFrames);
  QImage picture(10 * kFrames, kHeight, QImage::Format_RGB32);
  QPainter painter(&picture);
  paintRibbon(painter, model, scale, QRectF(picture.rect()), 0, themePalette(dark));
  return picture;
}

/// Rows of pixels with anything but the ground.
int inkedRows(const QImage& picture, bool dark = false) {
  const QRgb ground = themePalette(dark).color(QPalette::Base).rgb();
  int rows = 0;
  for (int y = 0; y < picture.height(); ++y) {
    bool inked = false;
    for (int x = 0; x < picture.width(); ++x) {
      inked = inked || picture.pixel(x, y) != ground;
    }
    rows += inked ? 1 : 0;
  }
  return rows;
}

TEST(TimelineRibbon, HeldIsAThinLineAndTroubleFillsTheRow) {
  for (const bool dark : {false, true}) {
    EXPECT_LE(inkedRows(ribbonOf(TargetStatus::Held, 0.99F, dark), dark), 5);
    EXPECT_GE(inkedRows(ribbonOf(TargetStatus::Held, 0.99F, dark), dark), 3);
    for (const TargetStatus trouble :
         {TargetStatus::Ambiguous, TargetStatus::Searching, TargetStatus::Lost}) {
      EXPECT_EQ(inkedRows(ribbonOf(trouble, 0.99F, dark), dark), kHeight);
    }
    EXPECT_EQ(inkedRows(ribbonOf(TargetStatus::Gone, 0.99F, dark), dark), 0);
  }
}

TEST(TimelineRibbon, DoubtMakesTheLineThicker) {
  EXPECT_GT(inkedRows(ribbonOf(TargetStatus::Held, 0.3F)),
            inkedRows(ribbonOf(TargetStatus::Held, 0.99F)));
}

TEST(TimelineRibbon, TroublesDifferWithoutTheirColors) {
  const auto gray = [](TargetStatus status) {
    return ribbonOf(status).convertToFormat(QImage::Format_Grayscale8);
  };
  EXPECT_NE(gray(TargetStatus::Ambiguous), gray(TargetStatus::Searching));
  EXPECT_NE(gray(TargetStatus::Searching), gray(TargetStatus::Lost));
  // A pattern, not a plain area: several brightnesses in one row.
  const QImage picture = gray(TargetStatus::Searching);
  const uchar* middle = picture.constScanLine(kHeight / 2);
  EXPECT_NE(*std::min_element(middle, middle + picture.width()),
            *std::max_element(middle, middle + picture.width()));
}

} // namespace
} // namespace dewpoint::tests
