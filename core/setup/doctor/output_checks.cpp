// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/doctor/output_checks.h"

#include <fmt/format.h>

#include <filesystem>
#include <unistd.h>

namespace dewpoint::setup {
namespace {

constexpr double kGigabyte = 1e9;
constexpr double kMegabyte = 1e6;
// Bytes. An hour of one target is about 30 MB of trajectory, of people some 100 MB with volumes.
constexpr double kLowDiskBytes = 1e9;
constexpr double kFullDiskBytes = 1e8;

/// The folder itself, or the nearest one above it that is there.
std::filesystem::path existingFolder(std::filesystem::path folder) {
  std::error_code problem;
  folder = std::filesystem::absolute(folder, problem);
  while (!std::filesystem::exists(folder, problem) && folder.has_relative_path()) {
    folder = folder.parent_path();
  }
  return folder;
}

} // namespace

void checkOutput(Examination& examination) {
  const std::filesystem::path wanted = !examination.options.outputFolder.empty()
                                           ? examination.options.outputFolder
                                           : examination.project.file.parent_path();
  const std::filesystem::path folder = existingFolder(wanted.empty() ? "." : wanted);
  if (::access(folder.c_str(), W_OK) != 0) {
    examination.addForFile(folder.string(), FindingKind::FolderUnwritable, {});
    return;
  }
  std::error_code problem;
  const auto space = std::filesystem::space(folder, problem);
  if (problem) {
    return; // the system does not say
  }
  const auto free = static_cast<double>(space.available);
  const FindingKind kind = free < kFullDiskBytes  ? FindingKind::DiskFull
                           : free < kLowDiskBytes ? FindingKind::DiskNearlyFull
                                                  : FindingKind::DiskFine;
  const double unit = kind == FindingKind::DiskFull ? kMegabyte : kGigabyte;
  examination.addForFile(folder.string(), kind, {fmt::format("{:.1f}", free / unit)});
}

} // namespace dewpoint::setup
