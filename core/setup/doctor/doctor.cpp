// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/doctor/doctor.h"

#include "core/setup/doctor/agreement_checks.h"
#include "core/setup/doctor/calibration_checks.h"
#include "core/setup/doctor/method_checks.h"
#include "core/setup/doctor/output_checks.h"
#include "core/setup/doctor/recording_checks.h"
#include "core/setup/doctor/target_checks.h"
#include "core/setup/doctor/time_checks.h"
#include "core/setup/missing_files.h"

#include <array>

namespace dewpoint::setup {
namespace {

/// The groups of checks in their order: each goes by what those before it have found.
constexpr std::array kExaminations{&checkRecordings, &checkTimes,  &checkCalibration,
                                   &checkTargets,    &checkMethod, &checkAgreement,
                                   &checkOutput};

} // namespace

std::vector<Finding> examine(const Project& project, const ExaminationOptions& options) {
  Examination examination(project, options);
  examination.add(FindingKind::ProjectRead, {});
  for (const auto& check : kExaminations) {
    check(examination);
  }
  return std::move(examination.findings);
}

std::vector<Finding> examineUnreadableProject(const std::filesystem::path& file,
                                              const Error& error) {
  std::string reason = error.field.empty() ? "" : error.field + ": ";
  reason += errorPhrase(error.code);
  reason += error.detail.empty() ? "" : " (" + error.detail + ")";
  std::vector<Finding> findings{
      {FindingKind::ProjectUnreadable, {reason}, error.file.empty() ? file.string() : error.file}};
  if (const auto missing = missingFilesOf(file)) {
    for (const MissingFile& one : *missing) {
      const std::string field =
          one.camera >= 0 ? cameraKey(static_cast<std::size_t>(one.camera), "") : std::string();
      findings.push_back({FindingKind::FileMissing,
                          {one.path.string()},
                          file.string(),
                          field.substr(0, field.find('.'))});
    }
  }
  return findings;
}

} // namespace dewpoint::setup
