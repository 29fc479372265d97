// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/report/report_folder.h"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace dewpoint::experiment {

Status prepareReportFolder(const std::filesystem::path& folder, const std::string& report) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) {
    return failure(ErrorCode::FileUnwritable, folder.string(), "", problem.message());
  }
  if (const auto file = folder / report; std::filesystem::is_directory(file, problem)) {
    return failure(ErrorCode::FileUnwritable, file.string(), "", "it is a folder");
  }
  const auto trial = folder / ("." + report + ".part");
  errno = 0;
  std::ofstream stream(trial, std::ios::binary);
  stream << "dewpoint" << std::flush;
  const bool written = stream.good();
  const std::string reason = written ? "" : std::strerror(errno);
  stream.close();
  std::filesystem::remove(trial, problem);
  return written ? Status() : failure(ErrorCode::FileUnwritable, folder.string(), "", reason);
}

} // namespace dewpoint::experiment
