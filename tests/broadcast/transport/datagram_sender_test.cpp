// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/transport/datagram_sender.h"
#include "tests/broadcast/test_socket.h"

#include <gtest/gtest.h>

#include <string>

namespace dewpoint::tests {
namespace {

using broadcast::DatagramSender;
using broadcast::OutletKind;

TEST(DatagramSender, SendsEachPieceAsOneDatagram) {
  TestSocket receiver = TestSocket::receiver();
  auto sender =
      DatagramSender::open("127.0.0.1:" + std::to_string(receiver.port()), OutletKind::OscMessages);
  ASSERT_TRUE(sender);
  (*sender)->send({"one"});
  EXPECT_EQ(receiver.readUntil("one"), "one");
  (*sender)->send({"two", "three"});
  EXPECT_EQ(receiver.readUntil("three"), "twothree");
  EXPECT_EQ((*sender)->report().sentPieceCount, 3);
  EXPECT_TRUE(
      broadcast::outletAddressText((*sender)->report()).starts_with("OSC messages to 127.0.0.1:"));
}

TEST(DatagramSender, NobodyNeedsToListen) {
  std::uint16_t port = 0;
  { port = TestSocket::receiver().port(); }
  auto sender = DatagramSender::open("127.0.0.1:" + std::to_string(port), OutletKind::OscMessages);
  ASSERT_TRUE(sender);
  for (int k = 0; k < 100; ++k) {
    (*sender)->send({"x"});
  }
  (*sender)->send({std::string(100'000, 'x')}); // larger than any datagram
  EXPECT_GE((*sender)->report().droppedPieceCount, 1);
}

TEST(DatagramSender, AnUnknownAddressIsReported) {
  EXPECT_FALSE(DatagramSender::open("no port", OutletKind::OscMessages));
  EXPECT_FALSE(DatagramSender::open("no.such.host.invalid:9000", OutletKind::OscMessages));
}

} // namespace
} // namespace dewpoint::tests
