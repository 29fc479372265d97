// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_load.h"
#include "core/project/project_save.h"
#include "tests/fuzz/expectation.h"
#include "tests/fuzz/fuzzed_readers.h"
#include "tests/fuzz/input_file.h"

namespace dewpoint::tests {

void fuzzProject(std::string_view bytes) {
  static const InputFile kFile("project.toml");
  const auto project = loadProject(kFile.hold(bytes));
  if (!project) {
    expectPlain(project.error());
    return;
  }
  (void)project::effectiveParameters(*project);
  const auto again = loadProject(kFile.hold(projectText(*project, inputFolder())));
  if (!again) {
    expectPlain(again.error());
  }
  expect(again && *again == *project, "a project that was read is another one when saved");
}

} // namespace dewpoint::tests
