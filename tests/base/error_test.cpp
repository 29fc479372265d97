// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/base/time.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(Error, SentenceNamesFileFieldAndDetail) {
  EXPECT_EQ(errorSentence({ErrorCode::FileMissing, "p.toml", "camera 1.video", "a.mkv"}),
            "p.toml: camera 1.video: the file does not exist (a.mkv)");
  EXPECT_EQ(errorSentence({ErrorCode::UnknownKey, "", "colour", ""}), "colour: unknown key");
  EXPECT_EQ(errorSentence({ErrorCode::ConnectionLost, "", "", ""}),
            "the camera stopped delivering images");
}

TEST(Time, SecondsAndBack) {
  EXPECT_EQ(timeStamp(1.5).count(), 1500000000);
  EXPECT_DOUBLE_EQ(seconds(TimeStamp(250000000)), 0.25);
  EXPECT_EQ(timeStamp(seconds(TimeStamp(33366700))), TimeStamp(33366700));
}

} // namespace
} // namespace dewpoint::tests
