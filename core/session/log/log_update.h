// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstddef>
#include <vector>

namespace dewpoint::session {

/// Records added to a log since a reader last read it.
template <class Record> struct LogUpdate {
  /// Index in the log of the first of `records`. It is used only by logs whose last frame may be
  /// replaced: the reader must discard the records that it already has from this index on. In
  /// updates of other logs, it is 0 and must be ignored.
  std::size_t first = 0;
  std::vector<Record> records;
  /// True if `records` contains the whole log, because the run restarted or went back to an earlier
  /// frame. The reader must then discard all earlier records.
  bool restarted = false;
};

} // namespace dewpoint::session
