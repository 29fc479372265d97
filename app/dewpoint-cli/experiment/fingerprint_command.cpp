// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/experiment/experiment_commands.h"
#include "core/experiment/baselines/baseline_methods.h"
#include "core/experiment/boxes/box_follower.h"
#include "core/experiment/studies/box_fingerprint.h"
#include "core/experiment/studies/people_fingerprint.h"
#include "core/experiment/suite/suite_fingerprint.h"
#include "core/tracking/catalog/method_catalog.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace dewpoint::app {
namespace {

using Fingerprints = std::map<std::string, std::string>;
using Compute = Result<Fingerprints> (*)(const std::vector<std::string>& methods);

/// Methods of which a fingerprint is computed in the same way.
struct MethodGroup {
  std::vector<std::string> methods;
  Compute compute;
};

std::vector<MethodGroup> methodGroups() {
  return {{suiteMethods(), suiteFingerprints},
          {boxFollowerNames(), boxFingerprints},
          {methodNames(TargetSource::Images), peopleFingerprints}};
}

/// Those of `known` that are wanted; all for none.
std::vector<std::string> chosenOf(const std::vector<std::string>& known,
                                  const std::vector<std::string>& wanted) {
  std::vector<std::string> chosen;
  std::ranges::copy_if(known, std::back_inserter(chosen), [&](const std::string& method) {
    return wanted.empty() || std::ranges::find(wanted, method) != wanted.end();
  });
  return chosen;
}

/// Prints what `compute` says of the methods, in their order; nothing for none.
Status printFingerprints(const std::vector<std::string>& methods, Compute compute) {
  if (methods.empty()) {
    return {};
  }
  return compute(methods).map([&](const Fingerprints& found) {
    for (const std::string& method : methods) {
      fmt::print("{},{}\n", method, found.at(method));
    }
  });
}

int showFingerprints(const std::vector<std::string>& wanted) {
  fmt::print("method,fingerprint\n");
  for (const MethodGroup& group : methodGroups()) {
    const auto printed = printFingerprints(chosenOf(group.methods, wanted), group.compute);
    if (!printed) {
      return reportError(printed.error());
    }
  }
  return kExitDone;
}

} // namespace

void addFingerprintCommand(CLI::App& group, int& exitCode) {
  auto* command = group.add_subcommand(
      "fingerprint",
      "Print a checksum of the results of each method on a few short, fixed runs, as CSV.");
  std::vector<std::string> known;
  for (const MethodGroup& each : methodGroups()) {
    std::ranges::copy(each.methods, std::back_inserter(known));
  }
  auto wanted = std::make_shared<std::vector<std::string>>();
  command->add_option("--method", *wanted, "Method; all if omitted")
      ->delimiter(',')
      ->check(CLI::IsMember(known));
  command->callback([wanted, &exitCode] { exitCode = showFingerprints(*wanted); });
}

} // namespace dewpoint::app
