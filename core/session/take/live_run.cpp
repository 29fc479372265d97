// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/take/live_run.h"

#include "core/base/limits.h"
#include "core/base/text_file.h"
#include "core/base/text_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace dewpoint::session {
namespace {

constexpr std::string_view kLost = "lost";

/// Finds the images of one camera in its video. A stamp can come back after the camera was
/// connected again, so that the search goes on where the last image was found.
class StampFinder {
public:
  explicit StampFinder(const std::vector<std::int64_t>& stamps) {
    for (std::size_t k = 0; k < stamps.size(); ++k) {
      if (stamps[k] >= 0) {
        numbers_[stamps[k]].push_back(static_cast<std::int64_t>(k));
      }
    }
  }

  std::int64_t find(std::int64_t stamp) {
    const auto found = numbers_.find(stamp);
    if (found == numbers_.end()) {
      return -1;
    }
    const auto number = std::ranges::lower_bound(found->second, next_);
    if (number == found->second.end()) {
      return -1;
    }
    next_ = *number + 1;
    return *number;
  }

private:
  std::unordered_map<std::int64_t, std::vector<std::int64_t>> numbers_;
  std::int64_t next_ = 0;
};

bool hasStoredImage(const StoredFrameSet& set) {
  return std::ranges::any_of(set.images,
                             [](const auto& image) { return image && image->numberInVideo >= 0; });
}

std::vector<std::string_view> cellsOf(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    cells.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  return cells;
}

/// Nanoseconds; the difference of two times within the limit fits in 64 bits.
constexpr std::int64_t kMostNanoseconds = std::int64_t{1} << 62U;

/// Nothing if the cell is not a whole number within the limits.
std::optional<std::int64_t> wholeNumberIn(std::string_view cell, std::int64_t low,
                                          std::int64_t high) {
  const auto number = toNumber<std::int64_t>(cell);
  return number && *number >= low && *number <= high ? number : std::nullopt;
}

std::optional<std::int64_t> frameNumberIn(std::string_view cell) {
  return wholeNumberIn(cell, 0, limits::kMaxFrames);
}

std::optional<TimeStamp> timeIn(std::string_view cell) {
  const auto nanoseconds = wholeNumberIn(cell, -kMostNanoseconds + 1, kMostNanoseconds - 1);
  return nanoseconds ? std::optional(TimeStamp(*nanoseconds)) : std::nullopt;
}

/// Nothing if the line is none of such a table.
std::optional<StoredFrameSet> setIn(std::string_view line, std::size_t cameras) {
  const std::vector<std::string_view> cells = cellsOf(line);
  if (cells.size() != 2 + 2 * cameras) {
    return std::nullopt;
  }
  const auto index = frameNumberIn(cells[0]);
  const auto time = timeIn(cells[1]);
  if (!index || !time) {
    return std::nullopt;
  }
  StoredFrameSet set{*index, *time, {}};
  for (std::size_t k = 2; k < cells.size(); k += 2) {
    if (cells[k].empty()) {
      set.images.emplace_back();
      continue;
    }
    const auto number =
        cells[k] == kLost ? std::optional<std::int64_t>(-1) : frameNumberIn(cells[k]);
    const auto captured = timeIn(cells[k + 1]);
    if (!number || !captured) {
      return std::nullopt;
    }
    set.images.emplace_back(StoredImage{*number, *captured});
  }
  return set;
}

} // namespace

std::vector<StoredFrameSet>
locateStoredFrameSets(const std::vector<LiveFrameRecord>& sets,
                      const std::vector<std::vector<std::int64_t>>& stamps) {
  std::vector<StampFinder> finders(stamps.begin(), stamps.end());
  std::vector<StoredFrameSet> stored;
  for (const LiveFrameRecord& set : sets) {
    StoredFrameSet& one = stored.emplace_back(StoredFrameSet{set.index, set.time, {}});
    for (std::size_t k = 0; k < finders.size(); ++k) {
      const bool hasImage = k < set.images.size() && set.images[k];
      one.images.push_back(
          hasImage ? std::optional(StoredImage{finders[k].find(set.images[k]->imageNumber),
                                               set.images[k]->captureTime})
                   : std::nullopt);
    }
  }
  while (!stored.empty() && !hasStoredImage(stored.back())) {
    stored.pop_back();
  }
  return stored;
}

std::string storedFrameSetsCsv(const std::vector<StoredFrameSet>& sets) {
  std::string text = "# Which images of the videos the live run tracked in each frame\n"
                     "frame,time_ns";
  for (std::size_t k = 0; !sets.empty() && k < sets.front().images.size(); ++k) {
    text += fmt::format(",image_{0},time_{0}_ns", k + 1);
  }
  text += '\n';
  for (const StoredFrameSet& set : sets) {
    text += fmt::format("{},{}", set.index, set.time.count());
    for (const auto& image : set.images) {
      text += !image ? ",,"
              : image->numberInVideo < 0
                  ? fmt::format(",{},{}", kLost, image->captureTime.count())
                  : fmt::format(",{},{}", image->numberInVideo, image->captureTime.count());
    }
    text += '\n';
  }
  return text;
}

Status writeStoredFrameSets(const std::vector<StoredFrameSet>& sets,
                            const std::filesystem::path& file) {
  return writeTextFile(file, storedFrameSetsCsv(sets));
}

Result<std::vector<StoredFrameSet>> readStoredFrameSets(const std::filesystem::path& file,
                                                        std::size_t cameras) {
  const auto text = readTextFile(file);
  if (!text) {
    return tl::make_unexpected(text.error());
  }
  std::vector<StoredFrameSet> sets;
  int number = 0;
  std::string_view rest = *text;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    ++number;
    if (line.empty() || line.starts_with('#') || line.starts_with("frame,")) {
      continue;
    }
    auto set = setIn(line, cameras);
    if (!set) {
      return failure(
          ErrorCode::NotParsed, file.string(), fmt::format("line {}", number),
          fmt::format("expected frame, time, and two cells for each of {} cameras", cameras));
    }
    if (sets.size() == limits::kMaxRows) {
      return failure(ErrorCode::NotParsed, file.string(), fmt::format("line {}", number),
                     fmt::format("more than {} rows", limits::kMaxRows));
    }
    sets.push_back(std::move(*set));
  }
  return sets;
}

} // namespace dewpoint::session
