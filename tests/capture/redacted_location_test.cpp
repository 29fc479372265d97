// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/open_live.h"
#include "core/capture/redacted_location.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace dewpoint::tests {
namespace {

TEST(ShownLocation, HidesPasswordsOfAddresses) {
  EXPECT_EQ(redactedLocation("rtsp://anna:s3cret@camera.lab:554/live?x=1"),
            "rtsp://anna:***@camera.lab:554/live?x=1");
  EXPECT_EQ(redactedLocation("http://anna:a@b:c@host/"), "http://anna:***@host/");
  EXPECT_EQ(redactedLocation("http://abcdef@host/video"), "http://***@host/video");
  EXPECT_EQ(redactedLocation("http://host/a@b"), "http://host/a@b");
  EXPECT_EQ(redactedLocation("srt://host:9000?mode=caller&passphrase=open-it&latency=20"),
            "srt://host:9000?mode=caller&passphrase=***&latency=20");
  EXPECT_EQ(redactedLocation("https://host/v?Token=abc&key=1#part"),
            "https://host/v?Token=***&key=***#part");
}

TEST(ShownLocation, HidesSecretsOfPipelines) {
  EXPECT_EQ(
      redactedLocation("gst:rtspsrc location=rtsp://u:p@host/a user-id=u user-pw=p ! appsink"),
      "gst:rtspsrc location=rtsp://u:***@host/a user-id=u user-pw=*** ! appsink");
  EXPECT_EQ(redactedLocation("gst:souphttpsrc location=http://h/ user-pw=\"two words\" ! appsink"),
            "gst:souphttpsrc location=http://h/ user-pw=\"***\" ! appsink");
  EXPECT_EQ(redactedLocation("gst:videotestsrc pattern=ball ! appsink"),
            "gst:videotestsrc pattern=ball ! appsink");
}

TEST(ShownLocation, LeavesDevicesAndPathsAlone) {
  for (const char* location :
       {"", "0", "/dev/video2", "/home/anna/token=1/a@b.mp4", "http://host/video"}) {
    EXPECT_EQ(redactedLocation(location), location);
  }
}

TEST(ShownLocation, NoNoticeHasThePassword) {
  LiveCamera camera;
  camera.name = "left";
  camera.location = "http://anna:s3cret@127.0.0.1:9/"; // nobody answers there
  const auto source = openLive({camera});
  ASSERT_TRUE(source);
  std::vector<Error> notices;
  for (int k = 0; k < 300 && notices.empty(); ++k) {
    ASSERT_TRUE((*source)->next());
    notices = (*source)->notices();
  }
  ASSERT_EQ(notices.size(), 1U);
  EXPECT_EQ(errorSentence(notices[0]).find("s3cret"), std::string::npos)
      << errorSentence(notices[0]);
  EXPECT_NE(errorSentence(notices[0]).find("anna:***@"), std::string::npos)
      << errorSentence(notices[0]);

  camera.location = "ftp://anna:s3cret@host/"; // of no kind that is known
  const auto refused = openLive({camera});
  ASSERT_FALSE(refused);
  EXPECT_EQ(errorSentence(refused.error()).find("s3cret"), std::string::npos);
}

} // namespace
} // namespace dewpoint::tests
