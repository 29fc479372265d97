// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/format/osc_bundle.h"
#include "core/broadcast/format/stream_formats.h"
#include "tests/broadcast/example_frame.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace dewpoint::tests {
namespace {

using broadcast::FrameMessage;
using Lines = std::vector<std::string>;

TEST(StreamFormats, EachHasItsOwnIdAndSaysWhatItContains) {
  std::set<std::string_view> ids;
  for (const auto& format : broadcast::streamFormats()) {
    EXPECT_TRUE(ids.insert(format.id).second) << format.id;
    EXPECT_FALSE(format.title.empty());
    EXPECT_FALSE(format.frameDescription.empty());
    EXPECT_FALSE(format.encode(exampleFrame()).empty());
  }
  EXPECT_EQ(broadcast::jsonLinesFormat().id, "json");
  EXPECT_EQ(broadcast::csvRowsFormat().id, "csv");
  EXPECT_EQ(broadcast::oscMessagesFormat().id, "osc");
  EXPECT_EQ(broadcast::tuioCursorsFormat().id, "tuio");
}

TEST(StreamFormats, JsonIsOneLineForAFrame) {
  EXPECT_EQ(broadcast::jsonLinesFormat().preamble(exampleRig()),
            R"({"type":"rig","axes":"z-up","unit":"m","volume":[[0,-2,0],[2,2,1]],"cameras":[)"
            R"({"name":"left","position":[1,2,3],"direction":[0,0,-1]},)"
            R"({"name":"the \"right\", one","position":[-1.5,0,2],"direction":[1,0,0]}]})"
            "\n");
  EXPECT_EQ(broadcast::jsonLinesFormat().encode(exampleFrame()),
            Lines{R"({"type":"frame","frame":12,"sequence":7,"time":0.4,"targets":[)"
                  R"({"id":1,"name":"pink ball","state":"held","position":[0.5,1,0.25],)"
                  R"("velocity":[1,0,-0.5],"covariance":[4e-06,1e-06,0,9e-06,2e-06,1e-06],)"
                  R"("existence":0.75,"cameras":["left","the \"right\", one"]},)"
                  R"({"id":2,"name":"blue","state":"lost","position":null,"velocity":null,)"
                  R"("covariance":null,"existence":0.125,"cameras":[]}]})"
                  "\n"});
}

TEST(StreamFormats, JsonStaysValidWhateverTheNamesAndNumbers) {
  FrameMessage frame = exampleFrame();
  frame.targets[0].name = "line\nend \xff";
  frame.targets[0].existenceProbability = std::numeric_limits<double>::quiet_NaN();
  const std::string line = broadcast::jsonLinesFormat().encode(frame).front();
  EXPECT_EQ(line.find('\n'), line.size() - 1);
  EXPECT_NE(line.find(R"("line\nend )"), std::string::npos);
  EXPECT_NE(line.find(R"("existence":null)"), std::string::npos);
}

TEST(StreamFormats, CsvIsOneRowForATarget) {
  EXPECT_EQ(broadcast::csvRowsFormat().preamble(exampleRig()),
            "time_s,frame,id,target,state,x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s,cov_xx_m2,cov_xy_m2,"
            "cov_xz_m2,cov_yy_m2,cov_yz_m2,cov_zz_m2,existence,cameras\n");
  EXPECT_EQ(broadcast::csvRowsFormat().encode(exampleFrame()),
            (Lines{"0.4,12,1,pink ball,held,0.5,1,0.25,1,0,-0.5,4e-06,1e-06,0,9e-06,2e-06,1e-06,"
                   "0.75,\"left;the \"\"right\"\", one\"\n",
                   "0.4,12,2,blue,lost,,,,,,,,,,,,,0.125,\n"}));
}

// The binary layout of OSC 1.0, written down by hand.

std::string number(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) {
    bytes += static_cast<char>((value >> static_cast<unsigned>(shift)) & 0xFFU);
  }
  return bytes;
}
std::string real(float value) {
  return number(std::bit_cast<std::uint32_t>(value));
}
/// Ends with a null, and is filled with nulls to a multiple of four.
std::string text(std::string words) {
  do {
    words += '\0';
  } while (words.size() % 4 != 0);
  return words;
}
std::string sized(const std::string& message) {
  return number(static_cast<std::uint32_t>(message.size())) + message;
}
const std::string kBundleHead = text("#bundle") + number(0) + number(1); // at once

