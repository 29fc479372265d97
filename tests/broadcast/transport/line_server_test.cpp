// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/transport/line_server.h"
#include "tests/broadcast/test_socket.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace dewpoint::tests {
namespace {

using broadcast::LineServer;
using broadcast::RemoteCommand;
using broadcast::RemoteCommandFilter;

std::unique_ptr<LineServer> serverWith(const std::shared_ptr<RemoteCommandFilter>& gate) {
  auto server = LineServer::open("127.0.0.1", 0, gate);
  EXPECT_TRUE(server);
  return std::move(*server);
}

std::unique_ptr<LineServer> serverWithoutCommands() {
  return serverWith(std::make_shared<RemoteCommandFilter>("", broadcast::RemoteReceiver()));
}

bool hasClients(const LineServer& server, int count) {
  return becomesTrue([&] { return server.report().clientCount == count; });
}

TEST(LineServer, SendsTheOpeningAndThenEveryLineToEveryClient) {
  const auto server = serverWithoutCommands();
  server->setPreamble("first\n");
  TestSocket one = TestSocket::connectedTo(server->port());
  TestSocket other = TestSocket::connectedTo(server->port());
  ASSERT_TRUE(hasClients(*server, 2));
  server->send({"a\n", "b\n"});
  EXPECT_EQ(one.readUntil("b\n"), "first\na\nb\n");
  EXPECT_EQ(other.readUntil("b\n"), "first\na\nb\n");
  server->setPreamble("first\n");
  server->setPreamble("changed\n");
  EXPECT_EQ(one.readUntil("changed\n"), "changed\n");
  EXPECT_TRUE(
      broadcast::outletAddressText(server->report()).starts_with("JSON lines at 127.0.0.1:"));
}

TEST(LineServer, APortThatIsTakenIsReported) {
  const auto server = serverWithoutCommands();
  const auto again =
      LineServer::open("127.0.0.1", server->port(),
                       std::make_shared<RemoteCommandFilter>("", broadcast::RemoteReceiver()));
  ASSERT_FALSE(again);
  EXPECT_NE(again.error().detail.find(std::to_string(server->port())), std::string::npos);
  EXPECT_FALSE(LineServer::open("no.such.host.invalid", 0, nullptr));
}

TEST(LineServer, ASlowClientMissesLinesAndHoldsUpNobody) {
  const auto server = serverWithoutCommands();
  TestSocket slow = TestSocket::connectedTo(server->port(), 4096);
  TestSocket quick = TestSocket::connectedTo(server->port());
  ASSERT_TRUE(hasClients(*server, 2));
  const std::string line(1000, 'x');
  std::string last;
  for (int k = 0; k < 2000; ++k) {
    last = std::to_string(k) + "\n";
    server->send({line + last});
    if (k % 100 == 99) {
      EXPECT_NE(quick.readUntil("x" + last).find("x" + last), std::string::npos);
    }
  }
  EXPECT_GT(server->report().droppedPieceCount, 0);
  // It then gets whole lines, and the newest.
  const std::string late = slow.readUntil("x" + last);
  EXPECT_NE(late.find("x" + last), std::string::npos);
  for (std::size_t from = 0, end = late.find('\n'); end != std::string::npos;
       from = end + 1, end = late.find('\n', from)) {
    EXPECT_EQ(late.substr(from, line.size()), line);
  }
}

TEST(LineServer, HostileInputIsIgnored) {
  std::atomic<int> calls = 0;
  const auto server =
      serverWith(std::make_shared<RemoteCommandFilter>("a long secret", [&](const auto&) {
        ++calls;
        return Status();
      }));
  TestSocket client = TestSocket::connectedTo(server->port());
  EXPECT_TRUE(client.send(std::string(1 << 20, '[')));
  EXPECT_TRUE(client.send("\n\n\n" + std::string(5000, '\0') + "\n\xff\xfe{\n"));
  EXPECT_TRUE(client.send(R"({"command": "start", "token": "a long secret"})"
                          "\n"));
  const std::string replies = client.readUntil(R"("ok":true)");
  EXPECT_NE(replies.find(R"("ok":true)"), std::string::npos);
  EXPECT_EQ(calls, 1);
  server->send({"still there\n"});
  EXPECT_NE(client.readUntil("still there\n").find("still there\n"), std::string::npos);
}

TEST(LineServer, WithoutATokenNothingIsAnswered) {
  const auto server = serverWithoutCommands();
  TestSocket client = TestSocket::connectedTo(server->port());
  ASSERT_TRUE(hasClients(*server, 1));
  EXPECT_TRUE(client.send(R"({"command": "start", "token": ""})"
                          "\n"));
  server->send({"frame\n"});
  EXPECT_EQ(client.readUntil("frame\n"), "frame\n");
}

TEST(LineServer, AClientThatOnlyListensStaysAndOneThatLeavesIsForgotten) {
  const auto server = serverWithoutCommands();
  TestSocket listener = TestSocket::connectedTo(server->port());
  {
    const TestSocket leaving = TestSocket::connectedTo(server->port());
    ASSERT_TRUE(hasClients(*server, 2));
  }
  listener.closeOwnSide();
  // The end of the other one shows when something is sent.
  EXPECT_TRUE(becomesTrue([&] {
    server->send({"x\n"});
    return server->report().clientCount == 1;
  }));
  server->send({"end\n"});
  EXPECT_NE(listener.readUntil("end\n").find("end\n"), std::string::npos);
}

TEST(LineServer, ManyConnectionsAreLimited) {
  const auto server = serverWithoutCommands();
  std::vector<TestSocket> clients;
  for (std::size_t k = 0; k < LineServer::kMaxClients + 10; ++k) {
    clients.push_back(TestSocket::connectedTo(server->port()));
  }
  EXPECT_TRUE(hasClients(*server, static_cast<int>(LineServer::kMaxClients)));
  EXPECT_TRUE(clients.back().isClosedByOther());
  server->send({"x\n"});
  EXPECT_EQ(clients.front().readUntil("x\n"), "x\n");
}

} // namespace
} // namespace dewpoint::tests
