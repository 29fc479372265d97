// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/evaluation.h"
#include "core/trajectory/export/export_table.h"
#include "core/trajectory/trajectory_reader.h"
#include "tests/fuzz/expectation.h"
#include "tests/fuzz/fuzzed_readers.h"
#include "tests/fuzz/input_file.h"

namespace dewpoint::tests {
namespace {

/// Meters within which an estimate is on its target.
constexpr double kGate = 0.03;

void expectPlainOf(Error error) {
  error.file = "trajectory.csv"; // named by who asked
  expectPlain(error);
}

} // namespace

void fuzzTrajectory(std::string_view bytes) {
  static const InputFile kFile("trajectory.csv");
  const auto read = readTrajectory(kFile.hold(bytes));
  if (!read) {
    expectPlain(read.error());
    return;
  }
  if (const auto evaluated = trajectory::evaluate(*read, *read, kGate); !evaluated) {
    expectPlainOf(evaluated.error());
  }
  ExportOptions options;
  options.gapRule = GapRule::Fill;
  if (const auto table = makeExportTable(*read, options, {}); !table) {
    expectPlainOf(table.error());
  }
}

} // namespace dewpoint::tests
