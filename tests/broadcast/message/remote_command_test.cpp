// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/message/remote_command.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace dewpoint::tests {
namespace {

using broadcast::parseRemoteCommand;
using broadcast::RemoteAction;
using broadcast::RemoteCommand;
using broadcast::RemoteCommandFilter;

TEST(RemoteCommand, IsReadFromJson) {
  const auto start = parseRemoteCommand(R"({"command": "start", "token": "secret"})");
  ASSERT_TRUE(start);
  EXPECT_EQ(start->action, RemoteAction::Start);
  EXPECT_EQ(start->token, "secret");
  EXPECT_EQ(parseRemoteCommand(R"({"command": "stop"})")->action, RemoteAction::Stop);
  const auto record = parseRemoteCommand(R"({"command": "record", "name": "take_2-b"})");
  ASSERT_TRUE(record);
  EXPECT_EQ(record->action, RemoteAction::StartRecording);
  EXPECT_EQ(record->name, "take_2-b");
  EXPECT_EQ(parseRemoteCommand(R"({"command": "stop-recording"})")->action,
            RemoteAction::StopRecording);
}

TEST(RemoteCommand, AnythingElseIsRefusedWithItsKey) {
  const auto fieldOf = [](const std::string& text) {
    const auto command = parseRemoteCommand(text);
    EXPECT_FALSE(command) << text;
    return command ? "none" : command.error().field;
  };
  for (const char* text : {"", "x", "[]", "3", "null", "{", "\xff", "{\"command\": \"start\"} x"}) {
    EXPECT_EQ(fieldOf(text), "") << text;
  }
  EXPECT_EQ(fieldOf("{}"), "command");
  EXPECT_EQ(fieldOf(R"({"command": 3})"), "command");
  EXPECT_EQ(fieldOf(R"({"command": "format c:"})"), "command");
  EXPECT_EQ(fieldOf(R"({"command": "start", "token": 5})"), "token");
  EXPECT_EQ(fieldOf(R"({"command": "record", "name": "../../etc/passwd"})"), "name");
  EXPECT_EQ(fieldOf(R"({"command": "record", "name": ")" + std::string(65, 'a') + "\"}"), "name");
  EXPECT_EQ(fieldOf(std::string(100'000, '[')), "");
  EXPECT_EQ(fieldOf(R"({"command": "start", "token": ")" + std::string(1 << 20, 'a') + "\"}"), "");
}

TEST(RemoteCommandFilter, ExecutesCommandsWithTheTokenOnly) {
  std::vector<RemoteCommand> done;
  RemoteCommandFilter gate("a long secret", [&](const RemoteCommand& command) {
    done.push_back(command);
    return Status();
  });
  EXPECT_EQ(gate.handle(R"({"command": "start", "token": "a long secret"})"),
            R"({"ok":true,"type":"reply"})");
  ASSERT_EQ(done.size(), 1U);
  EXPECT_NE(gate.handle(R"({"command": "start"})").find(R"("ok":false)"), std::string::npos);
  EXPECT_NE(gate.handle("nonsense").find("a JSON object is expected"), std::string::npos);
  EXPECT_EQ(done.size(), 1U);
}

TEST(RemoteCommandFilter, AFailureIsReported) {
  RemoteCommandFilter gate("a long secret", [](const RemoteCommand&) -> Status {
    return failure(ErrorCode::BadValue, "", "record", "there is no folder");
  });
  EXPECT_NE(
      gate.handle(R"({"command": "record", "token": "a long secret"})").find("there is no folder"),
      std::string::npos);
}

TEST(RemoteCommandFilter, IsOffWithoutATokenOrAReceiver) {
  int calls = 0;
  RemoteCommandFilter noToken("", [&](const RemoteCommand&) {
    ++calls;
    return Status();
  });
  EXPECT_EQ(noToken.handle(R"({"command": "start", "token": ""})"), "");
  RemoteCommandFilter noReceiver("a long secret", {});
  EXPECT_EQ(noReceiver.handle(R"({"command": "start", "token": "a long secret"})"), "");
  EXPECT_EQ(calls, 0);
}

TEST(RemoteCommandFilter, WrongTokensLockItForAWhile) {
  int calls = 0;
  RemoteCommandFilter gate("a long secret", [&](const RemoteCommand&) {
    ++calls;
    return Status();
  });
  const RemoteCommandFilter::Clock::time_point begin{};
  const std::string right = R"({"command": "start", "token": "a long secret"})";
  for (std::size_t k = 0; k < RemoteCommandFilter::kMaxWrongTokens; ++k) {
    gate.handle(R"({"command": "start", "token": "guess"})", begin + std::chrono::seconds(k));
  }
  EXPECT_NE(gate.handle(right, begin + std::chrono::seconds(10)).find("too many"),
            std::string::npos);
  EXPECT_EQ(calls, 0);
  EXPECT_NE(gate.handle(right, begin + RemoteCommandFilter::kLockoutTime + std::chrono::seconds(1))
                .find("true"),
            std::string::npos);
  EXPECT_EQ(calls, 1);
}

TEST(RemoteCommandFilter, ComparesWholeTexts) {
  EXPECT_TRUE(broadcast::areEqualInConstantTime("abc", "abc"));
  EXPECT_TRUE(broadcast::areEqualInConstantTime("", ""));
  EXPECT_FALSE(broadcast::areEqualInConstantTime("abc", "abd"));
  EXPECT_FALSE(broadcast::areEqualInConstantTime("abc", "abcd"));
  EXPECT_FALSE(broadcast::areEqualInConstantTime("abc", ""));
}

} // namespace
} // namespace dewpoint::tests
