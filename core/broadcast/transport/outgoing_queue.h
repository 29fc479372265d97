// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/broadcast/transport/outlet.h"

#include <cstddef>
#include <cstdint>
#include <deque>

namespace dewpoint::broadcast {

/// Queue of the pieces (lines or messages) that wait to be sent to one client. Its size in bytes is
/// limited: if the client is too slow, the oldest pieces are dropped. The piece that is being sent
/// is never dropped.
class OutgoingQueue {
public:
  /// Default size of a queue, bytes. Enough for about three seconds of ten targets at 30 frames per
  /// second.
  static constexpr std::size_t kMaxBytes = std::size_t{256} << 10U;

  explicit OutgoingQueue(std::size_t maxBytes = kMaxBytes) : maxBytes_(maxBytes) {}

  /// Appends a piece (a line or message) and drops the oldest waiting pieces if there is not enough
  /// space. If there is still not enough space, drops the new piece, unless the queue is empty.
  /// Returns the number of dropped pieces.
  std::int64_t push(SharedBytes piece);
  bool empty() const { return pieces_.empty(); }
  /// Returns the first piece (line or message), which is being sent. The queue must not be empty.
  const SharedBytes& front() const { return pieces_.front(); }
  /// Removes the first piece (line or message) from the queue. The queue must not be empty.
  void pop();
  /// Returns the number of bytes in the queue.
  std::size_t byteCount() const { return byteCount_; }

private:
  std::size_t maxBytes_;
  std::size_t byteCount_ = 0;
  std::deque<SharedBytes> pieces_;
};

} // namespace dewpoint::broadcast
