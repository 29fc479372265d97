// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/broadcast/transport/outlet.h"

#include <cstddef>
#include <cstdint>
#include <deque>

namespace dewpoint::broadcast {

/// What waits for one client. It holds a limited number of bytes: if a client is too slow, the
/// oldest pieces are dropped, but never the one that is being sent.
class OutgoingQueue {
public:
  /// About three seconds of ten targets at 30 frames per second.
  static constexpr std::size_t kMaxBytes = std::size_t{256} << 10U;

  explicit OutgoingQueue(std::size_t maxBytes = kMaxBytes) : maxBytes_(maxBytes) {}

  /// Appends a piece, and returns how many others were dropped for it. A piece that is larger than
  /// the queue is dropped itself, unless the queue is empty.
  std::int64_t push(SharedBytes piece);
  bool empty() const { return pieces_.empty(); }
  /// Returns the piece that is being sent; the queue must not be empty.
  const SharedBytes& front() const { return pieces_.front(); }
  /// Removes it.
  void pop();
  std::size_t bytes() const { return bytes_; }

private:
  std::size_t maxBytes_;
  std::size_t bytes_ = 0;
  std::deque<SharedBytes> pieces_;
};

} // namespace dewpoint::broadcast
