// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/rgb_bins.h"
#include "ui/panels/histogram_view.h"

#include <QImage>
#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace dewpoint::tests {
namespace {

TEST(HistogramView, DrawsTheReferenceHollowAndTheCandidateFilled) {
  HistogramView view;
  view.resize(200, 60);
  const QImage empty = view.grab().toImage();
  ColorHistograms histograms{std::vector<double>(512, 0.0), std::vector<double>(512, 0.0)};
  histograms.reference[rgbBin(0, 0, 255)] = 1.0; // red, whose bin's middle is (240, 16, 16)
  histograms.candidate[rgbBin(0, 0, 255)] = 1.0;
  view.setHistograms(std::make_shared<const ColorHistograms>(histograms));
  const QImage drawn = view.grab().toImage();
  // One pair as wide as the view: the hollow bar from 20 to 100, the filled one from 100 to 180.
  EXPECT_EQ(drawn.pixelColor(140, 30), QColor(240, 16, 16));
  EXPECT_EQ(drawn.pixelColor(60, 30), empty.pixelColor(60, 30));
  EXPECT_NE(drawn.copy(15, 0, 90, 60), empty.copy(15, 0, 90, 60)); // its outline
  view.setHistograms(nullptr);
  EXPECT_EQ(view.grab().toImage(), empty);
}

} // namespace
} // namespace dewpoint::tests
