// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/transport/outgoing_queue.h"

#include <utility>

namespace dewpoint::broadcast {

std::int64_t OutgoingQueue::push(SharedBytes piece) {
  std::int64_t dropped = 0;
  while (pieces_.size() > 1 && byteCount_ + piece->size() > maxBytes_) {
    byteCount_ -= pieces_[1]->size();
    pieces_.erase(pieces_.begin() + 1);
    ++dropped;
  }
  if (!pieces_.empty() && byteCount_ + piece->size() > maxBytes_) {
    return dropped + 1;
  }
  byteCount_ += piece->size();
  pieces_.push_back(std::move(piece));
  return dropped;
}

void OutgoingQueue::pop() {
  byteCount_ -= pieces_.front()->size();
  pieces_.pop_front();
}

} // namespace dewpoint::broadcast
