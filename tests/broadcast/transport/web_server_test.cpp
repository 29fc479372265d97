// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/transport/live_page.h"
#include "core/broadcast/transport/web_server.h"
#include "tests/broadcast/test_socket.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace dewpoint::tests {
namespace {

using broadcast::RemoteCommandFilter;
using broadcast::WebServer;

std::unique_ptr<WebServer> webServer(const std::string& token = "",
                                     broadcast::RemoteReceiver receiver = {}) {
  auto server = WebServer::open("127.0.0.1", 0,
                                std::make_shared<RemoteCommandFilter>(token, std::move(receiver)));
  EXPECT_TRUE(server);
  return std::move(*server);
}

std::string request(const WebServer& server, const std::string& first,
                    const std::string& more = "") {
  return first + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(server.port()) + "\r\n" + more +
         "\r\n";
}

std::string answerTo(const WebServer& server, const std::string& bytes) {
  TestSocket client = TestSocket::connectedTo(server.port());
  EXPECT_TRUE(client.send(bytes));
  return client.readUntil("there is no such text");
}

/// The key is that of the example in RFC 6455, section 1.3.
const std::string kUpgrade = "Connection: Upgrade\r\nUpgrade: websocket\r\n"
                             "Sec-WebSocket-Version: 13\r\n"
                             "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";

TestSocket webSocketOf(const WebServer& server) {
  TestSocket client = TestSocket::connectedTo(server.port());
  EXPECT_TRUE(client.send(request(server, "GET /", kUpgrade)));
  const std::string answer = client.readUntil("\r\n\r\n");
  EXPECT_NE(answer.find("101"), std::string::npos) << answer;
  EXPECT_NE(answer.find("s3pPLMBiTxaQ9kYGzzhZRbK+xOo="), std::string::npos) << answer;
  EXPECT_TRUE(becomesTrue([&] { return server.report().clientCount == 1; }));
  return client;
}

/// A text message from a client, masked with zeros (RFC 6455, section 5.2).
std::string maskedText(const std::string& text) {
  std::string frame = "\x81";
  if (text.size() < 126) {
    frame += static_cast<char>(0x80U | text.size());
  } else {
    frame += "\xff"; // an eight-byte length follows
    for (int shift = 56; shift >= 0; shift -= 8) {
      frame += static_cast<char>((text.size() >> static_cast<unsigned>(shift)) & 0xFFU);
    }
  }
  return frame + std::string(4, '\0') + text;
}

TEST(WebServer, ServesThePage) {
  const auto server = webServer();
  const std::string answer = answerTo(*server, request(*server, "GET /"));
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 200 OK\r\n")) << answer.substr(0, 200);
  EXPECT_NE(answer.find(broadcast::livePage()), std::string::npos);
  EXPECT_NE(answer.find("Content-Security-Policy: default-src 'none'"), std::string::npos);
  const std::string head = answerTo(*server, request(*server, "HEAD /"));
  EXPECT_EQ(head.find("<html"), std::string::npos);
  EXPECT_TRUE(answerTo(*server, request(*server, "GET /etc/passwd")).starts_with("HTTP/1.1 404"));
  EXPECT_TRUE(answerTo(*server, request(*server, "DELETE /")).starts_with("HTTP/1.1 405"));
}

TEST(WebServer, ThePageHasTheTextsOfItsLanguage) {
  broadcast::PageTexts texts;
  texts.language = "de";
  texts.title = "Dewpoint \"live\" <&>";
  texts.help = "Ziehen: drehen";
  texts.waiting = "Verbunden. </script>";
  texts.frame = "Bild %1, %2";
  texts.states["held"] = "verfolgt";
  texts.pageNotFound = "Es gibt nur eine Seite, /.";
  const auto server = webServer();
  EXPECT_NE(answerTo(*server, request(*server, "GET /")).find("<html lang=\"en\">"),
            std::string::npos);
  server->setPageTexts(texts);
  const std::string page = answerTo(*server, request(*server, "GET /")); // the next load
  for (const char* part :
       {"<html lang=\"de\">", "<title>Dewpoint &quot;live&quot; &lt;&amp;&gt;</title>",
        "<div id=\"help\">Ziehen: drehen</div>", "\"Verbunden. \\u003c/script>\"",
        "\"Bild %1, %2\"", "\"held\":\"verfolgt\""}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(page.find("{{"), std::string::npos);
  EXPECT_EQ(page.find("Waiting for images"), std::string::npos);
  EXPECT_NE(answerTo(*server, request(*server, "GET /other")).find(texts.pageNotFound),
            std::string::npos);
}

TEST(WebServer, ThePageNeedsNothingElse) {
  const std::string page = broadcast::livePage();
  for (const char* outside : {"http://", "https://", "src=", "@import", "url("}) {
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  }
  EXPECT_EQ(page.find("innerHTML"), std::string::npos); // names of targets are no markup
}

TEST(WebServer, SendsTextMessages) {
  const auto server = webServer();
  server->setPreamble("first\n");
  TestSocket client = webSocketOf(*server);
  server->send({"a\n"});
  EXPECT_EQ(client.readUntil("a\n"), "\x81\x06"
                                     "first\n"
                                     "\x81\x02"
                                     "a\n");
  server->send({std::string(100'000, 'x') + "end"}); // in one piece, after a length of 8 bytes
  EXPECT_EQ(client.readUntil("end").size(), 2U + 8U + 100'003U);
  EXPECT_TRUE(broadcast::outletAddressText(server->report())
                  .starts_with("page and WebSocket at http://127.0.0.1:"));
}

TEST(WebServer, ExecutesRemoteCommandsWithTheToken) {
  int calls = 0;
  const auto server = webServer("a long secret", [&](const auto&) {
    ++calls;
    return Status();
  });
  TestSocket client = webSocketOf(*server);
  EXPECT_TRUE(client.send(maskedText(R"({"command": "stop", "token": "wrong"})")));
  EXPECT_NE(client.readUntil("}").find(R"("ok":false)"), std::string::npos);
  EXPECT_TRUE(client.send(maskedText(R"({"command": "stop", "token": "a long secret"})")));
  EXPECT_NE(client.readUntil("}").find(R"("ok":true)"), std::string::npos);
  EXPECT_EQ(calls, 1);
}

TEST(WebServer, HostileInputEndsOnlyItsOwnConnection) {
  const auto server = webServer();
  TestSocket good = webSocketOf(*server);
  {
    TestSocket large = TestSocket::connectedTo(server->port());
    EXPECT_TRUE(large.send(request(*server, "GET /", kUpgrade)));
    large.readUntil("\r\n\r\n");
    large.send(maskedText(std::string(1 << 20, 'x')));
    EXPECT_TRUE(large.isClosedByOther());
  }
  for (const std::string& bytes :
       {std::string(1 << 20, 'A'), std::string("\x16\x03\x01garbage\r\n\r\n"),
        std::string(100, '\0'), "GET / HTTP/1.1\r\nX: " + std::string(1 << 20, 'a')}) {
    TestSocket bad = TestSocket::connectedTo(server->port());
    bad.send(bytes);
    EXPECT_TRUE(bad.isClosedByOther());
  }
  const TestSocket halfOpen = TestSocket::connectedTo(server->port()); // says nothing
  server->send({"still there\n"});
  EXPECT_NE(good.readUntil("still there\n").find("still there\n"), std::string::npos);
}

TEST(WebServer, PagesOfOtherSitesAreRefused) {
  EXPECT_TRUE(broadcast::isAllowedOrigin("127.0.0.1:8000", "", true));
  EXPECT_TRUE(broadcast::isAllowedOrigin("localhost:8000", "http://localhost:8000", true));
  EXPECT_TRUE(broadcast::isAllowedOrigin("[::1]:8000", "http://[::1]:8000", true));
  EXPECT_TRUE(broadcast::isAllowedOrigin("lab-pc:8000", "http://lab-pc:8000", false));
  EXPECT_FALSE(broadcast::isAllowedOrigin("127.0.0.1:8000", "https://site.example", true));
  EXPECT_FALSE(broadcast::isAllowedOrigin("127.0.0.1:8000", "null", true));
  // A name that leads here, as in DNS rebinding.
  EXPECT_FALSE(broadcast::isAllowedOrigin("site.example:8000", "http://site.example:8000", true));
  EXPECT_FALSE(broadcast::isAllowedOrigin("", "", true));
  const auto server = webServer();
  const std::string answer =
      answerTo(*server, request(*server, "GET /", kUpgrade + "Origin: http://site.example\r\n"));
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 403")) << answer;
}

TEST(WebServer, ManyConnectionsAreLimited) {
  const auto server = webServer();
  std::vector<TestSocket> clients;
  for (std::size_t k = 0; k < WebServer::kMaxClients; ++k) {
    clients.push_back(TestSocket::connectedTo(server->port()));
  }
  TestSocket last = TestSocket::connectedTo(server->port());
  EXPECT_TRUE(last.isClosedByOther());
}

TEST(WebServer, APortThatIsTakenIsReported) {
  const auto server = webServer();
  const auto again = WebServer::open("127.0.0.1", server->port(), nullptr);
  ASSERT_FALSE(again);
  EXPECT_NE(again.error().detail.find(std::to_string(server->port())), std::string::npos);
  EXPECT_FALSE(WebServer::open("not an address", 0, nullptr));
}

} // namespace
} // namespace dewpoint::tests
