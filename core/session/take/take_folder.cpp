// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/take/take_folder.h"

#include "core/base/text_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace dewpoint::session {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kFolderPrefix = "take-";

fs::path folderOf(const fs::path& parent, int number) {
  return parent / fmt::format("{}{:03}", kFolderPrefix, number);
}

/// The next number after all takes in a folder.
int nextTakeNumber(const fs::path& parent) {
  int last = 0;
  std::error_code problem;
  for (fs::directory_iterator entry(parent, problem); !problem && entry != fs::directory_iterator();
       entry.increment(problem)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with(kFolderPrefix)) {
      last = std::max(last, toNumber<int>(name.substr(kFolderPrefix.size())).value_or(0));
    }
  }
  return last + 1;
}

} // namespace

Result<TakeFolder> makeTakeFolder(const fs::path& parent, std::optional<int> number) {
  std::error_code problem;
  const fs::path base = fs::absolute(parent, problem).lexically_normal();
  if (number && (*number < 1 || *number > kHighestTakeNumber)) {
    return failure(ErrorCode::BadValue, base.string(), "take",
                   fmt::format("{} is not from 1 to {}", *number, kHighestTakeNumber));
  }
  fs::create_directories(base, problem);
  for (int next = number.value_or(nextTakeNumber(base)); !problem; ++next) {
    const fs::path folder = folderOf(base, next);
    if (fs::create_directory(folder, problem)) { // not if another program was faster
      return TakeFolder{folder, next};
    }
    if (number && !problem) {
      return failure(ErrorCode::BadValue, folder.string(), "take",
                     fmt::format("take {} exists; choose another number", next));
    }
  }
  return failure(ErrorCode::FileUnwritable, base.string(), "", problem.message());
}

} // namespace dewpoint::session
