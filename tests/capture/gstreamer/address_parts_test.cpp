// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/address_parts.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(ParsedAddress, SplitsAnAddress) {
  const auto parts = parseAddress("HTTP://anna:p%40ss@camera.local:8080/video?size=2&x=a%20b#end");
  ASSERT_TRUE(parts);
  EXPECT_EQ(parts->scheme, "http");
  EXPECT_EQ(parts->user, "anna");
  EXPECT_EQ(parts->password, "p@ss");
  EXPECT_EQ(parts->host, "camera.local");
  EXPECT_EQ(parts->port, 8080);
  EXPECT_EQ(parts->path, "/video?size=2&x=a%20b#end");
  EXPECT_EQ(parts->option("size"), "2");
  EXPECT_EQ(parts->option("x"), "a b");
  EXPECT_FALSE(parts->option("y"));
  EXPECT_EQ(parts->withoutUser(), "http://camera.local:8080/video?size=2&x=a%20b#end");
}

TEST(ParsedAddress, TakesWhatIsThere) {
  const auto bare = parseAddress("udp://:5600");
  ASSERT_TRUE(bare);
  EXPECT_EQ(bare->host, "");
  EXPECT_EQ(bare->port, 5600);
  const auto v6 = parseAddress("rtsp://[::1]:554/a");
  ASSERT_TRUE(v6);
  EXPECT_EQ(v6->host, "::1");
  EXPECT_EQ(v6->withoutUser(), "rtsp://[::1]:554/a");
  const auto sign = parseAddress("rtsp://u:a@b:c@host/x"); // an @ in the password
  ASSERT_TRUE(sign);
  EXPECT_EQ(sign->host, "host");
  EXPECT_EQ(sign->password, "a@b:c");
  EXPECT_EQ(parseAddress("http://host")->port, std::nullopt);
}

TEST(ParsedAddress, RefusesWhatIsNone) {
  for (const char* text : {"", "video.mp4", "://host", "udp://host:0", "udp://host:99999",
                           "udp://host:a", "rtsp://[::1/a"}) {
    EXPECT_FALSE(parseAddress(text)) << text;
  }
}

} // namespace
} // namespace dewpoint::tests