TEST(StreamFormats, OscIsABundleOfDocumentedMessages) {
  std::string expected = kBundleHead;
  expected += sized(text("/dewpoint/frame") + text(",iifi") + number(12) + number(7) + real(0.4F) +
                    number(2));
  expected += sized(text("/dewpoint/target") + text(",issfffffff") + number(1) + text("pink ball") +
                    text("held") + real(0.5F) + real(1.0F) + real(0.25F) + real(1.0F) + real(0.0F) +
                    real(-0.5F) + real(0.75F));
  expected += sized(text("/dewpoint/covariance") + text(",iffffff") + number(1) + real(4e-6F) +
                    real(1e-6F) + real(0.0F) + real(9e-6F) + real(2e-6F) + real(1e-6F));
  expected += sized(text("/dewpoint/cameras") + text(",iss") + number(1) + text("left") +
                    text("the \"right\", one"));
  expected += sized(text("/dewpoint/absent") + text(",issf") + number(2) + text("blue") +
                    text("lost") + real(0.125F));
  EXPECT_EQ(broadcast::oscMessagesFormat().encode(exampleFrame()), Lines{expected});
}

TEST(StreamFormats, TuioIsAliveSetAndFseq) {
  // The volume is 2 x 4 x 1, from (0, -2, 0) on; the acceleration is along the path:
  // v = (0.5, 0, -0.5), a = (0.25, 0, 0), and a v / |v| = 0.125 / 0.7071.
  std::string expected = kBundleHead;
  expected += sized(text("/tuio/3Dcur") + text(",si") + text("alive") + number(1));
  expected += sized(text("/tuio/3Dcur") + text(",sifffffff") + text("set") + number(1) +
                    real(0.25F) + real(0.75F) + real(0.25F) + real(0.5F) + real(0.0F) +
                    real(-0.5F) + real(static_cast<float>(0.125 / std::sqrt(0.5))));
  expected += sized(text("/tuio/3Dcur") + text(",si") + text("fseq") + number(7));
  EXPECT_EQ(broadcast::tuioCursorsFormat().encode(exampleFrame()), Lines{expected});
}

TEST(StreamFormats, ManyTargetsAreDividedIntoDatagrams) {
  FrameMessage frame = exampleFrame();
  const broadcast::TargetMessage one = frame.targets[0];
  frame.targets.clear();
  for (int id = 1; id <= 100; ++id) {
    frame.targets.push_back(one);
    frame.targets.back().id = id;
  }
  for (const auto* format : {&broadcast::oscMessagesFormat(), &broadcast::tuioCursorsFormat()}) {
    const Lines datagrams = format->encode(frame);
    EXPECT_GT(datagrams.size(), 3U) << format->id;
    for (const std::string& datagram : datagrams) {
      EXPECT_LE(datagram.size(), broadcast::kMaxDatagram) << format->id;
      EXPECT_TRUE(datagram.starts_with(kBundleHead));
    }
  }
}

TEST(StreamFormats, LongNamesAreCutInOscBetweenCharacters) {
  broadcast::OscBundle bundle;
  std::string name(254, 'a');
  bundle.add({{"/x", {name + "\xc3\xa4" + "bc"}}}); // a with two dots, in two bytes
  EXPECT_EQ(bundle.bytes(), kBundleHead + sized(text("/x") + text(",s") + text(name)));
}

} // namespace
} // namespace dewpoint::tests
