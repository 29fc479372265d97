// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/frames/trouble_search.h"

#include <algorithm>

namespace dewpoint::session {

namespace {

bool isTroubled(const FrameRecord* record, std::size_t target) {
  if (record == nullptr || target >= record->targets.size()) {
    return false;
  }
  const TargetStatus status = record->targets[target].status;
  return status != TargetStatus::Held && status != TargetStatus::Gone;
}

bool hasNewProblem(const FrameRecord* before, const FrameRecord& record) {
  if (record.cameraProblems == nullptr) {
    return false;
  }
  if (before == nullptr || before->cameraProblems == nullptr) {
    return !record.cameraProblems->empty();
  }
  return before->cameraProblems != record.cameraProblems && // a shared list has nothing new
         std::ranges::any_of(*record.cameraProblems, [before](const Error& problem) {
           return std::ranges::find(*before->cameraProblems, problem) ==
                  before->cameraProblems->end();
         });
}

/// Whether trouble begins in a record. `before` is the record before it; null if it is the first.
bool beginsTrouble(const FrameRecord* before, const FrameRecord& record,
                   std::optional<std::size_t> target) {
  const std::size_t first = target.value_or(0);
  const std::size_t end = target ? *target + 1 : record.targets.size();
  for (std::size_t k = first; k < end; ++k) {
    if (isTroubled(&record, k) && !isTroubled(before, k)) {
      return true;
    }
  }
  return hasNewProblem(before, record);
}

} // namespace

std::optional<std::int64_t> nextTrouble(std::span<const FrameRecord> records, std::int64_t from,
                                        int direction, std::optional<std::size_t> target) {
  const auto begins = [&](std::size_t k) {
    return beginsTrouble(k > 0 ? &records[k - 1] : nullptr, records[k], target);
  };
  if (direction > 0) {
    const auto after = std::ranges::upper_bound(records, from, {}, &FrameRecord::frame);
    for (auto k = static_cast<std::size_t>(after - records.begin()); k < records.size(); ++k) {
      if (begins(k)) {
        return records[k].frame;
      }
    }
  } else {
    const auto notBefore = std::ranges::lower_bound(records, from, {}, &FrameRecord::frame);
    for (auto k = static_cast<std::size_t>(notBefore - records.begin()); k-- > 0;) {
      if (begins(k)) {
        return records[k].frame;
      }
    }
  }
  return std::nullopt;
}

} // namespace dewpoint::session
