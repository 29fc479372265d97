// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/transport/outgoing_queue.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace dewpoint::tests {
namespace {

using broadcast::OutgoingQueue;

broadcast::SharedBytes bytesOf(std::string text) {
  return std::make_shared<const std::string>(std::move(text));
}

TEST(OutgoingQueue, DropsTheOldestButNotTheOneThatIsBeingSent) {
  OutgoingQueue queue(10);
  EXPECT_EQ(queue.push(bytesOf("aaaa")), 0);
  EXPECT_EQ(queue.push(bytesOf("bbbb")), 0);
  EXPECT_EQ(queue.push(bytesOf("cccc")), 1);
  EXPECT_EQ(queue.byteCount(), 8U);
  EXPECT_EQ(*queue.front(), "aaaa");
  queue.pop();
  EXPECT_EQ(*queue.front(), "cccc");
  queue.pop();
  EXPECT_TRUE(queue.empty());
  EXPECT_EQ(queue.byteCount(), 0U);
}

TEST(OutgoingQueue, APieceThatIsTooLargeIsSentAloneOrNotAtAll) {
  OutgoingQueue queue(10);
  EXPECT_EQ(queue.push(bytesOf(std::string(100, 'a'))), 0);
  EXPECT_EQ(queue.push(bytesOf("b")), 1);
  queue.pop();
  EXPECT_TRUE(queue.empty());
  queue.push(bytesOf("c"));
  EXPECT_EQ(queue.push(bytesOf(std::string(100, 'a'))), 1);
  EXPECT_EQ(*queue.front(), "c");
}

} // namespace
} // namespace dewpoint::tests
