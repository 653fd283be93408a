// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT

#include "sweepkit/scene/values_table.hpp"

#include <gtest/gtest.h>

#include "scene_text.hpp"

namespace sweepkit::scene {
namespace {

ValuesTable table_of(const std::string& text) {
  return parse_values_table(text, "t.csv");
}

template <class Work>
std::string fault(Work&& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string fault_of_table(const std::string& text) {
  return fault([&] { table_of(text); });
}

// "text@line:column", a cell each.
std::vector<std::string> cells(const ValuesTable::Row& row) {
  std::vector<std::string> all;
  for (const auto& cell : row) {
    all.push_back(cell.text + '@' + std::to_string(cell.line) + ':' + std::to_string(cell.column));
  }
  return all;
}
using Cells = std::vector<std::string>;

TEST(ValuesTable, EveryCellKnowsItsPlace) {
  const ValuesTable table = table_of("/a,/b\n1,22\n333,4\n");
  EXPECT_EQ(cells(table.pointers), (Cells{"/a@1:1", "/b@1:4"}));
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(cells(table.rows[0]), (Cells{"1@2:1", "22@2:3"}));
  EXPECT_EQ(cells(table.rows[1]), (Cells{"333@3:1", "4@3:5"}));
}

TEST(ValuesTable, QuotedCellsHoldCommasQuotesAndLineBreaks) {
  const ValuesTable table = table_of("/a,/b\n\"[1,2,3]\",\"say \"\"so\"\"\"\n\"two\nlines\",x\ny,z\n");
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_EQ(cells(table.rows[0]), (Cells{"[1,2,3]@2:1", "say \"so\"@2:11"}));
  EXPECT_EQ(cells(table.rows[1]), (Cells{"two\nlines@3:1", "x@4:8"}));
  EXPECT_EQ(cells(table.rows[2]), (Cells{"y@5:1", "z@5:3"}));
}

TEST(ValuesTable, EveryKindOfLineEndAByteOrderMarkAndEmptyLinesReadTheSame) {
  const Cells second = {"5@3:1", "6@3:3"};
  for (const char* end : {"\n", "\r\n", "\r"}) {
    const std::string e = end;
    for (const std::string& last : {e, std::string()}) {
      const ValuesTable table = table_of("\xEF\xBB\xBF/a,/b" + e + "1,2" + e + "5,6" + last);
      EXPECT_EQ(cells(table.pointers), (Cells{"/a@1:1", "/b@1:4"}));
      ASSERT_EQ(table.rows.size(), 2u);
      EXPECT_EQ(cells(table.rows[1]), second);
    }
    const ValuesTable spaced = table_of("/a,/b" + e + e + "5,6" + e + "  " + e + "7,8" + e + e);
    ASSERT_EQ(spaced.rows.size(), 2u);
    EXPECT_EQ(cells(spaced.rows[0]), second);
    EXPECT_EQ(cells(spaced.rows[1]), (Cells{"7@5:1", "8@5:3"}));
  }
}

TEST(ValuesTable, BlanksRoundACellDoNotCountButThoseInQuotesDo) {
  const ValuesTable table = table_of("/a , /b\n 1 ,\t\" 2 \" \n");
  EXPECT_EQ(cells(table.pointers), (Cells{"/a@1:1", "/b@1:6"}));
  EXPECT_EQ(cells(table.rows[0]), (Cells{"1@2:2", " 2 @2:6"}));
}

TEST(ValuesTable, ALongTableIsReadWhole) {
  std::string text = "/a,/b\n";
  for (int i = 0; i < 5000; ++i) text += std::to_string(i) + ",\"" + std::to_string(i) + ",\n\"\n";
  const ValuesTable table = table_of(text);
  ASSERT_EQ(table.rows.size(), 5000u);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    ASSERT_EQ(table.rows[i][0].text, std::to_string(i));
    ASSERT_EQ(table.rows[i][1].text, std::to_string(i) + ",\n");
    ASSERT_EQ(table.rows[i][0].line, static_cast<int>(2 + 2 * i)) << "each row takes two lines";
  }
}

TEST(ValuesTable, WhatIsNoTableIsRefusedWithItsPlace) {
  EXPECT_EQ(fault_of_table(""),
            "t.csv: is empty; needs a row of JSON pointers, then a row of values for each file");
  EXPECT_EQ(fault_of_table("\n \r\n"), fault_of_table(""));
  EXPECT_EQ(fault_of_table("/a,/b\n"), "t.csv: has no row of values below its header; add one for each file");
  EXPECT_EQ(fault_of_table("/a,,/b\n1,2,3\n"),
            "t.csv:1:4: column 2 needs a JSON pointer above it, such as /objects/0/name");
  EXPECT_EQ(fault_of_table("/a,/b,/a\n1,2,3\n"),
            "t.csv:1:7: the pointer /a stands above column 1 too; leave one out");
  const std::string ragged =
      "; put a cell that holds a comma in quotes, and leave a cell empty for the scene's value";
  EXPECT_EQ(fault_of_table("/a,/b\n1,2\n[1,2],3\n"),
            "t.csv:3:1: has 3 cells where the header has 2" + ragged);
  EXPECT_EQ(fault_of_table("/a,/b\n1,2\n3\n"), "t.csv:3:1: has 1 cell where the header has 2" + ragged);
  const std::string quote =
      "a quote stands astray in this cell; put the whole cell in quotes and double the quotes inside";
  EXPECT_EQ(fault_of_table("/a,/b\n1,say \"so\"\n"), "t.csv:2:3: " + quote);
  EXPECT_EQ(fault_of_table("/a,/b\n1,\"2\"3\n"), "t.csv:2:3: " + quote);
  EXPECT_EQ(fault_of_table("/a,/b\n1,2\n3,\"4\n5,6\n"), "t.csv:3:3: " + quote) << "the quote that has no end";
  EXPECT_EQ(fault_of_table(std::string("/\0a\0", 4)),
            "t.csv: is no UTF-8 text; save it as comma-separated values in UTF-8");
  EXPECT_EQ(fault([] { read_values_table("/none.csv"); }), "/none.csv: no such file");
  EXPECT_EQ(fault([] { read_values_table("/"); }), "/: is a folder, not a table of values");
}

TEST(ValuesTable, EveryTruncatedPrefixIsATableOrIsRefused) {
  const std::string text = "\xEF\xBB\xBF/a,\"/b\"\r\n\"[1,2]\",\" x\"\r\n,\"\"\"\"\r\n";
  for (std::size_t length = 0; length < text.size(); ++length) {
    const std::string prefix = text.substr(0, length);
    const std::string problem = fault_of_table(prefix);
    if (!problem.empty()) continue;
    for (const auto& row : table_of(prefix).rows) EXPECT_EQ(row.size(), 2u) << length;
  }
  EXPECT_EQ(fault_of_table(text), "");
}

TEST(ValuesTable, ARowSetsItsFilledCellsFromLeftToRight) {
  const ValuesTable table = table_of("/a,/b,/c\n1,,x\n");
  const std::vector<Setting> settings = settings_of(table, table.rows[0]);
  ASSERT_EQ(settings.size(), 2u);
  EXPECT_EQ(settings[0].pointer, "/a");
  EXPECT_EQ(settings[0].value, "1");
  EXPECT_EQ(settings[1].pointer, "/c");
  EXPECT_EQ(to_prefix(settings[1].place), "t.csv:2:4: ");
  EXPECT_EQ(to_prefix(settings[1].pointer_place), "t.csv:1:7: ");
}

TEST(ValuesTable, PointersAreCheckedAgainstTheSceneButForThoseThatARowMakesWayFor) {
  const SceneFile scene(scene_text(R"("depth": 2)"), "s.json");
  const auto check = [&](const std::string& text) {
    return fault([&] { check_pointers(table_of(text), scene); });
  };
  EXPECT_EQ(check("/depth,/objects/0/name\n3,x\n"), "");
  EXPECT_EQ(check("/camera,/camera/width\n{},9\n"), "");
  EXPECT_EQ(check("/depth,/camera/width\n3,9\n"),
            "t.csv:1:8: /camera/width: there is no \"camera\" in the scene; set that first");
  EXPECT_EQ(check("/depth,/objects/0/nam\n3,\n3,x\n"),
            "t.csv:1:8: /objects/0/nam: unknown key \"nam\"; did you mean \"name\"?");
  EXPECT_EQ(check("/depth\nmany\n"), "") << "the row's fault, not the pointer's";
}

}  // namespace
}  // namespace sweepkit::scene
