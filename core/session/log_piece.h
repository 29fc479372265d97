// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstddef>
#include <vector>

namespace dewpoint::session {

/// What a log gained since a reader was last there.
template <class Record> struct LogPiece {
  /// Number of the first of `records`: what the reader has from it on is void. Only of logs whose
  /// last frame may be replaced; 0 in others.
  std::size_t first = 0;
  std::vector<Record> records;
  bool restarted = false; ///< all that is known comes again: a new run, or one that went back
};

} // namespace dewpoint::session
