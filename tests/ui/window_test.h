// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QApplication>
#include <QCoreApplication>
#include <QString>
#include <QTest>

#include <map>
#include <string_view>

namespace dewpoint::tests::test {

/// Main function of one test: makes the application and runs a test class in it. `argv` has the
/// program and QTest's arguments.
using TestMain = int (*)(int argc, char** argv, const QString& name);

struct NamedTest {
  const char* file = ""; ///< source, as the compiler was given it
  TestMain run = nullptr;
};

/// Tests of this program by name, `plots` for that of plots_test.cpp.
std::map<std::string_view, NamedTest>& namedTests();

/// Adds a test to namedTests(), under the name of its file.
struct AddedTest {
  AddedTest(const char* file, TestMain run);
};

/// Makes what a program of window tests needs before its QApplication.
void prepareApplication();
/// Gives a test settings of its own.
void nameApplication(const QString& name);

/// Runs a test class in an application with windows.
template <class Test> int runWindowTest(int argc, char** argv, const QString& name) {
  prepareApplication();
  QApplication application(argc, argv);
  nameApplication(name);
  Test test;
  return QTest::qExec(&test, argc, argv);
}

/// Runs a test class in an application without windows.
template <class Test> int runCoreTest(int argc, char** argv, const QString& name) {
  QCoreApplication application(argc, argv);
  nameApplication(name);
  Test test;
  return QTest::qExec(&test, argc, argv);
}

} // namespace dewpoint::tests::test

/// Makes a class a test of the program, with a main function of its own; in dewpoint::tests.
#define DEWPOINT_NAMED_TEST(Test, run)                                                             \
  namespace {                                                                                      \
  const test::AddedTest kAdded##Test(__FILE__, run);                                               \
  }
#define DEWPOINT_WINDOW_TEST(Test) DEWPOINT_NAMED_TEST(Test, &test::runWindowTest<Test>)
#define DEWPOINT_CORE_TEST(Test) DEWPOINT_NAMED_TEST(Test, &test::runCoreTest<Test>)
