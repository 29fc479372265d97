// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/box_track_file.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

BoxTrack twoFrames() {
  BoxTrack track;
  track.header = {{"method", "sugandi"}};
  BoxEstimate estimate;
  estimate.box = {10.5, 20.0, 30.0, 40.0};
  estimate.similarity = 0.75;
  estimate.spreadPixels = 2.0;
  estimate.effectiveSampleSize = 55.0;
  track.samples.push_back({0.0, 0, 1, estimate});
  estimate.isVisible = false;
  track.samples.push_back({0.04, 1, 1, estimate});
  return track;
}

TEST(BoxTrackFile, CsvHasBoxAndCenter) {
  EXPECT_EQ(boxCsv(twoFrames()),
            "# dewpoint boxes\n# units: time s, box px from the image's upper left corner\n"
            "# method: sugandi\n"
            "time_s,frame,target,x_px,y_px,width_px,height_px,center_x_px,center_y_px,similarity,"
            "spread_px,ess,visible\n"
            "0,0,1,10.5,20,30,40,25.5,40,0.75,2,55,1\n"
            "0.04,1,1,10.5,20,30,40,25.5,40,0.75,2,55,0\n");
}

TEST(BoxTrackFile, WithoutNotesTheFirstLineHasTheColumnNames) {
  const std::string csv = boxCsv(twoFrames(), CsvNotes::LeftOut);
  EXPECT_TRUE(csv.starts_with("time_s,frame,target,")) << csv;
  EXPECT_TRUE(boxCsv(twoFrames()).ends_with(csv));
}

TEST(BoxTrackFile, MotCountsFromOneAndLeavesOutWhatIsHidden) {
  // The MOT challenge: frames, identities and corners from 1; 3D columns -1 where there are none.
  EXPECT_EQ(boxMotText(twoFrames()), "1,1,11.50,21.00,30.00,40.00,0.7500,-1,-1,-1\n");
}

} // namespace
} // namespace dewpoint::tests
