// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace dewpoint::session {

/// Log that keeps at most `maxRecords` records, in order of arrival. Whenever there are more, every
/// second group of the older half is removed. A group consists of consecutive records with the same
/// value of `group(record)`. The newest records are therefore complete, and older ones are
/// increasingly sparse.
template <class Record> class ThinnedLog {
public:
  using GroupOf = std::int64_t (*)(const Record&);
  ThinnedLog(std::size_t maxRecords, GroupOf group) : maxRecords_(maxRecords), group_(group) {}

  void clear() {
    entries_.clear();
    appended_ = 0;
  }
  void append(Record record) {
    entries_.push_back({appended_++, std::move(record)});
    if (entries_.size() > maxRecords_) {
      thin();
    }
  }
  /// Removes records from the end of the log as long as `unwanted` returns true for the last
  /// record.
  template <class Predicate> void removeLastWhile(const Predicate& unwanted) {
    while (!entries_.empty() && unwanted(entries_.back().record)) {
      entries_.pop_back();
    }
  }
  /// Calls `change` to change every record in place, and removes the records for which it returns
  /// false.
  template <class Change> void changeOrRemoveEach(const Change& change) {
    std::erase_if(entries_, [&](Entry& entry) { return !change(entry.record); });
  }
  /// Returns the records appended at or after `position` that are still in the log, and moves
  /// `position` past them. `position` counts all records ever appended.
  std::vector<Record> since(std::size_t& position) const {
    std::vector<Record> found;
    auto next = std::lower_bound(
        entries_.begin(), entries_.end(), position,
        [](const Entry& entry, std::size_t wanted) { return entry.position < wanted; });
    for (; next != entries_.end(); ++next) {
      found.push_back(next->record);
    }
    position = appended_;
    return found;
  }
  std::size_t size() const { return entries_.size(); }
  bool empty() const { return entries_.empty(); }

private:
  struct Entry {
    std::size_t position; ///< number of records appended before this one
    Record record;
  };

  void thin() {
    auto half = entries_.begin() + static_cast<std::ptrdiff_t>(entries_.size() / 2);
    while (half != entries_.end() && group_(half->record) == group_(std::prev(half)->record)) {
      ++half;
    }
    auto kept = entries_.begin();
    std::int64_t last = group_(entries_.front().record);
    bool wanted = true;
    for (auto entry = entries_.begin(); entry != half; ++entry) {
      const std::int64_t group = group_(entry->record);
      wanted = wanted == (group == last); // every other group
      last = group;
      if (wanted && kept++ != entry) {
        *std::prev(kept) = std::move(*entry);
      }
    }
    entries_.erase(kept, half);
  }

  std::size_t maxRecords_;
  GroupOf group_;
  std::size_t appended_ = 0;
  std::vector<Entry> entries_;
};

} // namespace dewpoint::session
