// SPDX-License-Identifier: GPL-3.0-or-later
// The first argument names the test, the others are QTest's: dewpoint_ui_test plots -v2 aFunction.
#include "tests/ui/window_test.h"

#include <cstdio>

namespace dewpoint::tests::test {

std::map<std::string_view, NamedTest>& namedTests() {
  static std::map<std::string_view, NamedTest> tests; // made by the first test that is added
  return tests;
}

AddedTest::AddedTest(const char* file, TestMain run) {
  std::string_view name(file);
  name.remove_prefix(name.rfind('/') + 1);
  name.remove_suffix(std::string_view("_test.cpp").size());
  namedTests()[name] = {file, run};
}

void nameApplication(const QString& name) {
  QCoreApplication::setOrganizationName(QStringLiteral("dewpoint-test"));
  QCoreApplication::setApplicationName(name);
}

} // namespace dewpoint::tests::test

int main(int argc, char** argv) {
  const auto& tests = dewpoint::tests::test::namedTests();
  const auto chosen = argc > 1 ? tests.find(argv[1]) : tests.end();
  if (chosen == tests.end()) {
    for (const auto& [name, test] : tests) {
      std::printf("%.*s\n", static_cast<int>(name.size()), name.data());
    }
    return argc > 1 ? 2 : 0;
  }
  const QString name = QString::fromLocal8Bit(argv[1]);
  argv[1] = argv[0];
  QTest::setMainSourcePath(chosen->second.file); // where QFINDTESTDATA looks
  return chosen->second.run(argc - 1, argv + 1, name);
}
