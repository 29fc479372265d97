// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/selection/selection.h"
#include "ui/style/target_colors.h"
#include "ui/style/theme.h"
#include "ui/timeline/timeline_painter.h"

#include <QImage>
#include <QPainter>
#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

constexpr QSize kTimelineSize(400, 120);

TEST(TimelineColors, BesideEachNameIsTheColorOfTheTarget) {
  TimelineModel model;
  model.targetNames = {QStringLiteral("green ball"), QStringLiteral("box")};
  model.colorSources = {{.learnedColors = ColorRange{108.0, 132.0, 0.4, 0.6, 0.4, 0.6}}, {}};
  TimelineScale scale;
  scale.setExtent(0, 49);
  scale.setPixelRange(100.0, 300.0);
  const TimelineRows rows(kTimelineSize, 2, 0, 16.0, 100.0, false);
  for (const bool dark : {false, true}) {
    const QPalette palette = themePalette(dark);
    QImage picture(kTimelineSize, QImage::Format_RGB32);
    picture.fill(palette.color(QPalette::Window));
    QPainter painter(&picture);
    paintTimeline(painter, model, scale, rows, Selection(), -1, palette);
    painter.end();
    const auto colors = targetColors(model.colorSources, displayBackgroundOf(palette));
    for (int k = 0; k < 2; ++k) {
      const QPoint chip(3, qRound(rows.ribbonArea(k).center().y()));
      EXPECT_EQ(picture.pixelColor(chip).rgb(), colors[static_cast<std::size_t>(k)].rgb()) << k;
    }
    EXPECT_GT(colors[0].green(), colors[0].red()); // as it was learned
  }
}

TEST(TimelineFooter, SaysOnlyWhatIsTrackedAgain) {
  TimelineModel model;
  model.targetNames = {QStringLiteral("ball")};
  model.history = {.firstFrame = 0,
                   .lastFrame = 49,
                   .newestTrackedFrame = 33,
                   .memoryBytes = 62U << 20U,
                   .maxMemoryBytes = 512U << 20U};
  TimelineScale scale;
  scale.setExtent(0, 49);
  scale.setPixelRange(100.0, 300.0);
  const QPalette palette = themePalette(false);
  const auto hasText = [&] {
    const TimelineRows rows(kTimelineSize, 1, 0, 16.0, 100.0, model.rerun.has_value());
    EXPECT_EQ(rows.footerArea.height() > 0.0, model.rerun.has_value());
    QImage picture(kTimelineSize, QImage::Format_RGB32);
    picture.fill(palette.color(QPalette::Window));
    const QImage empty = picture;
    QPainter painter(&picture);
    paintTimeline(painter, model, scale, rows, Selection(), -1, palette);
    painter.end();
    const QRect below(0, kTimelineSize.height() - 20, kTimelineSize.width(), 20);
    return picture.copy(below) != empty.copy(below);
  };
  EXPECT_FALSE(hasText());
  model.rerun = RerunState{19, 49};
  EXPECT_TRUE(hasText());
}

} // namespace
} // namespace dewpoint::tests
