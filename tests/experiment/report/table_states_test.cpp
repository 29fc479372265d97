// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the tables of the documentation are of today's methods.
#include "core/base/text_file.h"
#include "core/experiment/baselines/baseline_methods.h"
#include "core/experiment/boxes/box_follower.h"
#include "core/experiment/report/seed_blocks.h"
#include "core/experiment/studies/box_fingerprint.h"
#include "core/experiment/studies/people_fingerprint.h"
#include "core/experiment/suite/suite_fingerprint.h"
#include "core/tracking/catalog/method_catalog.h"
#include "tests/experiment/report/table_states.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <string_view>
#include <utility>

namespace dewpoint::tests {
namespace {

/// The pages whose tables script/figures writes.
constexpr std::array<const char*, 5> kPages{"docs/accuracy.md", "docs/measurements-people.md",
                                            "docs/fidelity.md", "docs/measurements-dewpoint.md",
                                            "docs/method-sugandi.md"};
/// Tables of times, and those that no method has a part in.
constexpr std::array<std::string_view, 3> kNotCompared{"people-speed", "lazy-color", "cone"};

std::string documentText(const std::string& file) {
  return readTextFile(std::filesystem::path(DEWPOINT_SOURCE_DIR) / file).value_or("");
}

const std::vector<TableState>& documentedTables() {
  static const std::vector<TableState> all = [] {
    std::vector<TableState> tables;
    for (const char* file : kPages) {
      const auto found = tableStates(file, documentText(file));
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
      {boxFollowerNames(), boxFingerprints},
      {methodNames(TargetSource::Images), peopleFingerprints}};
  for (const auto& [known, compute] : kinds) {
    const auto methods = documentedMethods(known);
    if (methods.empty()) {
      continue;
    }
    const auto found = compute(methods);
    ASSERT_TRUE(found) << errorSentence(found.error());
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
    ASSERT_TRUE(saysNotMade(documentText(table.file)))
        << table.file << ": the table '" << table.name
        << "' is of an older state, and the page does not say: " << kNotMade;
    GTEST_SKIP() << table.file << ": the table '" << table.name << "' is of an older state (commit "
                 << table.commit << "), as its page says: run script/figures";
  }
  if (!table.compared) {
    EXPECT_NE(std::ranges::find(kNotCompared, table.name), kNotCompared.end())
        << table.file << ": the table '" << table.name << "' names no state of any method";
    EXPECT_TRUE(std::ranges::any_of(documentedTables(),
                                    [&](const TableState& other) {
                                      return !other.fingerprints.empty() &&
                                             other.commit == table.commit;
                                    }))
        << table.file << ": the table '" << table.name
        << "' was not made with any table of a method's state";
    return;
  }
  EXPECT_TRUE(areReportingSeeds(namedSeeds(table.seeds)))
      << table.file << ": the table '" << table.name << "' is of seeds " << table.seeds
      << ", not of the reporting block: run script/figures";
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
Commit `abc1234`; seeds 1006001 to 1006020; state `dewpoint` 1a2b3c4d, `triangulation-kalman` 00000001.

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
  EXPECT_EQ(tables[0].seeds, "1006001 to 1006020");
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
            "today's is ffffffff): run script/figures");
  EXPECT_EQ(*staleness(table, {{"dewpoint", "1a2b3c4d"}}),
            "docs/page.md: the table 'clean' is of method triangulation-kalman, which does not "
            "exist any more: run script/figures");
}

// Once all tables of a page have been made it must not say that some have not.
TEST(TableStates, APageSaysOnlyAsLongAsItIsTrueThatTablesAreNotMade) {
  for (const char* file : kPages) {
    const bool anyOlder = std::ranges::any_of(documentedTables(), [&](const TableState& table) {
      return table.file == file && table.older;
    });
    EXPECT_EQ(saysNotMade(documentText(file)), anyOlder) << file;
  }
}

TEST(TableStates, APageSaysInAParagraphThatTablesAreNotMade) {
  EXPECT_TRUE(saysNotMade(std::string("# A page\n\n") + kNotMade + "\n"));
  EXPECT_FALSE(saysNotMade(kPage));
  EXPECT_FALSE(saysNotMade(std::string("It is not true: ") + kNotMade + "\n"));
}

TEST(TableStates, SeedsAreReadFromTheLine) {
  EXPECT_EQ(namedSeeds("1006001 to 1006020"), (std::vector<std::uint64_t>{1006001, 1006020}));
  EXPECT_EQ(namedSeeds("1006001"), (std::vector<std::uint64_t>{1006001, 1006001}));
  EXPECT_TRUE(namedSeeds("none").empty());
  EXPECT_TRUE(namedSeeds("1 to many").empty());
  EXPECT_TRUE(namedSeeds("from 7700001 on").empty());
}

// A line that a part of is not a state would hide a method.
TEST(TableStates, EveryPartOfALineIsAState) {
  TableState table;
  EXPECT_FALSE(
      readState("Commit `abc1234`; seeds 1; state `dewpoint` 1a2b3c4d, `csrt` none.", table));
  EXPECT_FALSE(readState("Commit `abc1234`; seeds 1; state `dewpoint` 1a2b3c4d, barrera.", table));
  EXPECT_TRUE(readState("Commit `abc1234`; seeds 1; state `a` 1a2b3c4d, `b` 00000001.", table));
}

// The first pages that are read must have tables: a test of none would be worth nothing.
TEST(TableStates, EveryPageHasTables) {
  for (const char* file : kPages) {
    EXPECT_TRUE(std::ranges::any_of(documentedTables(), [&](const TableState& table) {
      return table.file == file;
    })) << file;
  }
}

} // namespace
} // namespace dewpoint::tests
