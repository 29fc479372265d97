// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text_file.h"
#include "core/project/project_changes.h"
#include "core/project/project_files.h"
#include "core/project/project_load.h"
#include "core/project/project_output.h"
#include "core/project/project_save.h"
#include "tests/project/loaded_text.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

constexpr const char* kOutput = R"(format = 2
name = "live"
scene = "demo"

[output]
axes = "y-up"
unit = "mm"
rate = 60
osc = "127.0.0.1:9000"
tuio = "[::1]:3333"
tcp = 9001
websocket = 0
csv = "results.csv"
listen = "0.0.0.0"
token = "${DEWPOINT_TOKEN}"
)";

std::string outputFieldOf(const std::string& from, const std::string& to) {
  const auto project = load(kOutput, from, to);
  EXPECT_FALSE(project) << from << " -> " << to;
  return project ? "" : project.error().field;
}

TEST(ProjectOutput, IsReadAndSavedUnchanged) {
  const auto project = load(kOutput);
  ASSERT_TRUE(project) << errorSentence(project.error());
  const OutputSettings& output = project->output;
  EXPECT_EQ(output.axes, OutputAxes::YUp);
  EXPECT_EQ(output.unit, OutputUnit::Millimeter);
  EXPECT_EQ(output.framesPerSecond, 60.0);
  EXPECT_EQ(output.oscReceiver, "127.0.0.1:9000");
  EXPECT_EQ(output.tuioReceiver, "[::1]:3333");
  EXPECT_EQ(output.tcpPort, 9001);
  EXPECT_EQ(output.webSocketPort, 0);
  EXPECT_EQ(output.csvFile, "results.csv");
  EXPECT_EQ(output.listenAddress, "0.0.0.0");
  EXPECT_EQ(output.token, "${DEWPOINT_TOKEN}"); // a secret of the environment stays there
  const auto file = fileNamed("saved.toml");
  ASSERT_TRUE(saveProject(*project, file));
  const auto again = loadProject(file);
  ASSERT_TRUE(again) << errorSentence(again.error());
  EXPECT_EQ(again->output, output);
}

TEST(ProjectOutput, IsOffUnlessGiven) {
  const auto project = load("format = 2\nscene = \"demo\"\n");
  ASSERT_TRUE(project) << errorSentence(project.error());
  EXPECT_FALSE(project->output.isAnyOn());
  EXPECT_EQ(project->output.listenAddress, "127.0.0.1");
  EXPECT_EQ(outputText(project->output), "");
  EXPECT_TRUE(load(kOutput)->output.isAnyOn());
}

TEST(ProjectOutput, WrongValuesAreNamed) {
  EXPECT_EQ(outputFieldOf("\"y-up\"", "\"x-up\""), "output.axes");
  EXPECT_EQ(outputFieldOf("\"mm\"", "\"inch\""), "output.unit");
  EXPECT_EQ(outputFieldOf("= 60", "= -1"), "output.rate");
  EXPECT_EQ(outputFieldOf("= 60", "= 1e9"), "output.rate");
  EXPECT_EQ(outputFieldOf("127.0.0.1:9000", "127.0.0.1"), "output.osc");
  EXPECT_EQ(outputFieldOf("127.0.0.1:9000", "127.0.0.1:0"), "output.osc");
  EXPECT_EQ(outputFieldOf("[::1]:3333", "::1:3333"), "output.tuio");
  EXPECT_EQ(outputFieldOf("9001", "65536"), "output.tcp");
  EXPECT_EQ(outputFieldOf("9001", "\"9001\""), "output.tcp");
  EXPECT_EQ(outputFieldOf("websocket = 0", "websocket = 9001"), "output.websocket");
  EXPECT_EQ(outputFieldOf("0.0.0.0", ""), "output.listen");
  EXPECT_EQ(outputFieldOf("${DEWPOINT_TOKEN}", "short"), "output.token");
  EXPECT_EQ(outputFieldOf("unit", "units"), "output.units");
}

TEST(ProjectOutput, AddressesHaveAHostAndAPort) {
  const auto address = parseOutputAddress("render-pc.local:7000");
  ASSERT_TRUE(address);
  EXPECT_EQ(address->host, "render-pc.local");
  EXPECT_EQ(address->port, 7000);
  EXPECT_EQ(parseOutputAddress("[fe80::1]:1")->host, "fe80::1");
  for (const char* bad : {"", ":", ":1", "a:", "a:b", "a:-1", "a:70000", "a b:1", "[]:1", "a:1 "}) {
    EXPECT_FALSE(parseOutputAddress(bad)) << bad;
  }
  EXPECT_FALSE(parseOutputAddress(std::string(1000, 'a') + ":1"));
}

TEST(ProjectOutput, AChangeIsAnEditButNotAnotherRun) {
  const auto before = load(kOutput);
  ASSERT_TRUE(before);
  Project after = *before;
  after.output.tcpPort.reset();
  EXPECT_TRUE(changesBetween(*before, after).outputChanged);
  EXPECT_TRUE(changesBetween(*before, after).hasAny());
  EXPECT_EQ(runInputText(*before), runInputText(after));
}

} // namespace
} // namespace dewpoint::tests
