// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the tables of the documentation are of today's methods.
#include "core/base/text_file.h"
#include "core/experiment/baselines/baseline_methods.h"
#include "core/experiment/studies/box_fingerprint.h"
#include "core/experiment/studies/people_fingerprint.h"
#include "core/experiment/suite/suite_fingerprint.h"
#include "core/tracking/catalog/method_catalog.h"
#include "tests/experiment/report/table_states.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

namespace dewpoint::tests {
namespace {

/// The pages whose tables script/figures writes.
const std::vector<TableState>& documentedTables() {
  static const std::vector<TableState> all = [] {
    std::vector<TableState> tables;
    for (const char* file : {"docs/accuracy.md", "docs/people.md", "docs/fidelity.md"}) {
      const auto page = readTextFile(std::filesystem::path(DEWPOINT_SOURCE_DIR) / file);
      const auto found = tableStates(file, page.value_or(""));
      tables.insert(tables.end(), found.begin(), found.end());
    }
    return tables;
  }();
  return all;
}

/// Those of `known` that a table is of.
std::vector<std::string> documentedMethods(const std::vector<std::string>& known) {
  std::set<std::string> named;
  for (const TableState& table : documentedTables()) {
    for (const auto& [method, fingerprint] : table.fingerprints) {
      named.insert(method);
    }
  }
  std::vector<std::string> methods;
  std::ranges::copy_if(known, std::back_inserter(methods),
                       [&](const std::string& method) { return named.contains(method); });
  return methods;
}

TEST(TableStates, TablesAreOfTodaysMethods) {
  std::map<std::string, std::string> today;
  using Compute = Result<std::map<std::string, std::string>> (*)(const std::vector<std::string>&);
  const std::vector<std::pair<std::vector<std::string>, Compute>> kinds{
      {suiteMethods(), suiteFingerprints},
      {methodNames(TargetsFrom::Box), boxFingerprints},
      {methodNames(TargetsFrom::Images), peopleFingerprints}};
  for (const auto& [known, compute] : kinds) {
    const auto methods = documentedMethods(known);
    if (methods.empty()) {
      continue;
    }
    const auto found = compute(methods);
    ASSERT_TRUE(found) << sentence(found.error());
    today.insert(found->begin(), found->end());
  }
  for (const TableState& table : documentedTables()) {
    const auto stale = staleness(table, today);
    EXPECT_FALSE(stale) << *stale;
  }
}

/// Each table by itself, so that those of an older state are reported by name.
class DocumentedTable : public testing::TestWithParam<TableState> {};

TEST_P(DocumentedTable, SaysWhatItIsOf) {
  const TableState& table = GetParam();
  ASSERT_TRUE(table.ended) << table.file << ": the end of the table '" << table.name
                           << "' is not marked";
  ASSERT_FALSE(table.commit.empty()) << table.file << ": no line above the table '" << table.name
                                     << "' names its commit, seeds and state";
  EXPECT_FALSE(table.commit.ends_with("-dirty"))
      << table.file << ": the table '" << table.name << "' is of sources that were never committed";
  if (table.older) {
    GTEST_SKIP() << table.file << ": the table '" << table.name << "' is of an older state (commit "
                 << table.commit << "): run script/figures --write";
  }
}

INSTANTIATE_TEST_SUITE_P(Pages, DocumentedTable, testing::ValuesIn(documentedTables()),
                         [](const auto& test) {
                           std::string name =
                               std::filesystem::path(test.param.file).stem().string() + "_" +
                               test.param.name;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

constexpr const char* kPage = R"(# A page

<!-- table: clean -->
Commit `abc1234`; seeds 1005001 to 1005020; state `dewpoint` 1a2b3c4d, `triangulation-kalman` 00000001.

| a | b |
| --- | --- |
| 1 | 2 |
<!-- /table -->

<!-- table: before -->
Commit `abc1234`; seeds 1 to 30; state older.
<!-- /table -->
<!-- table: speed -->
Commit `abc1234`; seeds 1; state not compared.
<!-- /table -->
<!-- table: nothing -->
Commit `abc1234`; seeds 1 to 30; state of mind.
)";

TEST(TableStates, AreReadFromAPage) {
  const auto tables = tableStates("page.md", kPage);
  ASSERT_EQ(tables.size(), 4U);
  EXPECT_EQ(tables[0].name, "clean");
  EXPECT_EQ(tables[0].commit, "abc1234");
  EXPECT_EQ(tables[0].seeds, "1005001 to 1005020");
  EXPECT_EQ(tables[0].fingerprints,
            (std::map<std::string, std::string>{{"dewpoint", "1a2b3c4d"},
                                                {"triangulation-kalman", "00000001"}}));
  EXPECT_FALSE(tables[0].older);
  EXPECT_TRUE(tables[0].ended);
  EXPECT_TRUE(tables[1].older);
  EXPECT_FALSE(tables[2].older);
  EXPECT_FALSE(tables[2].compared);
  EXPECT_TRUE(tables[3].commit.empty()) << "the line names no state";
  EXPECT_FALSE(tables[3].ended);
}

TEST(TableStates, AnotherStateIsNamedInOneSentence) {
  const TableState table = tableStates("docs/page.md", kPage).front();
  EXPECT_FALSE(staleness(table, {{"dewpoint", "1a2b3c4d"}, {"triangulation-kalman", "00000001"}}));
  EXPECT_EQ(*staleness(table, {{"dewpoint", "ffffffff"}, {"triangulation-kalman", "00000001"}}),
            "docs/page.md: the table 'clean' is of another state of method dewpoint (1a2b3c4d, "
            "today's is ffffffff): run script/figures --write");
  EXPECT_EQ(*staleness(table, {{"dewpoint", "1a2b3c4d"}}),
            "docs/page.md: the table 'clean' is of method triangulation-kalman, which does not "
            "exist any more: run script/figures");
}

// The first pages that are read must have tables: a test of none would be worth nothing.
TEST(TableStates, EveryPageHasTables) {
  for (const char* file : {"docs/accuracy.md", "docs/people.md", "docs/fidelity.md"}) {
    EXPECT_TRUE(std::ranges::any_of(documentedTables(), [&](const TableState& table) {
      return table.file == file;
    })) << file;
  }
}

} // namespace
} // namespace dewpoint::tests
